"""Figures 14 and 15: maps of the pull-off force over the Tabor parameter and A/λ."""

import dataclasses
import math

import contourpy
import numpy
from markupsafe import Markup

from .. import gnuplot, live, svg
from ..words import count, plain, ratio, scientific, value_of
from . import preload
from .figure import Figure, diverging, failures

# Contour levels of the force, dense about 1.5 (JKR) and 2 (Bradley).
LEVELS = (0.05, 0.1, 0.2, 0.35, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.0)
# Levels whose lines are drawn and labelled.
LABELLED = (0.1, 0.2, 0.5, 1.0, 1.5, 2.0, 3.0, 5.0, 7.0)
LEAST = 1e-9     # below all forces: the region above it is where the force is known
SHORTEST = 0.12  # length from which a line is labelled, relative to the width
APART = 0.13     # distance between labels, likewise; half of it from the frame
CLEAR = 0.03     # distance of a label from the dashed line
MARKED = 0.1     # A/λ above which, by the paper, the JKR theory fails
SMOOTH = 1.5     # force of the smooth sphere in the JKR limit: below it adhesion is reduced (blue), above it enhanced (orange)
GREATEST = 8.0   # end of the force axis at the sides


def place(point):
    """(μ, A/λ) of a point."""
    return value_of(point, "tabor"), float(f"{value_of(point, 'amplitude_ratio'):.6g}")


def forces(case):
    """(μ, A/λ) -> force of the wavy spheres."""
    return {place(point): point["pull_off"]["force"] for point in case.points
            if point.get("pull_off") and place(point)[1] > 0}


def forces_at_any_preload(case):
    """(μ, A/λ) -> largest force at any preload; and the scenes where a harder preload may give more."""
    known = {place(point): point["pull_off_any"] for point in case.points
             if point["status"] == "ok" and point.get("pull_off_any") and place(point)[1] > 0}
    return ({key: found["force"] for key, found in known.items()},
            [key for key, found in known.items() if not found["complete"]])


def rings(generator, level):
    """The region above a level as closed paths; a hole is joined to its outline by a line traversed twice."""
    polygons, offsets = generator.filled(level, math.inf)
    for points, ends in zip(polygons, offsets):
        path = points[:ends[1]].tolist()
        for begin, end in zip(ends[1:-1], ends[2:]):
            path += points[begin:end].tolist() + [path[0]]
        yield path


def label_place(line, taken, mark):
    """The straightest part of a line away from the frame, the dashed line at height mark, and other labels."""
    best, place = 0.0, None
    for k in range(3, len(line) - 3):
        x, y = line[k]
        if min(x, y, 1 - x, 1 - y) < APART / 2 or abs(y - mark) < CLEAR or any(math.hypot(x - a, y - b) < APART for a, b in taken):
            continue
        (ax, ay), (bx, by) = line[k - 3], line[k + 3]
        length = sum(math.dist(line[m], line[m + 1]) for m in range(k - 3, k + 3))
        straight = math.hypot(bx - ax, by - ay) / length if length else 0.0
        if straight > best + 0.02:
            best, place = straight, (x, y)
    return place


def contours(tabors, ratios, force, mark):
    """Filled regions (all known forces, then one for each level), and the lines with the places of their labels."""
    x, y = ([math.log(value / values[0]) / math.log(values[-1] / values[0]) for value in values]
            for values in (tabors, ratios))
    z = numpy.array([[math.log(force.get((t, r), math.nan)) for t in tabors] for r in ratios])
    generator = contourpy.contour_generator(x, y, numpy.ma.masked_invalid(z), fill_type="OuterOffset")
    regions, lines, taken, labels = [], [], [], []
    for level in (LEAST, *LEVELS):
        regions.append([row for path in rings(generator, math.log(level)) for row in path + [(math.nan,) * 2]])
    for level in LABELLED:
        for line in generator.lines(math.log(level)):
            line = line.tolist()
            length = sum(math.dist(a, b) for a, b in zip(line, line[1:]))
            lines += line + [(math.nan,) * 2]
            place = label_place(line, taken, mark) if length > SHORTEST else None
            if place:
                taken.append(place)
                labels.append((*place, level))
    return regions, lines, labels


def edge(case, name, columns):
    """Rows of a closed-form line of the case, with these columns."""
    table = case.line(name)
    return list(zip(*(table.numbers(column).tolist() for column in columns))) if table else []


def drawn(case, scenes, name, title, force, unknown=()):
    """One map of the scenes of a case; `unknown` are the scenes where the largest force is not known."""
    tabors, ratios = sorted({t for t, _ in force}), sorted({r for _, r in force})

    def height(ratio):
        return math.log(ratio / ratios[0]) / math.log(ratios[-1] / ratios[0])

    def width(tabor):
        return math.log(tabor / tabors[0]) / math.log(tabors[-1] / tabors[0])

    regions, lines, labels = contours(tabors, ratios, force, height(MARKED))
    rigid = [(f, height(r)) for r, f in edge(case, "rigid", ("amplitude_ratio", "pull_off_force"))]
    guduru = [(f, height(r)) for r, t, f in
              edge(case, "guduru", ("amplitude_ratio", "tabor", "pull_off_force"))
              if math.isclose(t, tabors[-1], rel_tol=1e-6) and f <= GREATEST]
    left, right = ([(force[t, r], height(r)) for r in ratios if (t, r) in force]
                   for t in (tabors[0], tabors[-1]))
    parameters = {
        "title_text": title, "unknown_count": len(unknown), "figure_height": 400,
        "level_count": len(LEVELS), "levels": [f"{level:g}" for level in LEVELS],
        "colours": diverging(sum(level <= SMOOTH for level in LEVELS), sum(level > SMOOTH for level in LEVELS) + 1),
        "label_count": len(labels), "label_x": [float(row[0]) for row in labels],
        "label_y": [float(row[1]) for row in labels], "label_text": [f"{row[2]:g}" for row in labels],
        "x_low": tabors[0], "x_high": tabors[-1], "y_low": ratios[0], "y_high": ratios[-1],
        "mark": height(MARKED), "greatest": GREATEST,
        "left_tabor": plain(tabors[0]), "right_tabor": plain(tabors[-1])}
    links = live.Cells([point for point in scenes.points if place(point) in force])
    data = {"regions": regions, "lines": [lines], "left": [rigid, left], "right": [guduru, right],
            "unknown": [[(width(t), height(r)) for t, r in unknown]], "links": links.blocks}
    label = f"Pull-off force over the Tabor parameter and A/λ, {title}"
    return Markup(svg.embeddable(gnuplot.draw("pull_off_map", parameters, data), name, label, links))


def make(case, references):
    force = forces(case)
    wavelength = case.points[0]["input"]["wavelength"]
    pictures = drawn(case, case, case.name, f"(a) {preload.declared(case)}", force)
    if case.any_preload:
        pictures += drawn(case, case.any_preload, case.name + "-any", "(b) at any preload", *forces_at_any_preload(case.any_preload))
    return Figure(case.name, case.figure, f"Map of the pull-off force, λ† = {plain(wavelength)}",
                  pictures, caption(case, wavelength, force), failures(case), case.record["command"], spots(case))


def spots(case):
    """(point, check) of the scenes that were computed by continuation and also traced, in the order of the map."""
    return [(case.point(check["point"]), check) for check in case.checks if check.get("reference") == "traced"]


def spot_words(found):
    """A sentence on the scenes that were computed in two ways."""
    ratios = [check["ratio"] for _, check in found if check["ratio"] is not None]
    if not ratios:
        return ""
    return Markup(" {} drawn at random were also traced; the largest difference is {} of its tolerance.").format(
        count(len(found), "scene"), ratio(max(ratios)))


def caption(case, wavelength, force):
    greatest = max(force, key=force.get)
    followed = sum(bool(point.get("followed")) for point in case.points)
    worst = max(point["pull_off"]["error_estimate"] / point["pull_off"]["force"]
                for point in case.points if point.get("pull_off"))
    tabors = sorted({t for t, _ in force})
    text = Markup(
        "Pull-off force |W̄| for λ† = {}, R† = 100, r<sub>max</sub> = R. (a) The paper does not state the preload; "
        "here all spheres are {}. The colour changes at each level of the bar, from blue, less than the 1.5 of the smooth sphere in the JKR limit, to orange, more; the largest force of the computed scenes is {} at "
        "μ = {}, A/λ = {}. Dashed line: "
        "A/λ = 0.1, above which, by the paper, the JKR theory fails. Left: the force at μ = {} (symbols) and the rigid limit, Eq 22 (line). "
        "Right: the force at μ = {} (symbols) and full contact, Eq 5 (line). Of {} scenes, {} were computed by parameter continuation between "
        "full traces; the largest stated error is {} of the force.").format(
            plain(wavelength), preload.declared(case), plain(round(force[greatest], 3)), plain(greatest[0]),
            plain(round(greatest[1], 4)), plain(tabors[0]), plain(tabors[-1]), len(case.points), followed,
            scientific(worst))
    text += spot_words(spots(case))
    if case.any_preload is None:
        return text + f" This run has no record of {case.name}_any, the map at any preload."
    most, unknown = forces_at_any_preload(case.any_preload)
    top = max(most, key=most.get)
    return text + (
        f" (b) The largest force at any preload, for {len(most)} scenes: its maximum is "
        f"{plain(round(most[top], 3))} at μ = {plain(top[0])}, A/λ = {plain(round(top[1], 4))}. Black dots: "
        f"preloads above 100 πwR may give a larger force ({len(unknown)} scenes). Blank: not computed, because steep waves on soft spheres "
        "take minutes.")


@dataclasses.dataclass(frozen=True)
class Map:
    """A figure that shares this module with another one."""
    NUMBER: str
    TITLE: str

    @staticmethod
    def make(case, references):
        return make(case, references)


FIG14 = Map("14", "Map of the pull-off force, λ† = 20")
FIG15 = Map("15", "Map of the pull-off force, λ† = 5")
