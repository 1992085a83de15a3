"""The cases: what was computed and why, what each point gave, and the command that repeats it."""

from . import Section
from ..records import PASSING
from ..words import sweep_label

# Of a case with more points than this, those that failed are shown and so many others, evenly spaced: a map has
# thousands, and paper none for them.
MOST_POINTS = 40
# And so many of these on paper.
MOST_PRINTED = 8


def row(case, point):
    folds = point.get("folds") or []
    return {"point": point, "label": sweep_label(point), "pull_off": point.get("pull_off") or {},
            "folds": len(folds), "work": point["work"], "id": f"point-{case.name}-{point['id']}",
            "screen": False}


def spaced(count, most):
    """Places of so many of a count, evenly spaced from the first to the last."""
    return {place * (count - 1) // (most - 1) for place in range(most)} if count > most else set(range(count))


def rows(case):
    """A row a point that is shown; those that paper is spared are marked `screen`."""
    points = shown(case)
    printed = spaced(len(points), MOST_PRINTED)
    made = [row(case, point) for point in points]
    for place, entry in enumerate(made):
        entry["screen"] = place not in printed and entry["point"]["status"] == "ok"
    return made


def shown(case):
    """The points of a case that the report shows."""
    points = case.points
    if len(points) <= MOST_POINTS:
        return points
    kept = {points[place]["id"] for place in spaced(len(points), MOST_POINTS)}
    kept |= {check["point"] for check in case.checks if check.get("point") and check["verdict"] not in PASSING}
    return [point for point in points if point["id"] in kept or point["status"] != "ok"]


def build(source):
    tables = [{"case": case, "rows": rows(case)} for case in source.run.cases]
    for table in tables:
        table["printed"] = sum(not entry["screen"] for entry in table["rows"])
    entries = [(f"case-{table['case'].name}", table["case"].title) for table in tables]
    return Section("cases", "Cases and how to rerun them", "cases.html", {"tables": tables}, entries)
