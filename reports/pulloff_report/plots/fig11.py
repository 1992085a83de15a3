"""Figure 11: effective work of adhesion against the Johnson parameter, the data of Figure 10."""

from markupsafe import Markup

from .. import gnuplot, svg
from ..words import listing, plain, value_of
from . import fig10, preload, twice
from .figure import Figure

NUMBER = "11"
TITLE = "Effective work of adhesion against the Johnson parameter"
CASE = "fig10"
CLEAR = 0.02              # a marker is filled if it is below Eq 30 by more than this fraction
EFFECTIVE = 2.0 / 3.0     # w_eff/w over |W|/(pi w R): the left-hand side of Eq 24


def estimates(table):
    """Key values of a point -> (Johnson parameter, effective work) of a closed-form line."""
    if table is None:
        return {}
    names = [*fig10.KEYS, "johnson_parameter", "effective_work"]
    return {tuple(float(v) for v in row[:3]): (float(row[3]), float(row[4]))
            for row in zip(*(table.numbers(name) for name in names))}


def make(case, references):
    forces = {key: value[0] for key, value in twice.rows(case, fig10.KEYS).items()}
    envelope, tosatti = (estimates(case.line(name)) for name in ("kesari_lew", "persson_tosatti"))
    groups = sorted({tuple(value_of(point, key) for key in fig10.KEYS[:2]) for point in case.points})
    wavelengths, radii = sorted({g[0] for g in groups}), sorted({g[1] for g in groups})
    beside = {key: (twice.match(envelope, key), twice.match(tosatti, key)) for key in forces}
    blocks = [sorted((beside[key][0][0], EFFECTIVE * force) for key, force in forces.items()
                     if key[:2] == group and beside[key][0]) for group in groups]
    below = shortfalls(forces, {key: row[1] for key, row in beside.items() if row[1]})
    clear = [sorted((beside[key][0][0], EFFECTIVE * forces[key]) for key, part in below.items()
                    if key[:2] == group and part > CLEAR) for group in groups]
    harder = {key: force for key, force in preload.larger(case, fig10.KEYS).items() if twice.match(envelope, key)}
    drawn = gnuplot.draw("fig11", {
        "wavelength_count": len(wavelengths), "radius_count": len(radii),
        "wavelength_text": [f"λ† = {plain(value)}" for value in wavelengths],
        "radius_text": [f"R† = {plain(value)}" for value in radii],
        "floors": [fig10.floor_of(row[1] for group, rows in zip(groups, blocks) if group[0] == value for row in rows) for value in wavelengths],
        "figure_height": 460, "colour": list(fig10.COLOURS), "shape": list(fig10.SHAPES)},
        {"computed": blocks, "clear": clear,
         "harder": [sorted((twice.match(envelope, key)[0], EFFECTIVE * force) for key, force in harder.items()
                           if key[:2] == group) for group in groups], "envelope": [sorted(envelope.values())],
         "tosatti": [sorted(row for row in tosatti.values() if row[1] > 0)]})
    label = "Effective work of adhesion against the Johnson parameter on logarithmic axes"
    return Figure("fig11", NUMBER, TITLE, Markup(svg.embeddable(drawn, "fig11", label)),
                  caption(case, blocks, below, groups, clear), twice.failed(case), case.record["command"])


def shortfalls(forces, bounds):
    """Key values -> relative difference from Eq 30, for the forces below it."""
    parts = {key: 1 - EFFECTIVE * forces[key] / row[1] for key, row in bounds.items() if row[1] > 0}
    return {key: part for key, part in parts.items() if part > 0}


def name_of(group):
    return f"λ† = {plain(group[0])}, R† = {plain(group[1])}"


def caption(case, blocks, below, groups, clear):
    text = Markup("The pull-off forces of Figure 10 as effective work of adhesion, 2|W̄|/3, against the Johnson "
                  "parameter α<sub>KLJ</sub>; μ = {}; one panel for each wavelength. Markers: computed with {}. Solid line: Eq 24. Dash-dotted line: Eq 30 where it is positive.").format(
                      plain(case.points[0]["input"]["tabor"]), twice.how(case))
    text += f" All scenes are {preload.declared(case)}, as in Figure 10."
    if case.any_preload:
        text += " Crosses: the largest force at any preload, where it is larger."
    if not below:
        return text + " No marker lies below Eq 30."
    text += f" {len(below)} of {sum(map(len, blocks))} markers lie below Eq 30"
    many = [f"{len(rows)} of {name_of(group)}" for group, rows in zip(groups, clear) if rows]
    if not many:
        return text + f", none by more than {CLEAR:.0%}."
    return text + f"; by more than {CLEAR:.0%} (filled): {listing(many)}."
