"""The cases: what was computed and why, what each point gave, and the command that repeats it."""

from . import Section
from ..words import sweep_label


def row(case, point):
    folds = point.get("folds") or []
    return {"point": point, "label": sweep_label(point), "pull_off": point.get("pull_off") or {},
            "folds": len(folds), "work": point["work"], "id": f"point-{case.name}-{point['id']}"}


def build(source):
    tables = [{"case": case, "rows": [row(case, point) for point in case.points]}
              for case in source.run.cases]
    entries = [(f"case-{table['case'].name}", table["case"].title) for table in tables]
    return Section("cases", "Cases and how to rerun them", "cases.html", {"tables": tables}, entries)
