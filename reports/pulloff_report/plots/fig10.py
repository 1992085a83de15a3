"""Figure 10: pull-off against A/lambda for twelve wavy spheres, with the JKR lines of Eq 5."""

from markupsafe import Markup

from .. import gnuplot, live, svg
from ..words import count, listing, plain, scientific, value_of
from . import preload, twice
from .figure import BLUE, GREEN, VERMILLION, Figure, log_range

NUMBER = "10"
TITLE = "Pull-off against A/λ for twelve wavy spheres"
KEYS = ("wavelength", "radius", "amplitude_ratio")
COLOURS = (VERMILLION, GREEN, BLUE)   # of the radii
SHAPES = (6, 4, 8, 12)    # of the wavelengths
ENDS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5)   # lower ends of the axis, where unsolved scenes are marked


def blocks_of(found, groups):
    return [sorted((key[2], value) for key, value in found.items() if key[:2] == group)
            for group in groups]


def floor_of(values):
    """The lower end of an axis that contains the values."""
    least = min(values, default=1.0)
    return max((end for end in ENDS if end < 0.9 * least), default=ENDS[0])


def make(case, references):
    forces = {key: value[0] for key, value in twice.rows(case, KEYS).items()}
    groups = sorted({tuple(value_of(point, key) for key in KEYS[:2]) for point in case.points})
    wavelengths = sorted({group[0] for group in groups})
    radii = sorted({group[1] for group in groups})
    floors = [floor_of(force for key, force in forces.items() if key[0] == wavelength) for wavelength in wavelengths]
    missing = {tuple(value_of(point, key) for key in KEYS): floors[wavelengths.index(value_of(point, "wavelength"))] for point in case.unsolved_points()}
    guduru = twice.table_blocks(case.line("guduru"), KEYS[:2], KEYS[2], "pull_off_force")
    links = live.Links(1 + len(wavelengths))   # of (a), then of each panel of (b)
    for (wavelength, _, ratio), point in twice.solved(case, KEYS):
        for block in (0, 1 + wavelengths.index(wavelength)):
            links.add(block, [(ratio, point["pull_off"]["force"])], point)
    strips = blocks_of(twice.differences(case, KEYS, relative=True) if case.companion else {}, groups)
    low, high = log_range([row[1] for strip in strips for row in strip])
    drawn = gnuplot.draw("fig10", {
        "figure_height": 815, "panel_count": len(wavelengths), "radius_count": len(radii),
        "panel_text": [f"λ† = {plain(value)}" for value in wavelengths],
        "radius_text": [f"R† = {plain(value)}" for value in radii],
        "colour": list(COLOURS), "form": list(SHAPES), "missing": len(missing),
        "low": low, "high": high, "floor": min(floors, default=ENDS[0]), "floors": floors},
        {"computed": blocks_of(forces, groups), "harder": blocks_of(preload.larger(case, KEYS), groups),
         "missing": blocks_of(missing, groups),
         "guduru": [guduru.get(group, []) for group in groups], "difference": strips, "links": links.blocks})
    label = "Pull-off force against amplitude over wavelength, one panel for each wavelength"
    return Figure("fig10", NUMBER, TITLE, Markup(svg.embeddable(drawn, "fig10", label, links)),
                  caption(case, forces, missing, strips), twice.remarks(case), case.record["command"])


def caption(case, forces, missing, strips):
    best = max(forces, key=forces.get)
    text = Markup("Pull-off force |W̄| against A/λ at μ = {}: (a) one panel for each wavelength; (b) all twelve spheres, as in the "
                  "paper. Markers: computed with {}; the dash-dotted lines connect them. Dashed lines: JKR, Eq 5. The largest marker is {} at λ† = {}, R† = {}, A/λ = {}; for the maximum between the markers see the claim <a href=\"#claim-fig10-greatest\">fig10-greatest</a>.").format(
                      plain(case.points[0]["input"]["tabor"]), twice.how(case),
                      f"{forces[best]:.2f}", plain(best[0]), plain(best[1]), plain(best[2]))
    if missing:
        text += Markup(" Crosses at the lower edge of (a): {} not solved (listed below).").format(
            count(len(missing), "scene"))
    worst = [row[1] for strip in strips for row in strip]
    if worst:
        ratios = sorted({row[0] for strip in strips for row in strip})
        text += Markup(" (c) Relative difference from the paper’s discretisation ({}) at A/λ = {}; at most {}; at small A/λ it is the cut, which leaves out (8/3)/(1 + R†/2)² πwR.").format(
                           twice.PAPER, listing([plain(value) for value in ratios]), scientific(max(worst)))
    return text + preload.caption(case, KEYS, "Filled markers in (a)")
