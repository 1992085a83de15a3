"""The cases: what was computed and why, what each point gave, and the command that repeats it."""

from . import Section
from ..records import PASSING
from ..words import sweep_label

# Of a case with more points than this, those that failed are shown and so many others, evenly spaced: a map has
# thousands, and paper none for them.
MOST_POINTS = 40


def row(case, point):
    folds = point.get("folds") or []
    return {"point": point, "label": sweep_label(point), "pull_off": point.get("pull_off") or {},
            "folds": len(folds), "work": point["work"], "id": f"point-{case.name}-{point['id']}"}


def shown(case):
    """The points of a case that the report shows."""
    points = case.points
    if len(points) <= MOST_POINTS:
        return points
    kept = {points[place * (len(points) - 1) // (MOST_POINTS - 1)]["id"] for place in range(MOST_POINTS)}
    kept |= {check["point"] for check in case.checks if check.get("point") and check["verdict"] not in PASSING}
    return [point for point in points if point["id"] in kept or point["status"] != "ok"]


def build(source):
    tables = [{"case": case, "rows": [row(case, point) for point in shown(case)]}
              for case in source.run.cases]
    entries = [(f"case-{table['case'].name}", table["case"].title) for table in tables]
    return Section("cases", "Cases and how to rerun them", "cases.html", {"tables": tables}, entries)
