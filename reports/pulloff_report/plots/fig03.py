"""Figure 3: load against approach for a smooth sphere, with Feng's problem and Bradley's solution."""

import dataclasses

import numpy
from markupsafe import Markup

from .. import geometry, gnuplot, live, svg
from ..references import file_name
from ..words import MINUS, listing, plain, scientific, value_of
from . import twice
from .figure import Figure, BLUE, GREEN, ORANGE, PURPLE, failures, log_range

NUMBER = "3"
TITLE = "Load against approach of a smooth sphere"

CURVES, BRADLEY = "feng_curves.csv", "bradley.csv"
PUBLISHED = "published/feng_fig3.csv"   # Feng's own points, if a digitised file is available
WINDOW = (-1.05, 6.0)        # of −Δ†; contains all folds of μ = 3
LOADS = (-2.5, 1.0)          # of W̄
BEYOND = 4.0                 # a larger Tabor parameter is not in the paper's figure and is drawn in separate panels
NEAR = 0.7                   # half width of panel (c) about the pull-off, in approach
NOSE = 0.08                  # half width of panel (d) about the last jump out of contact, in approach
MARKERS_APART = 0.16         # distance between markers, see geometry.thinned
STYLES = [(BLUE, 6), (GREEN, 4), (PURPLE, 8)]


def branch(case, point):
    """(−Δ†, W̄, position) of the computed branch, or None when there is no such point or it has no curve."""
    if point is None:
        return None
    table = case.curve(point)
    if table is None or table.rows < 2:
        return None
    return (-table.numbers("approach"), table.numbers("load"), table.numbers("position"))


def reference_branch(references, tabor):
    """(−Δ†, W̄) of the stored curve at this Tabor parameter, or None."""
    table = references.table(CURVES)
    if table is None:
        return None
    chosen = numpy.isclose(table.numbers("tabor"), tabor, rtol=1e-9)
    if not chosen.any():
        return None
    return -table.numbers("approach")[chosen], table.numbers("load")[chosen]


def published_points(references):
    """(−Δ†, W̄) of Feng's points in the window; none while the file is absent."""
    table = references.table(PUBLISHED)
    if table is None:
        return []
    x, y = -table.numbers("approach"), table.numbers("load")
    chosen = inside(x, y)
    return [(float(a), float(b)) for a, b in zip(x[chosen], y[chosen])]


def inside(x, y):
    return geometry.inside(WINDOW, LOADS, x, y)


def thinned(x, y):
    return geometry.thinned(x, y, WINDOW, LOADS, MARKERS_APART)


def residual(computed, reference):
    """Rows (−Δ†, distance of a reference point from the computed branch), in the window."""
    x, y = reference
    chosen = inside(x, y) & geometry.common_range(computed[0], computed[1], x, y)
    gap = geometry.distances(computed[0], computed[1], computed[2], x[chosen], y[chosen])
    return [(float(a), float(max(b, 1e-16))) for a, b in zip(x[chosen], gap) if b == b]


def beside(case, tabor):
    """The point of the companion case with this Tabor parameter, or None."""
    for point in case.companion.points if case.companion else []:
        if numpy.isclose(value_of(point, "tabor"), tabor, rtol=1e-9):
            return point
    return None


@dataclasses.dataclass
class Soft:
    """A softer sphere than in the paper's figure, with panels and with the paper's discretisation."""
    tabor: float
    folds: list              # number of folds with each discretisation
    minimum: list            # for each: rows (−Δ†, W̄) about the pull-off
    nose: list               # for each: rows about the last jump out of contact
    at_folds: list           # for each: the folds in that range
    point: dict              # of the record, with panels
    element: float           # element length of the paper's discretisation, in ε
    hop: tuple               # smallest and largest change of the contact radius between successive folds, in ε


def nose_folds(point, middle):
    """The folds about the last jump out of contact."""
    return [fold for fold in point["folds"] or [] if abs(fold["approach"] - middle) <= NOSE]


def hops(folds):
    """Smallest and largest change of the contact radius from one jump out of contact to the next."""
    radii = [fold["contact_radius"] for fold in folds if fold["kind"] == "jump_out"]
    changes = [abs(b - a) for a, b in zip(radii, radii[1:])]
    return (min(changes), max(changes)) if changes else (0.0, 0.0)


def softest(case, points):
    """The softer sphere, or None unless both discretisations have its curve."""
    for point in points:
        other = beside(case, value_of(point, "tabor"))
        both = branch(case, point), branch(case.companion, other) if other else None
        if value_of(point, "tabor") > BEYOND and both[0] and both[1] and point.get("pull_off") and point.get("folds"):
            middle, last = -point["pull_off"]["approach"], min(fold["approach"] for fold in point["folds"])
            dense = [[(float(x), float(y)) for x, y in geometry.dense(*one)] for one in both]
            found = [nose_folds(one, last) for one in (point, other)]
            inner = [fold for fold in found[1] if fold["contact_radius"] is not None]
            return Soft(
                value_of(point, "tabor"), [len(one["folds"] or []) for one in (point, other)],
                [[(x, y) for x, y in rows if abs(x - middle) <= NEAR and y < -1] for rows in dense],
                [[(x, y) for x, y in rows if abs(x + last) <= NOSE and y < other["folds"][0]["load"]] for rows in dense],
                [[(-fold["approach"], fold["load"]) for fold in folds] for folds in found],
                point, other["input"]["radius"] / (other["input"]["nodes"] - 1), hops(inner))
    return None


def make(case, references):
    points = sorted(case.points, key=lambda point: value_of(point, "tabor") or 0)
    soft = softest(case, points)
    points = [point for point in points if (value_of(point, "tabor") or 0) <= BEYOND]
    bradley = references.table(BRADLEY)
    rigid = None
    if bradley is not None:
        order = numpy.argsort(-bradley.numbers("approach"))
        rigid = (-bradley.numbers("approach")[order], bradley.numbers("load")[order])

    dots = thinned(*rigid) if rigid is not None else []
    lines, marks, labels, colours, shapes = [], [], [], [], []
    strips, said, links = [[], []], [[], []], live.Links(2)
    elastic = 0
    for point in points:
        tabor = value_of(point, "tabor")
        computed = branch(case, point)
        if tabor is None or computed is None:
            continue
        near_rigid = tabor < 0.1
        lines.append([(float(a), float(b)) for a, b in geometry.dense(*computed)])
        colour, shape = (ORANGE, 7) if near_rigid else STYLES[elastic % len(STYLES)]
        elastic += not near_rigid
        if point.get("pull_off"):
            labels.append((-point["pull_off"]["approach"], -point["pull_off"]["force"],
                           f"μ = {plain(tabor)}", colour))
            links.add(0, [labels[-1][:2]], point)
        if near_rigid and dots:
            links.add(0, dots, point)
        stored = reference_branch(references, tabor)
        if stored is not None:
            for which, one in enumerate((computed, branch(case.companion, beside(case, tabor)))):
                rows = residual(one, stored) if one else []
                strips[which] += rows
                if rows:
                    said[which].append((tabor, max(row[1] for row in rows)))
            if not near_rigid:
                marks.append(thinned(*stored))
                links.add(0, marks[-1], point)
                colours.append(colour)
                shapes.append(shape)
    crosses = published_points(references)

    if soft:
        links.add(1, soft.at_folds[0], soft.point)
    low, high = log_range([row[1] for strip in strips for row in strip])
    high *= 100   # room for the key
    parameters = {
        "curve_count": len(lines), "mark_count": len(marks), "dot_count": len(dots),
        "cross_count": len(crosses),
        "mark_colour": colours, "mark_shape": shapes, "label_count": len(labels),
        "label_x": [item[0] for item in labels], "label_y": [item[1] for item in labels],
        "label_text": [item[2] for item in labels], "label_colour": [item[3] for item in labels],
        "panel_count": len(strips[0]), "paper_count": len(strips[1]),
        "soft": 1 if soft else 0, "soft_text": f"μ = {plain(soft.tabor)}" if soft else "",
        "figure_height": 550 if soft else 430,
        "x_min": WINDOW[0], "x_max": WINDOW[1], "y_min": LOADS[0], "y_max": LOADS[1],
        "low": low, "high": high, "cut": twice.CUT}
    drawn = gnuplot.draw("fig03", parameters, {"computed": lines or [[]], "reference": marks or [[]],
                                               "rigid": [dots], "published": [crosses],
                                               "residual": strips, "links": links.blocks,
                                               "minimum": soft.minimum if soft else [[]],
                                               "nose": soft.nose if soft else [[]],
                                               "folds": soft.at_folds if soft else [[]]})
    label = "Load against minus the approach for several Tabor parameters, with reference markers"
    return Figure("fig03", NUMBER, TITLE, Markup(svg.embeddable(drawn, "fig03", label, links)),
                  caption(case, marks, dots, crosses, said, soft),
                  remarks(case, points, lines, marks, dots), case.record["command"])


def caption(case, marks, dots, crosses, said, soft):
    text = Markup("Dimensionless load W̄ against the approach {}Δ†. Lines: branches computed with {}. "
                  "They turn back at the folds of the approach.").format(MINUS, twice.how(case))
    if marks:
        text += Markup(" Open markers: Feng’s problem, solved independently (see the note on "
                       "Feng’s points).")
    if crosses:
        text += " Crosses: Feng’s own points, read off his figure."
    if dots:
        text += " Yellow dots: Bradley’s rigid solution, to compare with the branch for the smallest μ."
    if said[0]:
        text += Markup(" (b) Absolute distance of the reference points from the computed branch, "
                       "along its normal, in units of the axes; at most {}").format(greatest(said[0]))
        if said[1]:
            text += Markup(". Orange: with the paper’s discretisation ({1}); at most {0}; {2}").format(
                greatest(said[1]), twice.PAPER, twice.CUT_WORDS)
        text += "."
    if soft:
        text += Markup(
            " μ = {}, which this figure of the paper does not show, (c) about the pull-off and (d) about the jump out of "
            "contact. With panels (black) the branch has {} folds. With the paper’s discretisation (orange) the contact edge "
            "advances by one element of {} ε at a time, and the load oscillates. Where the branch is steep, each oscillation "
            "is a pair of folds (dots), and the branch has {} folds. From one pair to the next the contact radius changes by "
            "{} to {} ε, one element. The {} folds that panels do not find are spurious.").format(
                plain(soft.tabor), soft.folds[0], plain(soft.element), soft.folds[1],
                *(f"{value:.3f}" for value in soft.hop), soft.folds[1] - soft.folds[0])
    return text


def greatest(said):
    return listing(Markup("{} for μ = {}").format(scientific(value), plain(tabor)) for tabor, value in said)


def remarks(case, points, lines, marks, dots):
    made = twice.remarks(case, failures)
    bare = [point["label"] for point in points if not point.get("curve")]
    if bare:
        made.append(f"The record has no curve of {listing(bare)}.")
    if lines and not marks:
        made.append(f"The reference curves ({CURVES}) are not available, so no markers are drawn.")
    if lines and not dots:
        made.append(f"Bradley’s solution ({BRADLEY}) is not available, so its dots are not drawn.")
    return made
