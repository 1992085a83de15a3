"""The smallest preload that gives twice the pull-off force of the smooth sphere, over the Tabor parameter and A/λ."""

import bisect
import itertools
import math

import numpy
from markupsafe import Markup

from .. import gnuplot, svg
from ..words import count, plain
from .figure import Figure, cividis
from .pull_off_map import place

NUMBER = None
TITLE = "Preload that gives twice the pull-off force of the smooth sphere"
CASE = "fig14"
AT_ANY_PRELOAD = True   # the case with the suffix _any is drawn
FACTOR = 2.0
LEAST_RATIO = 0.01     # smallest A/λ that is drawn
# Upper ends of the classes of preloads, except the last class: approaches in ε and loads in πwR.
LEVELS = {"displacement_control": (-2, 0, 2, 4, 8, 16), "load_control": (0, 0.25, 0.5, 1, 2, 4)}
AXES = {"displacement_control": "approach", "load_control": "load"}
GREATEST_LOAD = 100  # largest preload that was computed, in πwR


def doubling(steps, axis, wanted):
    """The smallest preload at which the force reaches the wanted value, or None."""
    for step in steps:
        if step["force"] >= wanted:
            return step["preload"][axis] or 0.0   # in load control the bodies come into contact at zero load
    return None


def middles(values):
    """Edges of the cells around the values, half way between neighbours on a logarithmic scale."""
    logs = [math.log(value) for value in values]
    inner = [(a + b) / 2 for a, b in zip(logs, logs[1:])]
    return [2 * logs[0] - inner[0]] + inner + [2 * logs[-1] - inner[-1]]


def cells(points, control, smooth):
    """Blocks of cells (x, y, left, right, low, high) in logarithms.

    One block for each class of preloads, one where no preload doubles the force, and one where this is unknown.
    """
    tabors, ratios = (sorted({place(point)[k] for point in points}) for k in (0, 1))
    xs, ys = middles(tabors), middles(ratios)
    blocks = [[] for _ in range(len(LEVELS[control]) + 3)]
    there = {place(point): point for point in points}
    for (i, tabor), (j, ratio) in itertools.product(enumerate(tabors), enumerate(ratios)):
        cell = (math.log(tabor), math.log(ratio), xs[i], xs[i + 1], ys[j], ys[j + 1])
        blocks[class_of(there.get((tabor, ratio)), control, FACTOR * smooth.get(tabor, math.inf))].append(cell)
    return blocks, (xs[0], xs[-1], ys[0], ys[-1])


def class_of(point, control, wanted):
    """The class of preloads at which a scene reaches the wanted force; -2: no preload does, -1: unknown."""
    found = point and point.get("staircase")
    if not found:
        return -1
    taken = doubling(found[control]["steps"], AXES[control], wanted)
    if taken is not None:
        return bisect.bisect_left(LEVELS[control], taken)
    return -2 if point["pull_off_any"] and point["pull_off_any"]["complete"] else -1


def names(levels, axis):
    """The names of the classes: "up to 2", "2 to 4", "above 4"."""
    first = "contact alone" if axis == "load" else f"up to {plain(levels[0])}"
    return [first] + [f"{plain(a)} to {plain(b)}" for a, b in zip(levels, levels[1:])] + [
        f"above {plain(levels[-1])}", "none", "unknown"]


def make(case, references):
    del references
    every = case.any_preload.points
    smooth = {place(point)[0]: point["pull_off"]["force"] for point in every
              if place(point)[1] == 0 and point.get("pull_off")}
    waves = [point for point in every if place(point)[1] > 0]
    data, classes, frame = {}, {}, None
    for control, levels in LEVELS.items():
        data[control], frame = cells([point for point in waves if place(point)[1] >= LEAST_RATIO], control, smooth)
        classes[control] = names(levels, AXES[control])
    shades = cividis(0.05, len(LEVELS["load_control"]) + 1)
    drawn = gnuplot.draw("doubling", {
        "class_count": len(shades) + 2, "approach_text": classes["displacement_control"],
        "load_text": classes["load_control"],
        "colours": shades + ["#FFFFFF", "#C8C8C8"],
        "x_low": frame[0], "x_high": frame[1], "y_low": frame[2], "y_high": frame[3], "figure_height": 330}, data)
    label = "Preload that gives twice the pull-off force of the smooth sphere, over the Tabor parameter and A/λ"
    return Figure("doubling", NUMBER, TITLE, Markup(svg.embeddable(drawn, "doubling", label)),
                  caption(waves, data), [], case.any_preload.record["command"])


def caption(waves, data):
    known = data["displacement_control"]
    doubled = sum(len(block) for block in known[:-2])
    return Markup(
        "The smallest preload at which a test measures at least twice the pull-off force of the smooth sphere with the same "
        "Tabor parameter; λ† = {}, R† = 100, r<sub>max</sub> = R, as in Figure 14. (a) Displacement control: the largest approach Δ†; "
        "(b) load control: the largest load W̄. Each cell is a scene. Of {} with A/λ of {} or more, {} reach twice the force at "
        "some preload and {} at none. For the other {} this is unknown: no preload up to {} πwR is sufficient, or such preloads "
        "were not computed because they take minutes.").format(
            plain(waves[0]["input"]["wavelength"]), count(sum(map(len, known)), "scene"), plain(LEAST_RATIO), doubled,
            len(known[-2]), len(known[-1]), GREATEST_LOAD)
