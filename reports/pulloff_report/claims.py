"""Reads the judged claims of the paper (reports/claims/README.md), if there are any."""

import json
import os

from .errors import ReportError
from .records import NUMBER, demand, read_judgement
from .words import CLAIM_VERDICTS

SCHEMA = "pulloff-claims/1"
PLACE = os.path.join("claims", "claims.json")  # beside the run's folder

TEXT = (str, type(None))
BOOK = {"claims": list, "counts": dict, "readings": dict}
CLAIM = {"id": str, "where": str, "says": str, "verdict": str, "low": NUMBER, "high": NUMBER, "computed": NUMBER,
         "difference": NUMBER, "accuracy": NUMBER, "claimed": TEXT, "reading": TEXT, "accuracy_because": TEXT,
         "note": TEXT, "reason": TEXT, "commands": list}


def beside(run):
    """Where the claims judged by a run are."""
    return os.path.join(os.path.dirname(os.path.abspath(run)), PLACE)


def read(path):
    """The judged claims, or None when there is no such file."""
    judged = read_judgement(path, SCHEMA)
    if judged is None:
        return None
    demand(judged, BOOK, path, "")
    for place, claim in enumerate(judged["claims"]):
        demand(claim, CLAIM, path, f"claims[{place}]")
        if claim["verdict"] not in CLAIM_VERDICTS:
            raise ReportError(f"{path}: claims[{place}].verdict is {json.dumps(claim['verdict'])}, expected one of "
                              + ", ".join(CLAIM_VERDICTS))
    return judged
