"""The cases: what was computed, the result of each point, and the command that repeats it."""

from . import Section
from ..records import PASSING
from ..words import count, sweep_label

# A case with more points shows this many, evenly spaced, and in addition those that failed: maps have thousands.
MOST_POINTS = 40


def row(case, point):
    folds = point.get("folds") or []
    return {"point": point, "label": sweep_label(point), "pull_off": point.get("pull_off") or {},
            "folds": len(folds), "work": point["work"], "id": f"point-{case.name}-{point['id']}"}


def spaced(number, most):
    """Indices of `most` items out of `number`, evenly spaced from the first to the last; all if there are fewer."""
    return {place * (number - 1) // (most - 1) for place in range(most)} if number > most else set(range(number))


def shown(case):
    """The points of a case that the report lists."""
    points = case.points
    if len(points) <= MOST_POINTS:
        return points
    kept = {points[place]["id"] for place in spaced(len(points), MOST_POINTS)}
    kept |= {check["point"] for check in case.checks if check.get("point") and check["verdict"] not in PASSING}
    return [point for point in points if point["id"] in kept or point["status"] != "ok"]


def build(source):
    tables = [{"case": case, "rows": [row(case, point) for point in shown(case)]} for case in source.run.cases]
    points = sum(len(case.points) for case in source.run.cases)
    return Section("cases", "Every case and how to repeat it", "cases.html", {"tables": tables}, on_paper=not source.run.is_of_paper,
                   omitted_words=f"the scenes of {count(len(tables), 'case')} with {count(points, 'point')}, their results, and "
                   "the command that repeats each")
