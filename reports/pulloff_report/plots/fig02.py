"""Figure 2: the traction-separation law, and the equivalent geometry before and after an approach."""

import numpy
from markupsafe import Markup

from .. import gnuplot, svg
from ..words import fixed, plain
from . import twice
from .figure import Figure

NUMBER = "2"
TITLE = "The traction–separation law and the equivalent geometry"
REACH = 32.0              # largest radius that is drawn, in ε


def surfaces(case, point):
    """Rows (r, indenter, flat, moved indenter, surface): the surface lies the computed gap under it."""
    table, scene = case.profile(point), point["input"]
    if table is None:
        return [], None
    r, gap = table.numbers("radius"), table.numbers("gap")
    profile = r ** 2 / (2 * scene["radius"]) + scene["amplitude"] * (
        1 - numpy.cos(2 * numpy.pi * r / scene["wavelength"]))        # Eq 2
    moved = 1.0 - point["pull_off"]["approach"] + profile
    chosen = r <= 1.2 * REACH
    right = [tuple(map(float, row)) for row in zip(r[chosen], 1.0 + profile[chosen], 0.0 * r[chosen],
                                                   moved[chosen], (moved - 1.0 - gap)[chosen])]
    left = [(-row[0], *row[1:]) for row in reversed(right) if row[0] > 0]
    return left + right, point


def make(case, references):
    law = [(1.0 + gap, traction) for gap, traction in
           twice.table_blocks(case.line("law"), [], "gap", "traction").get((), [])]
    rows, point = surfaces(case, case.points[0])
    drawn = gnuplot.draw("fig02", {"figure_height": 260, "figure_width": 528, "reach": REACH},
                         {"law": [law], "surfaces": [rows]})
    label = "Lennard-Jones traction against the gap; indenter and half-space before and after approach"
    return Figure("fig02", NUMBER, TITLE, Markup(svg.embeddable(drawn, "fig02", label)),
                  caption(case, point), twice.failed(case), case.record["command"])


def caption(case, point):
    text = Markup("(a) Lennard-Jones traction of Eq 9, positive in compression, against the gap h.")
    if point:
        scene = point["input"]
        text += Markup(" (b) The equivalent problem, Eq 10: a rigid wavy indenter and the half-space. Grey: undeformed; "
                       "black: at pull-off, Δ† = {}, where the half-space is pulled up to the indenter. Computed "
                       "for μ = {}, A† = {}, λ† = {}, R† = {} with {}.").format(
                           fixed(point["pull_off"]["approach"], 4), plain(scene["tabor"]),
                           plain(scene["amplitude"]), plain(scene["wavelength"]), plain(scene["radius"]),
                           twice.how(case))
    return text
