"""Figure 8: pull-off of three wavy spheres against the Tabor parameter, rigid and JKR limits."""

from markupsafe import Markup

from .. import gnuplot, live, svg
from ..words import listing, plain, scientific
from . import preload, twice
from .figure import BLUE, GREEN, VERMILLION, Figure, log_range

NUMBER = "8"
TITLE = "Pull-off of three wavy spheres against the Tabor parameter"
KEYS = ("amplitude", "tabor")
COLOURS, SHAPES = (VERMILLION, GREEN, BLUE), (6, 4, 8)
TOP = 5.0                 # end of the linear axis, above the largest computed force


def by_amplitude(found, amplitudes=None):
    """The amplitudes (those given, or all), and for each a block of rows (μ, value)."""
    amplitudes = amplitudes or sorted({key[0] for key in found})
    return amplitudes, [sorted((tabor, value) for (amplitude, tabor), value in found.items()
                               if amplitude == wanted) for wanted in amplitudes]


def make(case, references):
    amplitudes, marks = by_amplitude({key: value[0] for key, value in twice.rows(case, KEYS).items()})
    _, harder = by_amplitude(preload.larger(case, KEYS), amplitudes)
    links = live.Links()
    for (_, tabor), point in twice.solved(case, KEYS):
        links.add(0, [(tabor, point["pull_off"]["force"])], point)
    _, strips = by_amplitude(twice.differences(case, KEYS) if case.companion else {})
    guduru = twice.table_blocks(case.line("guduru"), ["amplitude"], "tabor", "pull_off_force")
    rigid = {key: rows[0][1] for key, rows in
             twice.table_blocks(case.line("rigid"), ["amplitude"], "amplitude", "pull_off_force").items()}
    last = guduru[max(guduru)][-1] if guduru else (5.0, float("nan"))
    low, high = log_range([row[1] for strip in strips for row in strip])
    drawn = gnuplot.draw("fig08", {
        "count": len(amplitudes), "rigid_count": len(rigid), "guduru_count": len(guduru),
        "strip_count": len(strips), "colour": list(COLOURS), "shape": list(SHAPES),
        "text": [f"A† = {plain(value)}" for value in amplitudes],
        "rigid": [rigid[key] for key in sorted(rigid)], "top": TOP, "last_tabor": last[0], "last": last[1],
        "above": 2.0 * max((row[1] for rows in guduru.values() for row in rows), default=50.0),
        "figure_height": 470, "low": low, "high": high, "cut": twice.CUT},
        {"computed": marks or [[]], "harder": harder or [[]], "guduru": [guduru[key] for key in sorted(guduru)] or [[]],
         "difference": strips or [[]], "links": links.blocks})
    label = "Pull-off force against the Tabor parameter for three amplitudes"
    return Figure("fig08", NUMBER, TITLE, Markup(svg.embeddable(drawn, "fig08", label, links)),
                  caption(case, amplitudes, strips, last), twice.remarks(case), case.record["command"])


def caption(case, amplitudes, strips, last):
    text = Markup("Pull-off force |W̄| against the Tabor parameter μ for λ† = 20, R† = 100 and A† = {}. "
                  "(b) Markers: computed with {}. Dash-dotted lines: rigid limit, Eq 22. Dashed lines: JKR limit, Eq 5, continued "
                  "in (a) on a logarithmic axis; for A† = {} it is {} at μ = {} (circle).").format(
                      listing([plain(value) for value in amplitudes]), twice.how(case),
                      plain(amplitudes[-1]) if amplitudes else "–", f"{last[1]:.3f}", plain(last[0]))
    if strips:
        worst = max(row[1] for strip in strips for row in strip)
        text += Markup(" (c) Absolute difference from the paper’s discretisation "
                       "({}); at most {}; {}.").format(twice.PAPER, scientific(worst), twice.CUT_WORDS)
    return text + preload.caption(case, KEYS, "Filled markers")
