"""Stiff and extreme scenes: the result, the work and the diagnostics of each."""

from . import Section
from ..plots import extreme
from ..records import PASSING
from ..words import sweep_label

SUITE = "extreme"
ABSENT = ("Stiff and extreme scenes are omitted: this run has no record of the suite extreme "
          "(pulloff run --suite extreme computes them).")


def state_at(diagnostics, place):
    return [state for state in diagnostics.get("states", []) if state["at"] == place]


def greatest(values):
    return max((value for value in values if value is not None), default=None)


def row_of(case, point):
    """The row of one scene."""
    found = point.get("diagnostics") or {}
    moved = found.get("moved") or {}
    judged = [check for check in case.checks if check.get("point") == point["id"]]
    pull_off = state_at(found, "pull_off")
    return {"point": point, "label": sweep_label(point), "failed": point["status"] != "ok",
            "reason": point.get("reason") or point["status"].replace("_", " "),
            "pull_off": point.get("pull_off") or {}, "folds": len(point.get("folds", [])),
            "work": point["work"], "residual": found.get("residual"),
            "condition": pull_off[0]["condition"] if pull_off else None,
            "bordered": greatest(state["bordered_condition"] for state in state_at(found, "fold")),
            "kept": moved.get("digits_kept"), "predicted": moved.get("digits_predicted"),
            "energy": found.get("energy_defect"), "back": found.get("reverse_trace"),
            "passing": sum(check["verdict"] in PASSING for check in judged), "judged": len(judged),
            "failing": [check for check in judged if check["verdict"] not in PASSING]}


def build(source):
    cases = [case for case in source.run.cases if SUITE in case.record["suites"]]
    tables = [{"case": case, "rows": [row_of(case, point) for point in case.points]} for case in cases]
    rows = [row for table in tables for row in table["rows"]]
    data = {"tables": tables, "absent": None if cases else ABSENT, "scenes": len(rows),
            "solved": sum(not row["failed"] for row in rows), "figure": None, "rates": []}
    if cases:
        data["figure"], data["rates"] = extreme.make(cases)
    return Section("extreme", "Stiff and extreme", "extreme.html", data)
