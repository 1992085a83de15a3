"""Error against run time, observed orders of convergence, and the speed of panels relative to the other schemes."""

from . import Section
from .. import samples
from ..plots import precision
from ..plots.figure import failures

SCRIPT = "precision"
ABSENT = ("Error against run time is omitted: this run has no record of the case precision "
          "(pulloff run --suite precision computes one).")
EMPTY = "Error against run time is omitted: no point of the case has both an error and a run time."
COMPARED = (("ring uniform", 501), samples.MARK, ("panel", 1e-6))  # the meshes of the table of work


def order_rows(found):
    rows = []
    for scene in samples.scenes(found):
        for series in samples.SERIES[:-1]:
            meshes = samples.of(found, scene, series)
            orders = {field: samples.order(meshes, field) for field in samples.FIELDS}
            if any(orders.values()):
                rows.append({"scene": samples.scene_name(scene), "series": series, "orders": orders})
    return with_first(rows)


def crossing_rows(found):
    rows = []
    for scene in samples.scenes(found):
        panels = samples.of(found, scene, "panel")
        for scheme in ("ring", "triangle"):
            others = [sample for sample in samples.of(found, scene)
                      if sample.series.startswith(scheme)]
            if panels and others:
                rows.append({"scene": samples.scene_name(scene), "scheme": scheme,
                             "cells": {field: samples.overtaking(panels, others, field)
                                       for field in samples.FIELDS}})
    return with_first(rows)


def speed_rows(found):
    """For each scene: the fastest panel solve at least as accurate as 501 triangles, by field and for all fields."""
    rows = []
    for scene in samples.scenes(found):
        goal = samples.marked(samples.of(found, scene))
        panels = samples.of(found, scene, "panel")
        if goal is None or goal.failed or not panels:
            rows.append({"scene": samples.scene_name(scene), "goal": None})
            continue
        known = [field for field in samples.FIELDS if field in goal.errors and not (
            field == "folds" and goal.misfit)]
        cells = {field: samples.quickest(panels, [field], goal) for field in known}
        rows.append({"scene": samples.scene_name(scene), "goal": goal, "cells": cells,
                     "all": samples.quickest(panels, known, goal)})
    return rows


def work_rows(found):
    rows = []
    for scene in samples.scenes(found):
        for mesh in COMPARED:
            rows += [{"scene": samples.scene_name(scene), "sample": sample}
                     for sample in samples.of(found, scene) if sample.mesh == mesh]
    return with_first(rows)


def every_row(found):
    return with_first([{"scene": samples.scene_name(sample.scene), "sample": sample}
                       for sample in found])


def with_first(rows):
    """Marks the first row of each scene."""
    for before, row in zip([None] + rows, rows):
        row["first"] = before is None or before["scene"] != row["scene"]
    return rows


def build(source):
    data = {"figures": [], "absent": ABSENT}
    cases = [case for case in source.run.cases if case.name == SCRIPT]
    if cases:
        found = [sample for sample in samples.read(cases[0]) if sample.times]
        data = {"figures": precision.make(cases[0]), "absent": None, "fields": samples.FIELDS,
                "names": samples.FIELD_NAMES, "orders": order_rows(found),
                "crossings": crossing_rows(found), "speeds": speed_rows(found),
                "works": work_rows(found), "everything": every_row(found),
                "above": samples.ABOVE_FLOOR, "failures": failures(cases[0]),
                "not_solved": cases[0].record.get("not_solved", [])}
        if not data["figures"]:
            data["absent"] = EMPTY
    return Section("precision", "Error against run time", "precision.html", data)
