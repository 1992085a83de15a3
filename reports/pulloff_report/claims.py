"""Reads the judged claims of the paper (see reports/claims/README.md)."""

import json
import os

from .errors import ReportError
from .records import NUMBER, demand, read_judgement
from .words import CHECK_VERDICTS, CHOICE_WORDS, CLAIM_VERDICTS, SENTENCE_VERDICTS

SCHEMA = "pulloff-claims/5"
PLACE = os.path.join("claims", "claims.json")  # beside the run's folder

TEXT = (str, type(None))
BOOK = {"claims": list, "counts": dict, "readings": dict, "preloads": list, "robust": dict, "surveys": list,
        "common": (dict, type(None)), "sentences": list}
ROBUST = {"table": list, "holds_always": int, "moved": int, "statements": int}
CELL = {"scale": str, "preload": (int, type(None)), "holds": int, "depends": int, "contradicted": int}
SURVEY = {"id": str, "figure": str, "words": str, "claimed": NUMBER, "tried": list}
TRIED = {"words": str, "approach": NUMBER, "computed": NUMBER, "holds": dict}
COMMON = {"half": list, "once": list, "twice": list, "tried": int, "nearest": str, "difference": NUMBER, "numbers": list}
SENTENCE = {"where": str, "quote": str, "words": str, "verdict": str, "entries": list, "failing": list, "convention": list}
FAILING = {"id": str, "words": list}
CLAIM = {"id": str, "where": str, "quotes": list, "implied": bool, "tests": str, "verdict": str, "choices": list,
         "reading": TEXT, "accuracy_because": TEXT, "brief": TEXT, "weight": (int, type(None)), "reply": TEXT, "note": TEXT, "survives": TEXT, "reason": TEXT,
         "figure": bool, "decided": bool, "change": (dict, type(None)),
         "faults": list, "solvers": list}
SOLVER = {"name": str, "verdict": str, "computed": NUMBER}
CHOICE = {"words": TEXT, "own": TEXT, "preload": (int, type(None)), "reading": TEXT, "verdict": str, "low": NUMBER, "high": NUMBER, "computed": NUMBER, "difference": NUMBER,
          "accuracy": NUMBER, "decided": bool, "claimed": TEXT, "commands": list}
CHANGE = {"words": str, "computed": NUMBER, "verdict": str, "moved": bool}
PRELOAD = {"figures": str, "because": str, "words": list}


def beside(run):
    """The path of the claims that were judged with a run."""
    return os.path.join(os.path.dirname(os.path.abspath(run)), PLACE)


def demand_verdict(entry, known, where):
    if entry["verdict"] not in known:
        raise ReportError(f"{where}.verdict is {json.dumps(entry['verdict'])}, expected one of " + ", ".join(known))


def demand_summary(judged, path):
    """Checks what follows from the judged claims as a whole."""
    demand(judged["robust"], ROBUST, path, "robust")
    for place, cell in enumerate(judged["robust"]["table"]):
        demand(cell, CELL, path, f"robust.table[{place}]")
    if judged["common"]:
        demand(judged["common"], COMMON, path, "common")
    for place, survey in enumerate(judged["surveys"]):
        demand(survey, SURVEY, path, f"surveys[{place}]")
        for number, tried in enumerate(survey["tried"]):
            demand(tried, TRIED, path, f"surveys[{place}].tried[{number}]")
    for place, sentence in enumerate(judged["sentences"]):
        demand(sentence, SENTENCE, path, f"sentences[{place}]")
        demand_verdict(sentence, SENTENCE_VERDICTS, f"{path}: sentences[{place}]")
        for number, failing in enumerate(sentence["failing"]):
            demand(failing, FAILING, path, f"sentences[{place}].failing[{number}]")


def read(path):
    """The judged claims, or None when there is no such file."""
    judged = read_judgement(path, SCHEMA)
    if judged is None:
        return None
    demand(judged, BOOK, path, "")
    for place, preload in enumerate(judged["preloads"]):
        demand(preload, PRELOAD, path, f"preloads[{place}]")
    demand_summary(judged, path)
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
    """The statements that the first page names, the weighty ones first."""
    found = [claim for claim in judged["claims"] if claim["verdict"] == "contradicted"] if judged else []
    return sorted(found, key=lambda claim: claim["weight"] or len(found) + 1)
