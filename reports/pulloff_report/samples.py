"""Timed solves with measured errors: what the section on precision draws and tabulates.

Everything here is arithmetic on the numbers of a record: medians, slopes, who is faster.
"""

import math
import statistics

from .words import plain, value_of

FIELDS = ("force", "approach", "folds", "curve")
FIELD_NAMES = {"force": "pull-off force", "approach": "approach at pull-off",
               "folds": "approach of the folds", "curve": "whole curve"}
QUANTITIES = {"pull_off_force": "force", "pull_off_approach": "approach", "fold_approach": "folds",
              "fold_count": "folds", "curve": "curve"}
SERIES = ("ring uniform", "triangle uniform", "ring graded", "triangle graded", "panel")
KEYS = ("tabor", "amplitude", "wavelength", "outer_radius")
MARK = "triangle uniform", 501    # what the speed of panels is compared with
ABOVE_FLOOR = 3                   # an error below so many floors says nothing of an order


class Sample:
    """One timed solve: scene, mesh, times, and by field its error, floor and whether folds fit."""

    def __init__(self, point, measured):
        self.label, self.status = point["label"], point["status"]
        self.scene = tuple(value_of(point, key) or 0 for key in KEYS)
        scheme = value_of(point, "scheme")
        self.series = scheme if scheme == "panel" else f"{scheme} {value_of(point, 'grading')}"
        self.nodes = None if scheme == "panel" else value_of(point, "nodes")
        self.tolerance = value_of(point, "tolerance") if scheme == "panel" else None
        self.work = point["work"]
        self.times = point.get("processor_seconds_all") or point.get("seconds_all") or []
        self.clock = point["work"].get("seconds")
        self.failed = point["status"] != "ok"
        self.folds = len(point.get("folds") or [])
        self.errors, self.floors, self.notes = {}, {}, {}
        self.misfit = False           # its folds are not those of the reference
        for item in measured:
            self.take(item)

    def take(self, item):
        field = QUANTITIES.get(item["quantity"])
        if field is None:
            return
        if item["outcome"] == "no_correspondence":
            self.misfit = True
            self.notes[field] = item["note"]
        # The number of folds is no distance; and that of folds that do not fit is not one either.
        if item["error"] is None or item["quantity"] == "fold_count":
            return
        self.errors[field] = max(abs(item["error"]), self.errors.get(field, 0))
        floor = item.get("reference_uncertainty")
        if floor:
            self.floors[field] = max(floor, self.floors.get(field, 0))

    @property
    def seconds(self):
        return statistics.median(self.times) if self.times else None

    @property
    def mesh(self):
        return self.series, self.nodes or self.tolerance

    def reaches(self, field, error):
        """Whether the error is no greater, and none of the folds is missing or spurious."""
        return (not self.failed and not self.misfit and field in self.errors
                and self.errors[field] <= error)


def scene_name(scene):
    """Its letters; that smooth spheres are unbounded and wavy ones cut the section says."""
    tabor, amplitude, wavelength, _ = scene
    return f"μ = {plain(tabor)}" + (
        f", A† = {plain(amplitude)}, λ† = {plain(wavelength)}" if amplitude else "")


def read(case):
    """The samples of a case, in its order."""
    measured = {}
    for item in case.record.get("measured", []):
        measured.setdefault(item["point"], []).append(item)
    return [Sample(point, measured.get(point["id"], [])) for point in case.points]


def scenes(samples):
    return list(dict.fromkeys(sample.scene for sample in samples))


def of(samples, scene, series=None):
    return [sample for sample in samples if sample.scene == scene
            and (series is None or sample.series == series)]


def slope(points):
    """Least squares of log y against log x."""
    logs = [(math.log(x), math.log(y)) for x, y in points]
    mean_x = statistics.fmean(x for x, _ in logs)
    mean_y = statistics.fmean(y for _, y in logs)
    return (sum((x - mean_x) * (y - mean_y) for x, y in logs)
            / sum((x - mean_x) ** 2 for x, _ in logs))


def order(samples, field):
    """Observed order in the number of nodes, (order, first N, last N, count): over the finest meshes
    without a failure, with the folds of the reference, above its floor. None: fewer than two."""
    fit = []
    for sample in sorted(samples, key=lambda item: item.nodes, reverse=True):
        floor = ABOVE_FLOOR * sample.floors.get(field, 0)
        if sample.failed or sample.misfit or sample.errors.get(field, 0) <= floor:
            break
        fit.append((sample.nodes, sample.errors[field]))
    if len(fit) < 2:
        return None
    return -slope(fit), fit[-1][0], fit[0][0], len(fit)


def best(samples, field, seconds):
    """The sample of the least error among those that take no longer; None: there is none."""
    known = [sample for sample in samples if not sample.failed and field in sample.errors
             and sample.seconds <= seconds and not (field == "folds" and sample.misfit)]
    return min(known, key=lambda sample: sample.errors[field], default=None)


def overtaking(panels, others, field):
    """From which time on panels have the smaller error, whatever the other scheme makes of that
    time, and what the two are then: (seconds, panel, other or None). None: never."""
    found = None
    for seconds in sorted({sample.seconds for sample in panels + others}, reverse=True):
        ours, theirs = best(panels, field, seconds), best(others, field, seconds)
        if ours is None or (theirs and theirs.errors[field] < ours.errors[field]):
            break
        found = seconds, ours, theirs
    return found


def quickest(panels, fields, goal):
    """The quickest of the panels with errors no greater than those of `goal` in all fields."""
    able = [sample for sample in panels
            if all(sample.reaches(field, goal.errors.get(field, 0)) for field in fields)]
    return min(able, key=lambda sample: sample.seconds, default=None)


def marked(samples):
    """Triangle with 501 nodes, which the speed of panels is compared with."""
    return next((sample for sample in samples if sample.mesh == MARK), None)
