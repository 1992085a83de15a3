"""Figure 6: loading curves of the rigid wavy sphere, Eq 22, and the solver at mu = 1e-4."""

import numpy
from markupsafe import Markup

from .. import geometry, gnuplot, live, svg
from ..words import MINUS, plain, scientific, value_of
from . import twice
from .figure import Figure, log_range

NUMBER = "6"
TITLE = "Rigid loading curves"
CURVES = "rigid_curves.csv"
WINDOW = (-0.4, 3.0)      # of −Δ†
LOADS = (-2.3, 0.6)       # of W̄
APART = 0.22              # distance between markers, see geometry.thinned
# log10(alpha) -> place of the name of a curve whose minimum lies among other curves; a line joins them.
NAMED = {-1: (0.12, -0.42), 0: (-0.34, -1.45), 1: (-0.27, -1.75)}


def branch(case, alpha):
    """(−Δ†, W̄, position) of the computed branch of this α, and its point of the record; or None."""
    for point in case.points if case else []:
        if numpy.isclose(value_of(point, "alpha"), alpha, rtol=1e-9) and point.get("curve"):
            table = case.curve(point)
            return (-table.numbers("approach"), table.numbers("load"), table.numbers("position")), point
    return None


def reference(references, alpha):
    """(−Δ†, W̄) of Eq 22 stored at this α, or None."""
    table = references.table(CURVES)
    if table is None:
        return None
    chosen = numpy.isclose(table.numbers("alpha"), alpha, rtol=1e-9)
    return -table.numbers("approach")[chosen], table.numbers("load")[chosen]


def markers(computed):
    """Points at about equal distances on paper, on the spline through the computed points."""
    return geometry.thinned(*geometry.dense(*computed).T, WINDOW, LOADS, APART)


def residual(computed, stored):
    x, y = stored
    chosen = geometry.inside(WINDOW, LOADS, x, y) & geometry.common_range(computed[0], computed[1], x, y)
    gap = geometry.distances(*computed, x[chosen], y[chosen])
    return [(float(a), float(max(b, 1e-16))) for a, b in zip(x[chosen], gap) if b == b]


def make(case, references):
    lines = {key[0]: [(-a, b) for a, b in block] for key, block in
             twice.table_blocks(case.line("rigid"), ["alpha"], "approach", "load").items()}
    marks, strips, labels, links = [], [[], []], [], live.Links()
    for alpha in sorted(lines):
        stored = reference(references, alpha)
        for which, one in enumerate((case, case.companion)):
            computed, point = branch(one, alpha) or (None, None)
            if computed is None:
                continue
            if which == 0:
                marks.append(markers(computed))
                links.add(0, marks[-1], point)
            if stored is not None:
                strips[which] += residual(computed, stored)
        x, y = min(lines[alpha], key=lambda row: row[1])
        name = round(float(numpy.log10(alpha)))
        labels.append((x, y, plain(name), *NAMED.get(name, (x, y - 0.12))))
    low, high = log_range([row[1] for strip in strips for row in strip])
    high *= 10   # room for the key
    drawn = gnuplot.draw("fig06", {
        "line_count": len(lines), "mark_count": len(marks), "label_count": len(labels),
        "label_x": [item[0] for item in labels], "label_y": [item[1] for item in labels],
        "label_text": [item[2] for item in labels], "name_x": [item[3] for item in labels], "name_y": [item[4] for item in labels],
        "low": low, "high": high, "cut": twice.CUT,
        "figure_height": 430, "x_min": WINDOW[0], "x_max": WINDOW[1], "y_min": LOADS[0], "y_max": LOADS[1]},
        {"rigid": [lines[key] for key in sorted(lines)], "computed": marks or [[]],
         "residual": strips, "links": links.blocks})
    label = "Load against minus the approach of rigid wavy spheres for five values of alpha"
    return Figure("fig06", NUMBER, TITLE, Markup(svg.embeddable(drawn, "fig06", label, links)),
                  caption(case, strips), twice.remarks(case), case.record["command"])


def caption(case, strips):
    text = Markup("Load W̄ against the approach {}Δ† for A† = 1 and the values of log₁₀ α at the curves. "
                  "(a) Lines: Eq 22, computed by this program. Blue squares: the elastic solver at μ = 10⁻⁴, with {}.").format(
                      MINUS, twice.how(case))
    worst = [max(row[1] for row in strip) if strip else None for strip in strips]
    if worst[0]:
        text += Markup(" (b) Absolute distance of points of Eq 22, computed independently, from the branch, along its "
                       "normal, in units of the axes. Blue: panels; at most {}").format(scientific(worst[0]))
        if worst[1]:
            text += Markup(". Orange: with the paper’s discretisation ({1}); at most {0}; {2}").format(
                scientific(worst[1]), twice.PAPER, twice.CUT_WORDS)
        text += "."
    return text
