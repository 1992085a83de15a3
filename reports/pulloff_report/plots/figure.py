"""The result of a figure module, and functions that several modules use."""

import dataclasses
import math
import re

from markupsafe import Markup

from .. import svg as drawings

# The palette of Okabe and Ito, which colour-blind readers can distinguish.
BLUE, GREEN, VERMILLION, ORANGE = "#0072B2", "#009E73", "#D55E00", "#E69F00"
TALL = 0.9  # height of a figure over its width from which it has a page for itself
PURPLE, SKY, BLACK, GREY = "#CC79A7", "#56B4E9", "#000000", "#7A7A7A"


@dataclasses.dataclass
class Figure:
    """One drawn figure."""
    id: str
    number: str
    title: str
    svg: Markup
    caption: Markup
    remarks: list = dataclasses.field(default_factory=list)
    command: str = ""
    followed: list = dataclasses.field(default_factory=list)  # (point, check) of scenes computed in two ways
    letter: str = ""    # of a figure that the paper does not have

    @property
    def shape(self):
        """Height over width of the drawings, which stand one below the other."""
        boxes = [(float(width), float(height)) for width, height in
                 re.findall(r'viewBox="\S+ \S+ ([\d.]+) ([\d.]+)"', self.svg)]
        return sum(height / width for width, height in boxes)

    @property
    def unlinked(self):
        """The drawings without links to scenes."""
        return Markup(drawings.without_links(self.svg))

    @property
    def is_tall(self):
        """Whether the picture is about as tall as it is wide, so that it fills most of a page."""
        return self.shape > TALL


def diverging(below, above):
    """Colours of as many steps below a middle value, from dark to pale blue, and above it, from pale to dark orange."""
    import matplotlib
    import numpy
    shades = matplotlib.colors.LinearSegmentedColormap.from_list("diverging", [
        "#08306b", "#2f79b5", "#9ecae1", "#eef5fb", "#fff3e2", "#fdae6b", "#d9600e", "#6b2703"])
    return [matplotlib.colors.to_hex(shades(place)) for place in (*numpy.linspace(0.0, 3 / 7, below), *numpy.linspace(4 / 7, 1.0, above))]


def checks_of(case, point, quantity):
    """The checks of one quantity of one point."""
    return [check for check in case.checks
            if check["quantity"] == quantity and check.get("point") == point["id"]]


def tolerance_of(check):
    """The absolute tolerance of a check, or None if it is not known."""
    if check["tolerance"] is None:
        return None
    if check["kind"] == "abs":
        return check["tolerance"]
    if check["kind"] == "rel" and check["expected"]:
        return check["tolerance"] * abs(check["expected"])
    return None


def distinct(values, digits=3):
    """The distinct values other than None, ascending."""
    return sorted({float(f"{value:.{digits}g}") for value in values if value})


def failures(case):
    """A sentence for every point that was not solved."""
    return [f"{point['label']}: the solve ended with {point['status'].replace('_', ' ')}"
            + (f" ({point['reason']})" if point.get("reason") else "") + "."
            for point in case.unsolved_points()]


def log_range(values, floor=1e-16):
    """A range of whole decades that contains the positive values, as (low, high), with room above for a label."""
    positive = [value for value in values if value and value > 0 and math.isfinite(value)]
    if not positive:
        return 1e-9, 1e-3
    top = math.log10(max(positive))
    low = math.floor(math.log10(max(min(positive), floor)))
    high = max(math.ceil(top), low + 2)
    if high - top < 0.17 * (high - low):
        high += 1
    return 10.0 ** low, 10.0 ** high
