"""Figures 1 and 5: sketches, their profiles drawn from the formulas and from no run."""

from markupsafe import Markup

from .. import gnuplot, svg
from .figure import Figure


class Sketch:
    """One sketch: figures/<script>.gp draws it without data."""
    SCHEMATIC = True

    def __init__(self, script, number, title, caption):
        self.script, self.NUMBER, self.TITLE, self.caption = script, number, title, caption

    def make(self, _case, _references):
        drawn = gnuplot.draw(self.script, {"figure_height": 260}, {})
        return Figure(self.script, self.NUMBER, self.TITLE,
                      Markup(svg.embeddable(drawn, self.script, self.TITLE)), Markup(self.caption))


FIG01 = Sketch(
    "fig01", "1", "Geometry of the contact",
    "A rigid sphere of radius R above a half-space with an axisymmetric waviness of wavelength λ and "
    "amplitude A, Eq 1, which is 2A from crest to trough. The sphere is drawn as its Hertzian profile "
    "r²/2R. A sketch, not to scale.")
FIG05 = Sketch(
    "fig05", "5", "The models of Rumpf and Rabinowicz and of Guduru",
    "Left: Rumpf and Rabinowicz, a sphere of radius R on a hemisphere of radius r₂ on a plane. Right: "
    "Guduru, the sphere on the crest of a wavy surface, whose radius of curvature is "
    "r₂ = λ²/(4π²A), Eq 18. A sketch, not to scale.")
