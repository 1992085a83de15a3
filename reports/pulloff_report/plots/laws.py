"""Four laws on the smooth sphere: the pull-off between the rigid and the JKR limit, and the distance from both."""

import math

from markupsafe import Markup

from .. import gnuplot, svg
from ..words import plain, value_of
from .figure import BLUE, GREEN, ORANGE, PURPLE, VERMILLION, Figure, failures

NUMBER = None
TITLE = "Pull-off of the smooth sphere under four laws"
COLOURS, SHAPES = (BLUE, VERMILLION, GREEN, PURPLE, ORANGE), (6, 4, 8, 12, 10)
LIMITS = ((2.0, lambda tabor: tabor <= 1), (1.5, lambda tabor: tabor >= 1))  # rigid, JKR; where each is drawn


def law_name(point):
    """"Mie (4, 10)": the law of a point with its parameters."""
    scene = point["input"]  # the sweep spells the law with its parameters
    name = scene["law"]
    parameters = [plain(value) for key, value in scene.items() if key.startswith(f"{name}_") and value is not None]
    return name.title() + (f" ({', '.join(parameters)})" if parameters else "")


def by_law(case):
    """Law -> its points, in the order of the case."""
    found = {}
    for point in case.points:
        if point["status"] == "ok":
            found.setdefault(law_name(point), []).append(point)
    return found


def forces(points):
    """Rows (μ, force), in order."""
    return sorted((value_of(point, "tabor"), point["pull_off"]["force"]) for point in points if point.get("pull_off"))


def distances(rows, limit, near):
    """Rows (μ, |force − limit|) where the limit is near."""
    return [(tabor, abs(force - limit)) for tabor, force in rows if near(tabor) and force != limit]


def rate(rows, first):
    """The exponent of μ between the two outermost rows; None for fewer rows."""
    if len(rows) < 2:
        return None
    (one, a), (two, b) = rows[:2] if first else rows[-2:]
    return math.log(b / a) / math.log(two / one)


def maugis(case):
    """Rows (μ, force) of the Maugis-Dugdale theory; empty without that line."""
    table = case.line("maugis")
    return [] if table is None else sorted(zip(table.numbers("tabor").tolist(), table.numbers("pull_off_force").tolist()))


def make(case, references):
    del references
    laws = by_law(case)
    computed = [forces(points) for points in laws.values()]
    theory = maugis(case)
    lines = computed + [theory]
    away = [[distances(rows, limit, near) for rows in lines] for limit, near in LIMITS]
    rates = [[rate(rows, first) for rows in blocks] for blocks, first in zip(away, (True, False))]
    drawn = gnuplot.draw("laws", {
        "count": len(laws), "name": list(laws), "colour": list(COLOURS[:len(laws)]), "shape": list(SHAPES[:len(laws)]),
        "theory": 1 if theory else 0, "last": max(row[0] for rows in computed for row in rows), "figure_height": 420},
        {"force": lines, "rigid": away[0], "jkr": away[1]})
    label = "Pull-off force against the Tabor parameter for four laws, and its distance from the rigid and the JKR limit"
    return Figure("laws", NUMBER, TITLE, Markup(svg.embeddable(drawn, "laws", label)),
                  caption(list(laws) + ["Maugis–Dugdale"] * bool(theory), rates, theory, computed), failures(case),
                  case.record["command"])


def caption(names, rates, theory, computed):
    text = Markup("(a) Pull-off force |W̄| of the smooth sphere on the unbounded half-space against the Tabor parameter μ for four "
                  "laws with the same work of adhesion. Dotted lines: the limits that are the same for every law, 2 (rigid) and 1.5 (JKR). "
                  "(b) Distance below the rigid limit and (c) above the JKR limit. The exponents of μ between the two outermost points are, in (b), {}; "
                  "in (c), {}.").format(*(said(names, row) for row in rates))
    if theory:
        beside = dict(computed[0])
        worst = max(((abs(force - beside[tabor]), tabor) for tabor, force in theory if tabor in beside), default=None)
        text += Markup(" Dashed: Maugis–Dugdale theory with the greatest tension of the Lennard-Jones law (λ = 1.157 μ)")
        if worst:
            text += Markup("; it differs from the Lennard-Jones law most at μ = {}, by {:.3f}").format(plain(worst[1]), worst[0])
        text += "."
    return text


def said(names, rates):
    return ", ".join(f"{value:.2f}".replace("-", "−") + f" ({name})" for name, value in zip(names, rates) if value is not None)
