"""Figures 1 and 5: sketches, drawn from the formulas and without a run."""

from markupsafe import Markup

from .. import gnuplot, svg
from .figure import Figure


class Sketch:
    """A sketch, drawn by figures/<script>.gp without data."""
    SCHEMATIC = True

    def __init__(self, script, number, title, caption):
        self.script, self.NUMBER, self.TITLE, self.caption = script, number, title, caption

    def make(self, _case, _references):
        drawn = gnuplot.draw(self.script, {"figure_height": 180, "figure_width": 464}, {})
        return Figure(self.script, self.NUMBER, self.TITLE,
                      Markup(svg.embeddable(drawn, self.script, self.TITLE)), Markup(self.caption))


FIG01 = Sketch(
    "fig01", "1", "Geometry of the contact",
    "A rigid sphere of radius R above a half-space with an axisymmetric waviness of wavelength λ and "
    "amplitude A (Eq 1); the height from trough to crest is 2A. The sphere is drawn as a paraboloid, "
    "r²/2R. Not to scale.")
FIG05 = Sketch(
    "fig05", "5", "The models of Rumpf and Rabinowicz and of Guduru",
    "Left: Rumpf and Rabinowicz, a sphere of radius R on a hemisphere of radius r₂ on a plane. Right: "
    "Guduru, a sphere on the crest of a wavy surface with the radius of curvature "
    "r₂ = λ²/(4π²A), Eq 18. Not to scale.")
