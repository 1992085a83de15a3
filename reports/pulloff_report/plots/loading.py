"""Figures 12 and 13: loading and unloading of a wavy sphere, with its jumps and the JKR theory."""

import numpy
from markupsafe import Markup

from .. import geometry, gnuplot, svg
from ..words import MINUS, plain, scientific, value_of
from .figure import Figure, failures

APART = 0.22  # distance between markers, see geometry.thinned


def stretches(table, tabor):
    """The stable and the unstable parts of the branch as blocks of (−Δ†/μ, W̄); adjacent blocks share a point."""
    x, y = -table.numbers("approach") / tabor, table.numbers("load")
    stable = table.numbers("unstable_modes") == 0
    blocks = {True: [], False: []}
    start = 0
    for place in range(1, len(x)):
        if place == len(x) - 1 or stable[place] != stable[start]:
            blocks[bool(stable[start])].append(
                [(float(a), float(b)) for a, b in zip(x[start:place + 1], y[start:place + 1])])
            start = place
    return blocks[True], blocks[False]


def line(case, name, tabor):
    """(−Δ†/μ, W̄) of a closed-form solution of the case."""
    table = case.line(name)
    if table is None:
        return []
    return [(float(-a / tabor), float(b)) for a, b in
            zip(table.numbers("approach"), table.numbers("load")) if numpy.isfinite(a + b)]


# Offset of the label at an end of a jump (left, up) by (loading, before): away from the branch, which falls to
# the right.
BESIDE = {(True, True): (1, 1), (True, False): (1.9, -0.9), (False, True): (-0.3, -1.5), (False, False): (-1, 1)}


def ends(loop, tabor, beside):
    """(x, y, label, loading, left, above) of both ends of every jump; `beside` has offsets of single labels."""
    rows = []
    for jump in loop["jumps"]:
        loading = jump["phase"] == "loading"
        for state, label, before in zip((jump["before"], jump["after"]), jump["ends"], (True, False)):
            rows.append((-state["approach"] / tabor, state["load"], label, int(loading),
                         *beside.get(label, BESIDE[loading, before])))
    return rows


def curve(case, point, tabor):
    """(−Δ†/μ, W̄, position) of the branch of a point."""
    table = case.curve(point)
    return -table.numbers("approach") / tabor, table.numbers("load"), table.numbers("position")


def by_triangles(case, panel, triangle, tabor, window, loads):
    """Markers on the branch of the paper's triangles, and their largest distance from the branch of the panels.

    The distance is in units of W̄ and −Δ†/μ.
    """
    markers = geometry.thinned(*geometry.dense(*curve(case, triangle, tabor)).T, window, loads, APART)
    gap = geometry.distances(*curve(case, panel, tabor), *numpy.array(markers).T) if markers else []
    return markers, max((value for value in gap if value == value), default=0.0)


def solved(case, scheme):
    """The point that was solved with a scheme, or None."""
    for point in case.points:
        if value_of(point, "scheme") == scheme and point.get("curve"):
            return point
    return None


def next_jump(approaches, preload):
    """The approach of the first fold in loading beyond a preload, or None. The curve starts far from contact."""
    for before, here, after in zip(approaches, approaches[1:], approaches[2:]):
        if before <= here > after and here > preload:
            return here
    return None


def make(case, number, title, window, loads, wide=None, beside=None, key_below=False):
    """The figure. `wide` is the window and the loads of a second frame for the JKR theory; `beside`: see ends()."""
    name = f"fig{number}"
    panel, triangle = solved(case, "panel"), solved(case, "triangle")
    tabor = value_of(panel, "tabor") or 1.0
    loop = panel["hysteresis"]["displacement_control"]
    stable, unstable = stretches(case.curve(panel), tabor)
    markers, apart = by_triangles(case, panel, triangle, tabor, window, loads) if triangle else ([], 0.0)
    arrows = [(-j["before"]["approach"] / tabor, j["before"]["load"], j["after"]["load"],
               0 if j["phase"] == "loading" else 1) for j in loop["jumps"]]
    theory = [[(-jump["before"]["approach"] / tabor, jump["before"]["load"]), (-jump["after"]["approach"] / tabor, jump["after"]["load"])]
              for jump in panel["hysteresis"]["jkr"]["displacement_control"]["jumps"]]
    marks = ends(loop, tabor, beside or {})
    parameters = {
        "stable_count": len(stable), "unstable_count": len(unstable), "triangle_count": len(markers),
        "arrow_count": len(arrows), "arrow_x": [a[0] for a in arrows],
        "arrow_from": [a[1] for a in arrows], "arrow_to": [a[2] for a in arrows],
        "arrow_back": [a[3] for a in arrows],
        "theory_count": len(theory), "label_count": len(marks), "label_x": [m[0] for m in marks],
        "label_y": [m[1] for m in marks], "label_text": [m[2] for m in marks],
        "label_loading": [m[3] for m in marks], "label_left": [m[4] for m in marks],
        "label_above": [m[5] for m in marks], "key_below": int(key_below),
        "preload_x": -loop["preload"]["approach"] / tabor, "preload_y": loop["preload"]["load"],
        "x_min": window[0], "x_max": window[1], "y_min": loads[0], "y_max": loads[1],
        "wide": [float(bound) for pair in wide or () for bound in pair], "wide_count": 4 if wide else 0,
        "figure_height": 760 if wide else 450}
    drawn = gnuplot.draw("loading", parameters, {
        "stable": stable or [[]], "unstable": unstable or [[]], "triangle": [markers],
        "smooth": [line(case, "smooth", tabor)], "guduru": [line(case, "guduru", tabor)], "theory": theory or [[]]})
    label = "Load against minus the approach over the Tabor parameter, with the path of a loading test"
    return Figure(name, number, title, Markup(svg.embeddable(drawn, name, label)),
                  caption(panel, loop, apart, wide, [-x * tabor for x, _ in line(case, "guduru", tabor)]), failures(case), case.record["command"])


def caption(panel, loop, apart, wide, theory):
    jkr = panel["hysteresis"]["jkr"]["displacement_control"]
    text = Markup("Dimensionless load W̄ against {}Δ†/μ; half-space cut at r = R").format(MINUS)
    if wide:
        text += Markup(": (a) with the large oscillations of the JKR theory, (b) the rectangle of (a)")
    text += Markup(
        ". Thick orange lines: equilibria that are stable at fixed approach; thin orange lines: unstable equilibria.")
    if apart:
        text += Markup(
            " Triangles: with the paper’s 500 equal elements; at most {} from the lines, in units of the axes.").format(
                scientific(apart))
    jump = next_jump(theory, loop["preload"]["approach"])
    later = f"; the next jump in loading is at Δ† = {jump:.2f}" if jump else ""
    return text + Markup(
        " Arrows: the jumps in loading to Δ† = {} (ends 1 to 6) and in unloading (ends a to f). The energy lost in the loop is {:.4g} "
        "πwRε. A test from this preload measures a pull-off force of {:.5g} in displacement control and "
        "{:.5g} in load control; the largest tension of the whole curve is {:.5g}. By the JKR theory of "
        "the wavy sphere (Eq 5), whose jumps are purple, the same test loses {:.4g} and measures {:.5g}{}. The "
        "paper does not state at which points its labels are. Here they are the ends of three jumps in each phase, "
        "because six jumps in each phase would require a much larger preload in Figure 12 than in Figure 13.").format(
            plain(loop["preload"]["approach"]), loop["energy_lost"], loop["pull_off"]["force"],
            panel["hysteresis"]["load_control"]["pull_off"]["force"], panel["pull_off"]["force"],
            jkr["energy_lost"], jkr["pull_off"]["force"], later)
