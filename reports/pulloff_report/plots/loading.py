"""Figures 12 and 13: loading and unloading of a wavy sphere, with its jumps, beside the JKR theory."""

import numpy
from markupsafe import Markup

from .. import gnuplot, svg
from ..words import MINUS, plain, value_of
from .figure import Figure, failures


def stretches(table, tabor):
    """The branch as blocks of (−Δ†/μ, W̄), stable ones and unstable ones; neighbours share a point."""
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
    """(−Δ†/μ, W̄) of a closed form of the case."""
    table = case.line(name)
    if table is None:
        return []
    return [(float(-a / tabor), float(b)) for a, b in
            zip(table.numbers("approach"), table.numbers("load")) if numpy.isfinite(a + b)]


# Where the label of an end of a jump goes, left and up, by (loading, before): away from the branch, which falls
# to the right.
BESIDE = {(True, True): (1, 1), (True, False): (1.9, -0.9), (False, True): (-0.3, -1.5), (False, False): (-1, 1)}


def ends(loop, tabor):
    """(x, y, label, loading, left, above) of both ends of every jump."""
    rows = []
    for jump in loop["jumps"]:
        loading = jump["phase"] == "loading"
        for state, label, before in zip((jump["before"], jump["after"]), jump["ends"], (True, False)):
            rows.append((-state["approach"] / tabor, state["load"], label, int(loading), *BESIDE[loading, before]))
    return rows


def solved(case, scheme):
    """The point solved by a scheme, or None."""
    for point in case.points:
        if value_of(point, "scheme") == scheme and point.get("curve"):
            return point
    return None


def make(case, window, loads, number, title, key_below=False):
    name = f"fig{number}"
    panel, triangle = solved(case, "panel"), solved(case, "triangle")
    tabor = value_of(panel, "tabor") or 1.0
    loop = panel["hysteresis"]["displacement_control"]
    stable, unstable = stretches(case.curve(panel), tabor)
    of_triangles = stretches(case.curve(triangle), tabor) if triangle else ([], [])
    arrows = [(-j["before"]["approach"] / tabor, j["before"]["load"], j["after"]["load"],
               0 if j["phase"] == "loading" else 1) for j in loop["jumps"]]
    marks = ends(loop, tabor)
    parameters = {
        "stable_count": len(stable), "unstable_count": len(unstable),
        "triangle_count": len(of_triangles[0]) + len(of_triangles[1]),
        "arrow_count": len(arrows), "arrow_x": [a[0] for a in arrows],
        "arrow_from": [a[1] for a in arrows], "arrow_to": [a[2] for a in arrows],
        "arrow_back": [a[3] for a in arrows],
        "label_count": len(marks), "label_x": [m[0] for m in marks],
        "label_y": [m[1] for m in marks], "label_text": [m[2] for m in marks],
        "label_loading": [m[3] for m in marks], "label_left": [m[4] for m in marks],
        "label_above": [m[5] for m in marks], "key_below": int(key_below),
        "preload_x": -loop["preload"]["approach"] / tabor, "preload_y": loop["preload"]["load"],
        "x_min": window[0], "x_max": window[1], "y_min": loads[0], "y_max": loads[1]}
    drawn = gnuplot.draw("loading", parameters, {
        "stable": stable or [[]], "unstable": unstable or [[]],
        "triangle": of_triangles[0] + of_triangles[1] or [[]],
        "smooth": [line(case, "smooth", tabor)], "guduru": [line(case, "guduru", tabor)]})
    label = "Load against minus the approach over the Tabor parameter, with the path of a loading test"
    return Figure(name, number, title, Markup(svg.embeddable(drawn, name, label)),
                  caption(panel, loop), failures(case), case.record["command"])


def caption(panel, loop):
    jkr = panel["hysteresis"]["jkr"]["displacement_control"]
    return Markup(
        "Dimensionless load W̄ against {0}Δ†/μ, on the surface cut at r = R. Thick lines: stable at "
        "fixed approach; thin: unstable. Grey: the same by the paper’s 500 equal triangles. Arrows: "
        "loading to Δ† = {1} (ends of the jumps 1 to 6) and unloading (a to f). The loop loses {2:.4g} "
        "πwRε; a test from this preload measures a pull-off force of {3:.5g} in displacement control and "
        "{4:.5g} in load control, the least load of the whole curve being {5:.5g}. By the JKR theory of "
        "the wavy sphere (Equation 5) the same test would lose {6:.4g} and measure {7:.5g}. The "
        "paper does not print which points its labels are at; both ends of three jumps are taken, "
        "as six in each phase would need a far larger preload in Figure 12 than in 13.").format(
            MINUS, plain(loop["preload"]["approach"]), loop["energy_lost"], loop["pull_off"]["force"],
            panel["hysteresis"]["load_control"]["pull_off"]["force"], -panel["pull_off"]["force"],
            jkr["energy_lost"], jkr["pull_off"]["force"])
