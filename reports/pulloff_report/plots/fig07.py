"""Figure 7: pull-off of the rigid wavy sphere against alpha, with Rumpf and Rabinowicz."""

import math

from markupsafe import Markup

from .. import gnuplot, svg
from ..words import scientific
from . import twice
from .figure import Figure, log_range

NUMBER = "7"
TITLE = "Rigid pull-off against α"
PULL_OFF = "rigid_pull_off.csv"
KEYS = ("amplitude", "alpha")


def residuals(case, stored):
    """Rows (α, |force / Eq 22 − 1|)."""
    found = []
    for (amplitude, alpha), (force, _) in twice.rows(case, KEYS).items():
        expected = twice.match(stored, (amplitude, alpha))
        if expected:
            found.append((alpha, max(abs(force / expected - 1.0), 1e-16)))
    return sorted(found)


def apart(ends, factor):
    """Heights of the labels at the ends of lines; neighbours differ at least by the factor."""
    places, free = {}, math.inf
    for index in sorted(range(len(ends)), key=lambda i: -ends[i]):
        places[index] = free = min(ends[index], free / factor)
    return [places[index] for index in range(len(ends))]


def logarithm(value):
    return f"{math.log10(value):.1f}".removesuffix(".0").replace("-", "−")


def make(case, references):
    table = references.table(PULL_OFF)
    drawn_amplitudes = {key[0] for key in twice.rows(case, KEYS)}
    blocks = {key: rows for key, rows in
              twice.table_blocks(table, ["amplitude"], "alpha", "force").items()
              if any(math.isclose(key[0], a, rel_tol=1e-9) for a in drawn_amplitudes)}
    stored = {(key[0], alpha): force for key, rows in blocks.items() for alpha, force in rows}
    fine = twice.table_blocks(case.line("rigid"), ["amplitude"], "alpha", "pull_off_force")
    lines = [sorted(twice.match(fine, key) or blocks[key]) for key in sorted(blocks)]
    marks = [(alpha, force) for (_, alpha), (force, _) in twice.rows(case, KEYS).items()]
    doubled = twice.table_blocks(case.line("rumpf_rabinowicz"), ["radius"], "alpha", "pull_off_force")
    printed = twice.table_blocks(case.line("rumpf_rabinowicz"), ["radius"], "alpha", "part_of_bradley")
    strips = [residuals(case, stored), residuals(case.companion, stored)]
    low, high = log_range([row[1] for strip in strips for row in strip])
    drawn = gnuplot.draw("fig07", {
        "figure_height": 460,
        "line_count": len(lines), "line_text": [f"{logarithm(key[0])}" for key in sorted(blocks)],
        "line_end": apart([rows[-1][1] for rows in lines], 1.45), "rumpf_count": len(doubled),
        "rumpf_text": [logarithm(key[0]) for key in sorted(doubled)],
        "rumpf_end": apart([doubled[key][-1][1] for key in sorted(doubled)], 1.45),
        "low": low, "high": high},
        {"rigid": lines or [[]], "computed": [marks],
         "doubled": [doubled[key] for key in sorted(doubled)] or [[]],
         "printed": [printed[key] for key in sorted(printed)] or [[]], "residual": strips})
    label = "Pull-off force of rigid wavy spheres against alpha on logarithmic axes"
    return Figure("fig07", NUMBER, TITLE, Markup(svg.embeddable(drawn, "fig07", label)),
                  caption(case, strips), twice.remarks(case), case.record["command"])


def caption(case, strips):
    text = Markup("Pull-off force |W̄| of the rigid wavy sphere against α = A R/λ². (a) Black lines: the minimum of "
                  "Eq 22; log₁₀ A† at the right ends. Blue squares: the "
                  "elastic solver at μ = 10⁻⁴, with {}. Green dashed lines: Rumpf and Rabinowicz, Eq 20, multiplied by two, because "
                  "Eq 20 is relative to Bradley’s 2πwR and the axis to πwR; log₁₀ R† at the right ends. "
                  "Thin dotted lines: Eq 20 as printed.").format(twice.how(case))
    if strips[0]:
        text += Markup(" (b) Relative difference from Eq 22, computed independently; blue: panels, at most {}").format(
            scientific(max(row[1] for row in strips[0])))
        if strips[1]:
            text += Markup(". Orange: with the paper’s discretisation ({}); at small α this is the cut, "
                           "1.0 × 10⁻³ of a force of 2; it is up to {} where the elements do not resolve the crest at the axis").format(
                               twice.PAPER, scientific(max(row[1] for row in strips[1])))
        text += "."
    return text
