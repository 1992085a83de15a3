"""The staircase of a solution, and loops that are reversed just below and just above the bounds of its steps and
cycles.

A staircase states for every preload what a test measures. So each loop is compared with the statement for its preload:
the pull-off of the step that holds there and the energy of its cycle or, between two steps, that the tension is
greatest at the reversal."""

import math
from dataclasses import dataclass

import compare

# Least distance between a bound of a step and the reversal of a loop, relative to the preload. The second value holds
# if the bound has no stated error (the load of loading falls below that of the pull-off), or if it is a minimum, near
# which the load changes with the square of the distance only.
NEAR, WIDE = 1e-9, 1e-4
# The loop of a bound with the error e is reversed at a distance of this many e.
ERRORS = 3.0


@dataclass(frozen=True)
class Control:
    """Which component of a preload is given, and the flag with which a loop is reversed there."""
    name: str
    component: str
    flag: str


CONTROLS = (Control("displacement_control", "approach", "preload"),
            Control("load_control", "load", "preload-load"))


@dataclass(frozen=True)
class Place:
    """A preload at which the measured values change according to the staircase, and a margin larger than its error."""
    value: float
    margin: float
    what: str


def marks(document):
    return document["folds"] + document["extrema"]


def error_at(document, position, component):
    """The stated error of the special point at a position; NaN if it has none, or if there is no such point."""
    key = "error_estimate" if component == "approach" else "load_error_estimate"
    found = [compare.value(mark, key) for mark in marks(document) if mark["position"] == position]
    return found[0] if found else math.nan


def margin(document, bound, component):
    """The distance between a bound of a step and the reversal of a loop."""
    value, error = bound[component], error_at(document, bound["position"], component)
    size = max(1.0, abs(value))
    flat = any(mark["kind"] == "minimum" and mark["position"] == bound["position"] for mark in document["extrema"])
    near = WIDE if flat or math.isnan(error) else NEAR
    return max(near * size, 0.0 if math.isnan(error) else ERRORS * error)


def places(document, control):
    """The preloads at which steps begin and end and cycles begin, in order and each once."""
    found = {}
    every = document["staircase"][control.name]["steps"]
    bounds = [("step ends", step["until"]) for step in every if not step["open"]]
    bounds += [("cycle begins", cycle["preload"]) for step in every for cycle in step["cycles"]]
    bounds += [("step begins", step["preload"]) for step in every]
    for what, bound in bounds:
        value = compare.value(bound, control.component)
        if math.isfinite(value) and (control.component == "approach" or value > 0):
            found[value] = Place(value, margin(document, bound, control.component), what)
    return [found[value] for value in sorted(found)]


def begin_of(bound, control):
    """The least preload of a step or a cycle. If it begins with the surfaces apart, no preload is too small."""
    value = compare.value(bound, control.component)
    return -math.inf if math.isnan(value) else value


def said(document, control, preload):
    """The (step, cycle) at a preload; None if the tension is greatest at the reversal."""
    for step in document["staircase"][control.name]["steps"]:
        until = math.inf if step["open"] else step["until"][control.component]
        if begin_of(step["preload"], control) <= preload < until:
            cycles = [c for c in step["cycles"] if begin_of(c["preload"], control) <= preload]
            return step, cycles[-1]
    return None


def step_before(document, control, preload):
    """The last step that begins before a preload, or None."""
    begun = [step for step in document["staircase"][control.name]["steps"]
             if begin_of(step["preload"], control) <= preload]
    return begun[-1] if begun else None


def loops(document, most):
    """(control, place, preload) of the loops that are compared with a staircase, for at most `most` evenly chosen
    places of each control. If two places are closer than their margins, nothing is compared between them."""
    chosen = []
    for control in CONTROLS:
        every = places(document, control)
        picked = every if len(every) <= most else [every[i * (len(every) - 1) // (most - 1)] for i in range(most)]
        for place in picked:
            for side in (-1.0, 1.0):
                preload = place.value + side * place.margin
                free = all(abs(preload - other.value) > other.margin for other in every if other is not place)
                if free and (control.component == "approach" or preload > 0):
                    chosen.append((control, place, preload))
    return chosen


class Beside:
    """The findings from one loop."""

    def __init__(self, staircase, solution, control, place, preload, tight):
        self.where = f" ({control.component} {preload:.12g}: {place.what} at {place.value:.12g})"
        self.findings, self.wrong, self.tie = [], [], False
        self.solution, self.control, self.tight = solution, control, tight
        loop = solution["hysteresis"][control.name]
        holds = said(staircase, control, preload)
        if holds:
            self.add_step(*holds, loop)
        else:
            self.add_reversal(step_before(staircase, control, preload), loop)

    def own(self, loop, component):
        """The error of the pull-off of the tight solution; its tolerance if it states none."""
        stated = error_at(self.solution, loop["pull_off"]["position"], component)
        return self.tight * max(1.0, abs(loop["pull_off"]["force"])) if math.isnan(stated) else stated

    def add(self, quantity, stated, difference, own):
        self.findings.append(compare.Finding(quantity, self.where, stated, difference, own))

    def add_step(self, step, cycle, loop):
        measured = loop["pull_off"]
        self.add("force", compare.value(step, "error_estimate"), abs(step["force"] - measured["force"]),
                 self.own(loop, "load"))
        # Where the step ends, the tension at the reversal is equal within the errors, so either may be the greatest.
        self.tie = self.is_reversal(loop) and self.findings[-1].verdict != "violated"
        if not self.tie:
            self.add("approach", compare.value(step, "approach_error_estimate"),
                     abs(step["approach"] - measured["approach"]), self.own(loop, "approach"))
        lost, energy = cycle["energy_lost"], loop["energy_lost"]
        if lost is None or energy is None:
            if lost is not energy:
                self.wrong.append(f"energy lost {lost}, in the loop {energy}{self.where}")
            return
        self.add("energy lost", compare.value(cycle, "energy_lost_error_estimate"), abs(lost - energy),
                 compare.value(loop, "energy_lost_error_estimate") + compare.ROUNDING)

    def is_reversal(self, loop):
        """Whether the greatest tension of a loop is that at its reversal."""
        return abs(loop["pull_off"]["approach"] - loop["preload"]["approach"]) <= self.own(loop, "approach")

    def add_reversal(self, before, loop):
        """Compares a loop between two steps. Given: the first of them, or None."""
        if self.is_reversal(loop):
            return
        measured = loop["pull_off"]
        error = (compare.value(before, "error_estimate") if before else 0.0) + self.own(loop, "load")
        self.tie = measured["force"] + loop["preload"]["load"] <= error
        if not self.tie:
            self.wrong.append(f"no step is said to hold, and the loop measures {measured['force']:.12g} at approach "
                              f"{measured['approach']:.12g}{self.where}")
