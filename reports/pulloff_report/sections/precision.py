"""Error against run time, observed orders of convergence, and the speed of panels relative to the other schemes."""

from . import Section
from .. import samples
from ..plots import precision, speed
from ..plots.figure import failures

SCRIPT = "precision"
ABSENT = "error against run time (pulloff run --suite precision)"


def order_rows(found):
    rows = []
    for scene in samples.scenes(found):
        for series in samples.SERIES[:-1]:
            meshes = samples.of(found, scene, series)
            orders = {field: samples.order(meshes, field) for field in samples.FIELDS}
            if any(orders.values()):
                rows.append({"scene": samples.scene_name(scene), "series": series, "orders": orders})
    return with_first(rows)


def speed_rows(found):
    """For each scene: 501 triangles, and the fastest panel solve with an equal or smaller error in every quantity."""
    rows = []
    for scene in samples.scenes(found):
        goal = samples.marked(samples.of(found, scene))
        if goal is None or goal.failed:
            continue
        known = [field for field in samples.FIELDS if field in goal.errors and not (field == "folds" and goal.misfit)]
        rows.append({"scene": samples.scene_name(scene), "goal": goal,
                     "all": samples.quickest(samples.of(found, scene, "panel"), known, goal)})
    return rows


def front(rows):
    """What the first page says: how many times faster the panels are at the error of 501 triangles, and how much more accurate."""
    known = [(row["goal"].seconds / row["all"].seconds, row) for row in rows if row["all"]]
    if not known:
        return None
    forces = [(row["all"].relative, row["goal"].relative) for _, row in known]
    return {"least": min(known, key=lambda item: item[0]), "most": max(known, key=lambda item: item[0]), "scenes": len(known), "rows": known,
            "of": len(rows), "ours": max(ours for ours, _ in forces), "theirs": [min(theirs for _, theirs in forces),
                                                                                 max(theirs for _, theirs in forces)]}


def every_row(found):
    return with_first([{"scene": samples.scene_name(sample.scene), "sample": sample}
                       for sample in found])


def with_first(rows):
    """Marks the first row of each scene."""
    for before, row in zip([None] + rows, rows):
        row["first"] = before is None or before["scene"] != row["scene"]
    return rows


def build(source):
    data = {}
    cases = [case for case in source.run.cases if case.name == SCRIPT]
    figures = precision.make(cases[0]) if cases else []
    if figures:
        found = [sample for sample in samples.read(cases[0]) if sample.times]
        speeds = speed_rows(found)
        data = {"figures": figures, "fields": samples.FIELDS, "names": samples.FIELD_NAMES, "orders": order_rows(found),
                "fewest": samples.FEWEST_MESHES, "spread": samples.MOST_SPREAD, "above": samples.ABOVE_FLOOR,
                "speeds": speeds, "everything": every_row(found), "failures": failures(cases[0]),
                "not_solved": cases[0].record.get("not_solved", [])}
        numbers = front(speeds)
        data["front"] = numbers and dict(numbers, figure=speed.make(found, source.run, cases[0].record["command"]))
    return Section("precision", "Error against run time", "precision.html", data, absent="" if figures else ABSENT)
