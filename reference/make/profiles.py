"""Profiles: the initial gap f(r) of two bodies that touch at one point or on a disc, one class each.

Lengths are in units of epsilon; in_units_of(width) is the same profile with its radii in units of width.

    gap(r)      f
    slope(r)    df/dr
    kinks       radii where f is not smooth as a function of r^2: the panels are graded towards them
    grading     the halvings that a kink takes, over those of a jump of the slope
    growth      f ~ r^growth far out; None: the profile ends
    extent      the radius where the profile ends (inf: never)
"""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from scipy.interpolate import CubicSpline


@dataclass(frozen=True)
class Sphere:
    """f = curvature r^2/2."""
    curvature: float
    kinks = ()
    grading = 1.0
    growth = 2.0
    extent = np.inf

    def gap(self, r):
        return 0.5 * self.curvature * r**2

    def slope(self, r):
        return self.curvature * r

    def in_units_of(self, width):
        return Sphere(self.curvature * width**2)


@dataclass(frozen=True)
class Power:
    """f = factor r^growth; the cone has growth 1."""
    factor: float
    growth: float
    grading = 1.0
    extent = np.inf

    def __post_init__(self):
        if not (self.factor > 0.0 and self.growth >= 1.0):
            raise ValueError(f"power:{self.factor:g},{self.growth:g}: expected C > 0, n >= 1")

    @property
    def kinks(self):
        return () if self.growth % 2.0 == 0.0 else (0.0,)

    def gap(self, r):
        return self.factor * r**self.growth

    def slope(self, r):
        return self.factor * self.growth * r**(self.growth - 1.0)

    def in_units_of(self, width):
        return Power(self.factor * width**self.growth, self.growth)


@dataclass(frozen=True)
class Punch:
    """Flat up to `flat`; beyond it f = curvature (r - flat)^2/2: the edge is rounded by a parabola."""
    flat: float
    curvature: float
    grading = 0.6             # the curvature jumps
    growth = 2.0
    extent = np.inf

    def __post_init__(self):
        if not (self.flat > 0.0 and self.curvature > 0.0):
            raise ValueError(f"flat {self.flat:g}, curvature {self.curvature:g}: expected both > 0")

    @property
    def kinks(self):
        return (self.flat,)

    def gap(self, r):
        return 0.5 * self.curvature * np.maximum(r - self.flat, 0.0)**2

    def slope(self, r):
        return self.curvature * np.maximum(r - self.flat, 0.0)

    def in_units_of(self, width):
        return replace(self, flat=self.flat / width, curvature=self.curvature * width**2)


@dataclass(frozen=True)
class Truncated(Punch):
    """A sphere cut flat: f = curvature (r^2 - flat^2)/2 for r > flat, else 0."""
    grading = 1.0

    def gap(self, r):
        return 0.5 * self.curvature * np.maximum((r - self.flat) * (r + self.flat), 0.0)

    def slope(self, r):
        return np.where(np.asarray(r) > self.flat, self.curvature * r, 0.0)


@dataclass(frozen=True)
class ExactSphere:
    """radius - sqrt(radius^2 - r^2) up to 1023/1024 radius, beyond it the parabola of the same value and slope; times a
    length."""
    radius: float
    length: float = 1.0
    grading = 0.6             # the curvature jumps
    growth = 2.0
    extent = np.inf

    def __post_init__(self):
        if not self.radius > 0.0:
            raise ValueError(f"exact_sphere:{self.radius:g}: expected R > 0")

    @property
    def end(self):
        return 1023 / 1024 * self.radius

    @property
    def kinks(self):
        return (self.end,)

    def height(self, r):
        return np.sqrt((self.radius - r) * (self.radius + r))

    def gap(self, r):
        inner = np.minimum(r, self.end)
        more = np.maximum((r - self.end) * (r + self.end), 0.0) / (2.0 * self.height(self.end))
        return self.length * (inner**2 / (self.radius + self.height(inner)) + more)

    def slope(self, r):
        return self.length * r / self.height(np.minimum(r, self.end))

    def in_units_of(self, width):
        return replace(self, radius=self.radius / width, length=self.length * width)


@dataclass(frozen=True)
class Hyperboloid:
    """factor (sqrt(r^2 + tip^2) - tip): a cone with a blunt tip."""
    factor: float
    tip: float
    kinks = ()
    grading = 1.0
    growth = 1.0
    extent = np.inf

    def __post_init__(self):
        if not (self.factor > 0.0 and self.tip > 0.0):
            raise ValueError(f"hyperboloid:{self.factor:g},{self.tip:g}: expected both > 0")

    def gap(self, r):
        return self.factor * r**2 / (np.hypot(r, self.tip) + self.tip)

    def slope(self, r):
        return self.factor * r / np.hypot(r, self.tip)

    def in_units_of(self, width):
        return Hyperboloid(self.factor * width, self.tip / width)


@dataclass(frozen=True)
class Table:
    """Rows (r, f) joined by a cubic spline, level at r = 0."""
    spline: CubicSpline
    width: float = 1.0
    kinks = ()
    grading = 1.0
    growth = None

    @classmethod
    def read(cls, path):
        rows = np.loadtxt(Path(path), delimiter=",", ndmin=2)
        if rows[0, 0] != 0.0 or not (np.diff(rows[:, 0]) > 0.0).all() or not np.isfinite(rows).all():
            raise ValueError(f"{path}: expected finite rows r,f with r rising from 0")
        return cls(CubicSpline(rows[:, 0], rows[:, 1], bc_type=((1, 0.0), "not-a-knot")))

    @property
    def extent(self):
        return self.spline.x[-1] / self.width

    def gap(self, r):
        return self.spline(np.asarray(r) * self.width)

    def slope(self, r):
        return self.spline(np.asarray(r) * self.width, 1) * self.width

    def in_units_of(self, width):
        return replace(self, width=self.width * width)


@dataclass(frozen=True)
class Wave:
    """amplitude (1 - cos(number r)); number = 2 pi/wavelength."""
    amplitude: float
    number: float

    def gap(self, r):
        return 2.0 * self.amplitude * np.sin(0.5 * self.number * r)**2

    def slope(self, r):
        return self.amplitude * self.number * np.sin(self.number * r)

    def in_units_of(self, width):
        return replace(self, number=self.number * width)


@dataclass(frozen=True)
class Waved:
    """A profile with waves on it."""
    base: object
    waves: tuple

    def gap(self, r):
        gap = self.base.gap(r)
        for wave in self.waves:
            gap = gap + wave.gap(r)
        return gap

    def slope(self, r):
        return self.base.slope(r) + sum(wave.slope(r) for wave in self.waves)

    def in_units_of(self, width):
        return Waved(self.base.in_units_of(width), tuple(wave.in_units_of(width) for wave in self.waves))

    @property
    def kinks(self):
        return self.base.kinks

    @property
    def grading(self):
        return self.base.grading

    @property
    def growth(self):
        return self.base.growth

    @property
    def extent(self):
        return self.base.extent


MAKERS = {
    "power": Power,
    "cone": lambda slope: Power(slope, 1.0),
    "punch": lambda flat, radius: Punch(flat, 1.0 / radius),
    "truncated": lambda flat, radius: Truncated(flat, 1.0 / radius),
    "exact_sphere": ExactSphere,
    "hyperboloid": Hyperboloid,
}


def profile_of(text, waves="-", radius="-"):
    """The profile of `sphere` (of that radius), `power:C,n`, `cone:t`, `punch:b,R`, `truncated:b,R`, `exact_sphere:R`,
    `hyperboloid:t,b` or `table:FILE`, with the waves `A@L;A@L...` ("-": none). In a table `;` stands for the commas."""
    name, _, rest = text.partition(":")
    if name == "sphere":
        base = Sphere(1.0 / float(radius))
    elif name == "table":
        base = Table.read(rest)
    else:
        try:
            base = MAKERS[name](*(float(word) for word in rest.replace(";", ",").split(",")))
        except (KeyError, TypeError):
            raise ValueError(f"profile {text}: expected sphere, power:C,n, cone:t, punch:b,R, truncated:b,R, "
                             "exact_sphere:R, hyperboloid:t,b or table:FILE") from None
    if waves == "-":
        return base
    pairs = [[float(word) for word in wave.split("@")] for wave in waves.split(";")]
    return Waved(base, tuple(Wave(amplitude, 2.0 * np.pi / length) for amplitude, length in pairs))
