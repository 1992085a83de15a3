"""Scenes at the limits of the parameter ranges, which are hard to compute: the result, the work and the diagnostics of each."""

from markupsafe import Markup

from . import Section
from ..records import PASSING
from ..words import fixed, scientific, seconds, sweep_label

SUITE, DASH = "extreme", "–"
ABSENT = "extreme scenes (pulloff run --suite extreme)"


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


def reverse(row):
    """The cell on the reverse trace: its folds and their difference, or that they differ."""
    back = row["back"]
    if not back:
        return DASH
    if not back["same"]:
        return Markup('<span class="bad">≠ {}</span>').format(back["folds"])
    return Markup("{}, {}").format(back["folds"], scientific(back["excess"])) if back["folds"] else str(back["folds"])


def digits(value):
    return DASH if value is None else f"{value:.1f}"


# The columns of the tables: heading, and the text of a row.
COLUMNS = (("|W̄|", lambda row: fixed(row["pull_off"]["force"], 9)),
           ("± stated", lambda row: Markup('<span class="open">none</span>') if row["pull_off"]["error_estimate"] is None
            else scientific(row["pull_off"]["error_estimate"])),
           ("Δ†", lambda row: fixed(row["pull_off"]["approach"], 5)), ("Folds", lambda row: str(row["folds"])),
           ("Reverse trace", reverse), ("States", lambda row: str(row["work"]["points"])),
           ("Factor- isations", lambda row: str(row["work"]["factorizations"])), ("Nodes", lambda row: str(row["work"]["nodes"])),
           ("Time", lambda row: seconds(row["work"]["seconds"])), ("Residual", lambda row: scientific(row["residual"])),
           ("Condition", lambda row: scientific(row["condition"])), ("Bordered", lambda row: scientific(row["bordered"])),
           ("Digits", lambda row: digits(row["kept"])), ("Pre- dicted", lambda row: digits(row["predicted"])),
           ("Energy defect", lambda row: scientific(row["energy"])))


def table_of(case):
    """The rows of a case, and of the columns those in which any scene has a value."""
    rows = [row_of(case, point) for point in case.points]
    cells = [[text(row) for _, text in COLUMNS] for row in rows if not row["failed"]]
    used = [place for place in range(len(COLUMNS)) if any(line[place] != DASH for line in cells)]
    made = iter(cells)
    for row in rows:
        row["cells"] = None if row["failed"] else [line[place] for line in [next(made)] for place in used]
    return {"case": case, "rows": rows, "heads": [COLUMNS[place][0] for place in used]}


def summary(table):
    """One row for a case: the least favourable value of each column over its scenes."""
    rows = table["rows"]
    stated = [row["pull_off"].get("error_estimate") for row in rows]
    kept = [row["kept"] for row in rows if row["kept"] is not None]
    backs = [row["back"] for row in rows if row["back"]]
    return {"table": table, "solved": sum(not row["failed"] for row in rows), "stated": greatest(stated),
            "unstated": any(value is None for value, row in zip(stated, rows) if not row["failed"]),
            "back": greatest(back["excess"] for back in backs if back["folds"] and back["same"]),
            "differing": sum(not back["same"] for back in backs),
            **{name: greatest(row[name] for row in rows) for name in ("residual", "condition", "energy")},
            "kept": min(kept, default=None), "passing": sum(row["passing"] for row in rows),
            "judged": sum(row["judged"] for row in rows)}


def build(source):
    cases = [case for case in source.run.cases if SUITE in case.record["suites"]]
    tables = [table_of(case) for case in cases]
    rows = [row for table in tables for row in table["rows"]]
    data = {"tables": tables, "summaries": [summary(table) for table in tables], "scenes": len(rows),
            "solved": sum(not row["failed"] for row in rows), "digits": digits}
    return Section("extreme", "Extreme scenes", "extreme.html", data, absent="" if cases else ABSENT)
