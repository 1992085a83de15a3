"""Reads the judgement of the published table of viscoelastic pull-offs (see reports/rate/judge.py)."""

import os

from .records import demand, read_judgement

SCHEMA = "pulloff-rate/1"
PLACE = os.path.join("rate", "table.json")  # beside the run's folder

NUMBER = (int, float)
DOCUMENT = {"rows": int, "solved": int, "off": int, "limits": list, "all": dict, "causes": dict, "none_shown_beyond": list,
            "by_radius": list, "by_way": list, "by_speed": list, "seconds": dict, "worst": list}
SHARES = {"rows": int, "within": list, "median": NUMBER, "least": NUMBER, "greatest": NUMBER}
WORST = {"file": str, "line": int, "table": NUMBER, "ours": NUMBER, "error": NUMBER, "difference": NUMBER, "cause": str,
         "runload": str, "alphaload": str, "mu": str, "k": str, "n": str}


def beside(run):
    """The path of the document that belongs to a run."""
    return os.path.join(os.path.dirname(os.path.abspath(run)), PLACE)


def read(path):
    """The document, or None when there is no such file or no row was solved."""
    document = read_judgement(path, SCHEMA)
    if document is None or not document.get("solved"):
        return None
    demand(document, DOCUMENT, path, "")
    demand(document["all"], SHARES, path, "all")
    for name in ("by_radius", "by_way", "by_speed"):
        for place, of in enumerate(document[name]):
            demand(of, SHARES | {"from": NUMBER, "to": NUMBER}, path, f"{name}[{place}]")
    for name, of in document["causes"].items():
        demand(of, {"rows": int, "above": int} | (SHARES if of.get("rows") else {}), path, f"causes.{name}")
    for place, row in enumerate(document["worst"]):
        demand(row, WORST, path, f"worst[{place}]")
    return document
