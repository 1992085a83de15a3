#!/usr/bin/env python3
"""JKR contact of a sphere with an axisymmetric waviness (Guduru, Eq 5): curves and pull-off.

    guduru.py --write [DIR]      regenerate guduru.csv, guduru_pull_off.csv, guduru_limit.csv
    guduru.py --sample           recompute a sample, compare (exit 1 on disagreement)

Routes: Eq 5 with Struve functions (mpmath), against the JKR/Abel contact integrals of the profile
f(r) = r^2/(2R) + A (1 - cos k r) taken directly by Gauss-Legendre quadrature.
Lengths in units of epsilon, loads divided by pi w R.
"""

import math
import sys
from functools import lru_cache

import numpy as np
from mpmath import cos, findroot, mpf, pi, sin, sqrt, struveh
from scipy.special import struve

from certified import INTERFACE_UNITS, PAPER, Table, command_line, text

DIGITS = 20

# tabor, amplitude, wavelength, radius
CURVES = [("5", "10", "20", "100"), ("3", "1", "20", "100"), ("4", "0.4", "10", "100"),
          ("4", "3", "10", "100"), ("0.7", "0.37", "7.3", "41"), ("3", "0", "20", "100")]
CONTACT_RADII = "0.01 0.1 0.37 0.5 0.75 1 1.25 1.5 2 2.03 2.5 3.1 4 5 6.6 8 10.5 13".split()  # /lambda

FIGURE_10 = [(wavelength, radius) for wavelength in ("5", "20", "30", "50")
             for radius in ("50", "100", "200")]
RATIOS = ("0.01", "0.03", "0.1", "0.3", "1")           # A/lambda
OTHERS = [("0.1", "1", "20", "100"), ("0.25", "0.05", "3.7", "17"), ("1", "1", "20", "100"),
          ("5", "0.1", "20", "100"), ("5", "1", "20", "100"), ("2.385", "0.7", "11", "250"),
          ("5", "5", "5", "100"), ("3", "0", "20", "100"), ("5", "0.05", "5", "100")]

# Scenes for the limit of the Lennard-Jones solution at large mu: smooth and gently wavy spheres.
LIMITS = ([(tabor, "0", "20", "100") for tabor in "2 3 5 7 10 14 20 30 50".split()]
          + [(tabor, amplitude, "10", "100") for tabor in ("5", "10", "20")
             for amplitude in ("0.02", "0.1", "0.4")])

KNOWN = (("5", "10", "20", "100"), "19.9243")           # pull-off force, as in the notes


def product(a, b):
    """The exact product of two decimal numbers, as text."""
    return text(mpf(a) * mpf(b), 12).removesuffix(".0")


def scenes():
    figure = [("3", product(ratio, wavelength), wavelength, radius)
              for wavelength, radius in FIGURE_10 for ratio in RATIOS]
    every = CURVES[:5] + figure + OTHERS
    return list(dict.fromkeys(every))


class Scene:
    """The dimensionless problem: modulus E* epsilon/w, waviness, radius."""

    def __init__(self, words):
        self.tabor, self.amplitude, self.wavelength, self.radius = (mpf(x) for x in words)
        self.modulus = sqrt(self.radius / self.tabor ** 3)
        self.number = 2 * pi / self.wavelength

    def adhesion(self, a):
        """sqrt(8 pi w E* a^3) and sqrt(2 pi a w/E*)."""
        return (sqrt(8 * pi * self.modulus * a ** 3) / (pi * self.radius),
                sqrt(2 * pi * a / self.modulus))

    def formula(self, a):
        """(load, approach, d load/d a) from Eq 5 with Struve functions, with the bracket in physical form."""
        x = self.number * a
        h0, h1 = struveh(0, x), struveh(1, x)
        load = self.modulus * (4 * a ** 3 / (3 * self.radius)
                               + pi * self.amplitude * a * (x * h0 - h1)) / (pi * self.radius)
        slope = self.modulus * (4 * a ** 2 / self.radius + pi * self.amplitude * x
                                * (h0 + x * (2 / pi - h1))) / (pi * self.radius)
        approach = a ** 2 / self.radius + pi / 2 * self.amplitude * x * h0
        return self.with_adhesion(a, load, approach, slope)

    def printed(self, a):
        """The load from Eq 5 as printed, with H2, which loses digits by cancellation. The printed
        "4 sqrt(beta) a^3" is read as 4 sqrt(beta a^3)."""
        alpha = self.amplitude * self.radius / self.wavelength ** 2
        beta = self.wavelength ** 3 * self.modulus / (2 * pi * self.radius ** 2)
        s = a / self.wavelength
        x = 2 * pi * s
        return 4 * beta * (2 * s ** 3 / 3 + alpha * (4 * pi ** 2 * s ** 3 / 3 + pi * s / 2 *
                           struveh(1, x) - pi ** 2 * s ** 2 * struveh(2, x))) \
            - 4 * sqrt(beta * s ** 3)

    def direct(self, a):
        """The same, directly from the profile: r = a sin(angle),

        delta_H = a int f'(r) d(angle), P_H = 2 E* int r^2 f'(r) d(angle),
        dP_H/da = 2 E* a d(delta_H)/da, d(delta_H)/da = int [f'(r) + r f''(r)] d(angle).
        """
        depth = load = rate = mpf(0)
        wave = self.amplitude * self.number
        pieces = 1 + int(self.number * a / 8)
        nodes = gauss_nodes()
        width = pi / 2 / pieces
        for piece in range(pieces):
            for node, weight in nodes:
                r = a * sin(width * (piece + node))
                phase = self.number * r
                first = r / self.radius + wave * sin(phase)
                second = 1 / self.radius + wave * self.number * cos(phase)
                depth += weight * first
                load += weight * r * r * first
                rate += weight * (first + r * second)
        scale = 2 * self.modulus / (pi * self.radius) * width
        return self.with_adhesion(a, scale * load, a * width * depth, scale * a * rate)

    def with_adhesion(self, a, load, approach, slope):
        load_part, depth_part = self.adhesion(a)
        return load - load_part, approach - depth_part, slope - 3 * load_part / (2 * a)

    def contact_bound(self):
        """A contact radius beyond which the load is positive, so that no minimum in tension lies there.

        |x H0 - H1| <= x (|Y0| + 2/(pi x)) + |H1| < 1.2 sqrt(x) + 2 for every x.
        """
        a = self.wavelength
        while True:
            wave = pi * self.amplitude * a * (1.2 * sqrt(self.number * a) + 2)
            least = self.modulus * (4 * a ** 3 / (3 * self.radius) - wave) / (pi * self.radius)
            if least > self.adhesion(a)[0]:
                return a
            a *= 1.1

    def pull_off(self, slope):
        """Contact radius of the global minimum of the load. The lowest few minima of a scan in double
        precision (40 points per wavelength, geometric near 0) are refined."""
        last = float(self.contact_bound())
        step = float(self.wavelength) / 40
        a = np.concatenate([np.geomspace(1e-6 * step, step, 200)[:-1], np.arange(step, last, step)])
        e, k, amplitude, radius = map(float, (self.modulus, self.number, self.amplitude, self.radius))
        x = k * a
        load = (e * (4 * a ** 3 / (3 * radius)
                     + math.pi * amplitude * a * (x * struve(0, x) - struve(1, x)))
                - np.sqrt(8 * math.pi * e * a ** 3)) / (math.pi * radius)
        lowest = [i for i in range(1, len(a) - 1) if load[i - 1] >= load[i] <= load[i + 1]]
        lowest = sorted(lowest, key=lambda i: load[i])[:4]
        roots = [minimum(slope, mpf(a[i - 1]), mpf(a[i + 1])) for i in lowest]
        return min(roots, key=lambda root: self.formula(root)[0])


@lru_cache(maxsize=1)
def gauss_nodes(count=60):
    """Gauss-Legendre nodes and weights on 0..1, by Newton's method from those in double precision."""
    result = []
    for guess in np.polynomial.legendre.leggauss(count)[0]:
        z = mpf(guess)
        for _ in range(4):
            previous, value = mpf(1), z
            for n in range(2, count + 1):
                previous, value = value, ((2 * n - 1) * z * value - (n - 1) * previous) / n
            derivative = count * (z * value - previous) / (z * z - 1)
            z -= value / derivative
        result.append(((1 + z) / 2, 1 / ((1 - z * z) * derivative ** 2)))
    return result


def minimum(slope, low, high):
    """Zero of the slope between two radii."""
    return findroot(slope, (low, high), solver="anderson", tol=mpf(10) ** -60, maxsteps=60,
                    verify=False)


def curve_row(point, agreement):
    words, index, ratio = point
    scene = Scene(words)
    a = mpf(ratio) * scene.wavelength
    load, approach, _ = scene.formula(a)
    scale = abs(load) + scene.adhesion(a)[0]
    other_load, other_approach, _ = scene.direct(a)
    label = f"Eq 5 {words}, contact radius {ratio} lambda"
    agreement.check(label + ", load", load, other_load, scale)
    agreement.check(label + ", printed form", load, scene.printed(a), scale)
    agreement.check(label + ", approach", approach, other_approach,
                    abs(approach) + scene.adhesion(a)[1])
    return [*words, str(index), product(ratio, words[2]), text(approach, DIGITS),
            text(load, DIGITS)]


def pull_off_row(point, agreement):
    scene = Scene(point)
    a = scene.pull_off(lambda a: scene.formula(a)[2])
    load, approach, _ = scene.formula(a)
    near = a * mpf("1e-4")
    other_a = minimum(lambda a: scene.direct(a)[2], a - near, a + 2 * near)
    other_load, other_approach, _ = scene.direct(other_a)
    label = f"pull-off {point}"
    agreement.check(label + ", contact radius", a, other_a)
    agreement.check(label + ", load", load, other_load)
    agreement.check(label + ", approach", approach, other_approach, abs(approach) + 1)
    return [*point, text(a, DIGITS), text(-load, DIGITS), text(approach, DIGITS)]


def known():
    """Compares the known value, and the smooth limit (Eqs 7-8): 3/2 at -0.77341693157 tabor."""
    scene = Scene(KNOWN[0])
    force = -scene.formula(scene.pull_off(lambda a: scene.formula(a)[2]))[0]
    if abs(force - mpf(KNOWN[1])) > mpf("5e-5"):
        raise ValueError(f"pull-off {KNOWN[0]}: {text(force, 8)}, not {KNOWN[1]}")
    scene = Scene(("3", "0", "20", "100"))
    load, approach, _ = scene.formula(scene.pull_off(lambda a: scene.formula(a)[2]))
    if abs(load + mpf("1.5")) > mpf("1e-30") or abs(approach / 3 + mpf("0.77341693157")) > 1e-11:
        raise ValueError("the smooth limit is not JKR")


def header(what, command_evidence):
    return {
        "what": what,
        "source": f"{PAPER}, Eqs 5-8, after P. R. Guduru, J. Mech. Phys. Solids 55, 445 (2007); the "
                  "adhesive term read as 4 sqrt(beta a^3), as Eq 7 shows",
        "kind": "oracle",
        "method": "Eq 5 with mpmath Struve functions, 40 digits carried, against the JKR/Abel contact "
                  "integrals of the profile by Gauss-Legendre quadrature (60 nodes every 8 of k a)",
        "units": INTERFACE_UNITS,
        "uncertainty": f"half a unit of digit {DIGITS}",
        "evidence": command_evidence,
        "generator": "reference/make/guduru.py",
        "command": "python3 reference/make/guduru.py --write",
    }


TABLES = [
    Table("guduru.csv",
          ["tabor", "amplitude", "wavelength", "radius", "index", "contact_radius", "approach", "load"],
          [(scene, i + 1, ratio) for scene in CURVES for i, ratio in enumerate(CONTACT_RADII)],
          curve_row,
          header("load and approach against contact radius of the JKR contact, Eq 5",
                 "Struve form, printed form of Eq 5 and direct integration for every row"),
          limit="1e-25", tolerance="1e-19", stride=10),
    Table("guduru_pull_off.csv",
          ["tabor", "amplitude", "wavelength", "radius", "contact_radius", "force", "approach"],
          scenes(), pull_off_row,
          header("pull-off (global minimum of the load over every contact radius) of the JKR contact, "
                 "Eq 5",
                 "zero of the slope found on both routes; global: every local minimum of a scan up to "
                 "a contact radius beyond which the load is provably positive"),
          limit="1e-22", tolerance="1e-19", stride=16, checks=known),
    Table("guduru_limit.csv",
          ["tabor", "amplitude", "wavelength", "radius", "contact_radius", "force", "approach"],
          LIMITS, pull_off_row,
          header("pull-off of the JKR contact, Eq 5, of scenes whose Lennard-Jones solution tends to it "
                 "as the Tabor parameter grows",
                 "zero of the slope found on both routes; global: as guduru_pull_off.csv"),
          limit="1e-22", tolerance="1e-19", stride=8),
]


if __name__ == "__main__":
    sys.exit(command_line(__doc__, TABLES))
