"""Reads the judged claims of the paper (see reports/claims/README.md)."""

import json
import os

from .errors import ReportError
from .records import NUMBER, demand, read_judgement
from .words import CHECK_VERDICTS, CHOICE_WORDS, CLAIM_VERDICTS

SCHEMA = "pulloff-claims/4"
PLACE = os.path.join("claims", "claims.json")  # beside the run's folder

TEXT = (str, type(None))
BOOK = {"claims": list, "counts": dict, "readings": dict, "preloads": list}
CLAIM = {"id": str, "where": str, "quotes": list, "implied": bool, "tests": str, "verdict": str, "choices": list,
         "reading": TEXT, "accuracy_because": TEXT, "brief": TEXT, "note": TEXT, "survives": TEXT, "reason": TEXT,
         "figure": bool, "decided": bool, "change": (dict, type(None)),
         "faults": list, "solvers": list}
SOLVER = {"name": str, "verdict": str, "computed": NUMBER}
CHOICE = {"words": TEXT, "verdict": str, "low": NUMBER, "high": NUMBER, "computed": NUMBER, "difference": NUMBER,
          "accuracy": NUMBER, "decided": bool, "claimed": TEXT, "commands": list}
CHANGE = {"words": str, "computed": NUMBER, "verdict": str, "moved": bool}
PRELOAD = {"figures": str, "because": str, "words": list}


def beside(run):
    """The path of the claims that were judged with a run."""
    return os.path.join(os.path.dirname(os.path.abspath(run)), PLACE)


def demand_verdict(entry, known, where):
    if entry["verdict"] not in known:
        raise ReportError(f"{where}.verdict is {json.dumps(entry['verdict'])}, expected one of " + ", ".join(known))


def read(path):
    """The judged claims, or None when there is no such file."""
    judged = read_judgement(path, SCHEMA)
    if judged is None:
        return None
    demand(judged, BOOK, path, "")
    for place, preload in enumerate(judged["preloads"]):
        demand(preload, PRELOAD, path, f"preloads[{place}]")
    for place, claim in enumerate(judged["claims"]):
        demand(claim, CLAIM, path, f"claims[{place}]")
        demand_verdict(claim, {**CLAIM_VERDICTS, **CHECK_VERDICTS}, f"{path}: claims[{place}]")
        for number, solver in enumerate(claim["solvers"]):
            demand(solver, SOLVER, path, f"claims[{place}].solvers[{number}]")
            demand_verdict(solver, {**CLAIM_VERDICTS, **CHECK_VERDICTS}, f"{path}: claims[{place}].solvers[{number}]")
        if claim["change"]:
            demand(claim["change"], CHANGE, path, f"claims[{place}].change")
            demand_verdict(claim["change"], CHOICE_WORDS, f"{path}: claims[{place}].change")
        for number, choice in enumerate(claim["choices"]):
            demand(choice, CHOICE, path, f"claims[{place}].choices[{number}]")
            demand_verdict(choice, CHOICE_WORDS, f"{path}: claims[{place}].choices[{number}]")
    return judged


def of_paper(judged):
    """The claims that are statements of the paper."""
    return [claim for claim in judged["claims"] if claim["verdict"] in CLAIM_VERDICTS]


def contradicted(judged):
    """The statements that the first page names."""
    return [claim for claim in judged["claims"] if claim["verdict"] == "contradicted"] if judged else []
