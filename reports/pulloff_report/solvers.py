"""The external solvers of a run: their records, and their times and errors beside those of this program."""

import math
import os

from . import samples
from .records import PASSING, Run, record_of

FOLDER = "solvers"
TIMED = "solver_times"       # the case in which solvers are timed in turn with this program
OURS = "pulloff"
WRONG = 0.5                  # a relative error of the pull-off force beyond which a result is wrong, not inaccurate
ROUNDING = 1e-6              # by which errors that are both the uncertainty of the reference may differ
GOAL = 1e-6                  # a relative error of the pull-off force that is compared beside that of each solver


class Solver:
    """One external solver with one value of its knob."""

    def __init__(self, name, folder):
        self.run = Run(folder)
        self.name = name
        self.cases = {case.name: case for case in self.run.cases}
        self.about = next(case.record["solver"] for case in self.run.cases)

    @property
    def label(self):
        """Its name and the value of its knob: "newton, nodes 251"."""
        base = self.name.split("@")[0]
        return f"{base}, {self.about['knob']} {self.about['knob_value']}" if self.about.get("knob") else base


def knob_order(solver):
    value = solver.about.get("knob_value")
    try:
        return solver.name.split("@")[0], 0, float(value), ""
    except (TypeError, ValueError):
        return solver.name.split("@")[0], 1, 0.0, str(value)


def read(run):
    """The external solvers of a run, by name and value of the knob."""
    folder = os.path.join(run.folder, FOLDER)
    if not os.path.isdir(folder):
        return []
    found = []
    for name in sorted(os.listdir(folder)):
        place = os.path.join(folder, name)
        if os.path.isdir(place) and any(record_of(os.path.join(place, inner)) for inner in os.listdir(place)):
            found.append(Solver(name, place))
    return sorted(found, key=knob_order)


class Timed:
    """The times and the error of one solver on one scene."""

    def __init__(self, sample, point, name, label, value):
        self.scene, self.status, self.reason = sample.scene, point["status"], point.get("reason")
        self.name, self.label, self.value = name, label, value
        self.failed = sample.failed
        self.error = relative(sample, point)
        self.times = [time for time in sample.times if time is not None]
        self.seconds = sample.seconds if self.times else None
        self.wall = [time for time in point.get("seconds_all", []) if time is not None]
        self.timing = point.get("timing") or {}

    @property
    def wrong(self):
        return self.error is not None and self.error > WRONG

    @property
    def usable(self):
        return not self.failed and not self.wrong and self.error is not None and bool(self.seconds)


def relative(sample, point):
    """The error of the pull-off force relative to the force, at least the uncertainty of the reference; None without one.

    The solver that computed the reference would otherwise have no error at all."""
    error = sample.errors.get("force")
    force = (point.get("pull_off") or {}).get("force")
    return max(error, sample.floors.get("force", 0)) / abs(force) if error is not None and force else None


def timed_of(case, name, label, value):
    """The timed solves of a case; points that are one question of an external solver are one of them."""
    found, known = [], set()
    for sample, point in zip(samples.read(case), case.points):
        timing = point.get("timing")
        if case.record.get("solver") and (timing is None or point["status"] == "unsupported"):
            continue
        mesh = sample.tolerance if value is None else value
        if (sample.scene, mesh) in known:
            continue
        known.add((sample.scene, mesh))
        found.append(Timed(sample, point, name, label, mesh))
    return found


def timed(run, solvers):
    """All timed solves of the case TIMED: those of this program first."""
    ours = next((case for case in run.cases if case.name == TIMED), None)
    found = timed_of(ours, OURS, OURS, None) if ours else []
    for solver in solvers:
        if TIMED in solver.cases:
            found += timed_of(solver.cases[TIMED], solver.name.split("@")[0], solver.label,
                              solver.about.get("knob_value") or "")
    return found


def quickest(ours, error):
    """The fastest solve of this program with an error at most this one, or None."""
    able = [item for item in ours if item.usable and item.error <= error * (1 + ROUNDING)]
    return min(able, key=lambda item: item.seconds, default=None)


def paired(theirs, ours):
    """How many times longer the other solve takes: the median of the quotients of the rounds; None without times."""
    quotients = sorted(a / b for a, b in zip(theirs.times, ours.times) if b > 0)
    if not quotients:
        return None
    middle = len(quotients) // 2
    return quotients[middle] if len(quotients) % 2 else math.sqrt(quotients[middle - 1] * quotients[middle])


def coverage(case):
    return case.record["solver"]["coverage"]


def score(case):
    """(passing, made) of the checks of a case."""
    return sum(check["verdict"] in PASSING for check in case.checks), len(case.checks)
