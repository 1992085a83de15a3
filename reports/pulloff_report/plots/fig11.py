"""Figure 11: effective work of adhesion against the Johnson parameter, the data of Figure 10."""

from markupsafe import Markup

from .. import gnuplot, svg
from ..words import plain, value_of
from . import fig10, twice
from .figure import Figure

NUMBER = "11"
TITLE = "Effective work of adhesion against the Johnson parameter"
CASE = "fig10"
SHAPES = (6, 4, 8, 12)    # a wavelength
EFFECTIVE = 2.0 / 3.0     # w_eff/w over |W|/(pi w R): the left-hand side of Eq 24


def estimates(table):
    """Key values of a point -> (Johnson parameter, effective work) of a line."""
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
    below = sum(EFFECTIVE * force < beside[key][1][1] for key, force in forces.items() if beside[key][1])
    drawn = gnuplot.draw("fig11", {
        "wavelength_count": len(wavelengths), "radius_count": len(radii),
        "wavelength_text": [f"λ† = {plain(value)}" for value in wavelengths],
        "radius_text": [f"R† = {plain(value)}" for value in radii],
        "colour": list(fig10.COLOURS), "shape": list(SHAPES)},
        {"computed": blocks, "envelope": [sorted(envelope.values())],
         "tosatti": [sorted(row for row in tosatti.values() if row[1] > 0)]})
    label = "Effective work of adhesion against the Johnson parameter on logarithmic axes"
    return Figure("fig11", NUMBER, TITLE, Markup(svg.embeddable(drawn, "fig11", label)),
                  caption(case, blocks, below), twice.failed(case), case.record["command"])


def caption(case, blocks, below):
    text = Markup("The pull-off forces of Figure 10 as effective work of adhesion, 2|W̄|/3, against the Johnson "
                  "parameter α_KLJ, μ = {}. Markers: {}. Solid: Eq 24. Dash-dotted: Eq 30 where it is above 0.").format(
                      plain(case.points[0]["input"]["tabor"]), Markup(twice.how(case)))
    text += (f" {below} of {sum(map(len, blocks))} markers lie below Eq 30."
             if below else " No marker lies below Eq 30.")
    return text
