"""Timed solves with measured errors, for the section on error against run time.

The functions compute medians, slopes and comparisons from the numbers of a record.
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
MARK = "triangle uniform", 501    # the mesh of the paper, with which the speed of panels is compared
ABOVE_FLOOR = 3                   # errors below this multiple of the reference uncertainty are not used for orders
FEWEST_MESHES, MOST_SPREAD = 3, 0.5   # meshes of an observed order, and by how much the orders between them may differ


def scene_of(point):
    """Tabor parameter, amplitude, wavelength and outer radius of a point."""
    return tuple(value_of(point, key) or 0 for key in KEYS)


class Sample:
    """One timed solve: its scene, mesh and times; for each field its error and the uncertainty of the reference."""

    def __init__(self, point, measured):
        self.label, self.status = point["label"], point["status"]
        self.scene = scene_of(point)
        scheme = value_of(point, "scheme")
        self.series = scheme if scheme == "panel" else f"{scheme} {value_of(point, 'grading')}"
        self.nodes = None if scheme == "panel" else value_of(point, "nodes")
        self.tolerance = value_of(point, "tolerance") if scheme == "panel" else None
        self.work = point["work"]
        times = point.get("processor_seconds_all") or point.get("seconds_all") or []
        self.times = [time for time in times if time is not None]
        self.clock = point["work"].get("seconds")
        self.failed = point["status"] != "ok"
        self.force = (point.get("pull_off") or {}).get("force")
        self.folds = len(point.get("folds") or [])
        self.errors, self.floors, self.notes = {}, {}, {}
        self.misfit = False           # whether its folds differ in number or kind from those of the reference
        for item in measured:
            self.take(item)

    def take(self, item):
        field = QUANTITIES.get(item["quantity"])
        if field is None:
            return
        if item["outcome"] == "no_correspondence":
            self.misfit = True
            self.notes[field] = item["note"]
        # A difference in the number of folds is not an error of their place, and unmatched folds have no error.
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
    def relative(self):
        """The error of the pull-off force relative to the force; None without one."""
        return self.errors["force"] / abs(self.force) if self.force and "force" in self.errors else None

    @property
    def mesh(self):
        return self.series, self.nodes or self.tolerance

    def reaches(self, field, error):
        """Whether the error does not exceed this one and no fold is missing or spurious."""
        return (not self.failed and not self.misfit and field in self.errors
                and self.errors[field] <= error)


def scene_name(scene):
    """The parameters of a scene in the letters of the paper; the outer radius is left out."""
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
    """Slope of the least-squares line of log y against log x."""
    logs = [(math.log(x), math.log(y)) for x, y in points]
    mean_x = statistics.fmean(x for x, _ in logs)
    mean_y = statistics.fmean(y for _, y in logs)
    return (sum((x - mean_x) * (y - mean_y) for x, y in logs)
            / sum((x - mean_x) ** 2 for x, _ in logs))


def order(samples, field):
    """Observed order of convergence in the number of nodes: (order, first N, last N, number of meshes).

    The fit uses consecutive meshes, from the finest one down, that are solved, have the folds of the reference and
    an error above ABOVE_FLOOR times its uncertainty, as long as the orders between neighbouring meshes differ by at most
    MOST_SPREAD. None for fewer than FEWEST_MESHES such meshes: the errors do not yet decrease with one order.
    """
    fit, steps = [], []
    for sample in sorted(samples, key=lambda item: item.nodes, reverse=True):
        floor = ABOVE_FLOOR * sample.floors.get(field, 0)
        if sample.failed or sample.misfit or sample.errors.get(field, 0) <= floor:
            break
        here = sample.nodes, sample.errors[field]
        step = [-slope([here, fit[-1]])] if fit else []
        if steps and max(steps + step) - min(steps + step) > MOST_SPREAD:
            break
        fit.append(here)
        steps += step
    if len(fit) < FEWEST_MESHES:
        return None
    return -slope(fit), fit[-1][0], fit[0][0], len(fit)


def quickest(panels, fields, goal):
    """The fastest panel solve whose errors do not exceed those of `goal` in any of the fields, or None."""
    able = [sample for sample in panels
            if all(sample.reaches(field, goal.errors.get(field, 0)) for field in fields)]
    return min(able, key=lambda sample: sample.seconds, default=None)


def marked(samples):
    """The solve with 501 triangles on equal elements, or None."""
    return next((sample for sample in samples if sample.mesh == MARK), None)
