#!/usr/bin/env python3
"""The pull-off of rigid bodies of any profile under any law.

    rigid_profiles.py --write [DIR]   regenerate rigid_profiles.csv
    rigid_profiles.py --sample        recompute a sample, compare (exit 1 on disagreement)

The load at approach D is int p(f(r) - D) 2 pi r dr; units and profiles as in jkr_profiles.py. Routes: Beta functions
(Mie) and Gamma functions (Morse), against quadrature over the radius.
"""

import sys

from mpmath import asin, beta, cos, diff, exp, findroot, gamma, mpf, pi, quad, sin, sqrt

from certified import Table, command_line, text
from jkr_profiles import DIGITS, Profile, header, numbers


class Law:
    """p(H) of `mie:m;n` or `morse:a` as a sum of terms (sign, factor, kind, exponent): factor (1+H)^-e or e^(-eH)."""

    def __init__(self, words):
        name, _, rest = words.partition(":")
        values = numbers(rest)
        self.mie = name == "mie"
        if self.mie:
            m, n = values
            k = (m - 1) * (n - 1) / (n - m)
            self.terms = ((-k, m), (k, n))
        else:
            self.terms = ((-2 * values[0], values[0]), (2 * values[0], 2 * values[0]))

    def traction(self, gap):
        return sum(k * ((1 + gap) ** -e if self.mie else exp(-e * gap)) for k, e in self.terms)


RIGID_LAWS = "mie:3;9 mie:4;10 mie:5;12.5 morse:1 morse:3".split()
RIGID_PROFILES = [("sphere", "-", "100"), ("cone:0.3", "-", "-"), ("power:0.05;1.5", "-", "-"),
                  ("power:0.001;4", "-", "-"), ("power:0.013;2.7", "-", "-"), ("truncated:5;20", "-", "-"),
                  ("punch:5;20", "-", "-"), ("exact_sphere:30", "-", "-"), ("exact_sphere:4", "-", "-"),
                  ("hyperboloid:0.3;2", "-", "-")]


def moments(law, approach, n, factor):
    """int p(C r^n - D) r dr by Beta and Gamma functions."""
    if law.mie:
        x = 1 - approach
        return sum(k * x ** (2 / n - e) * factor ** (-2 / n) / n * beta(2 / n, e - 2 / n) for k, e in law.terms)
    return sum(k * exp(e * approach) * gamma(2 / n) / n * (e * factor) ** (-2 / n) for k, e in law.terms)


def primitive(law, gap):
    """int_gap^inf p dH: the load of a paraboloid by its gap, Derjaguin."""
    return sum(k * ((1 + gap) ** (1 - e) / (e - 1) if law.mie else exp(-e * gap) / e) for k, e in law.terms)


def second_primitive(law, gap):
    """The integral of primitive over the gap from here on."""
    return sum(k * ((1 + gap) ** (2 - e) / ((e - 1) * (e - 2)) if law.mie else exp(-e * gap) / e ** 2) for k, e in law.terms)


def sphere_load(law, radius, approach):
    """int p r dr over the gap h of an exact sphere: r dr = (R - h) dh, by parts, up to its end, and beyond it r dr = (R -
    h) dh with the h of the end."""
    last = radius - sqrt(radius ** 2 - ((1 - mpf(2) ** -10) * radius) ** 2)
    first, beyond = -approach, last - approach
    inner = (radius * primitive(law, first) - (radius - last) * primitive(law, beyond)
             - (second_primitive(law, first) - second_primitive(law, beyond)))
    return 2 * (inner + (radius - last) * primitive(law, beyond))


def rigid_load(law, words, approach):
    """Load in pi w epsilon by closed forms: 2 int p(f - D) r dr. Beyond a flat the radius is R (its own gap) for a
    truncated sphere, and b + sqrt(2 R gap) for a rounded punch."""
    name, _, rest = words[0].partition(":")
    if name == "sphere":
        return 2 * mpf(words[2]) * primitive(law, -approach)
    if name in ("cone", "power"):
        values = numbers(rest)
        return 2 * moments(law, approach, *( (mpf(1), values[0]) if name == "cone" else values[::-1]))
    if name == "exact_sphere":
        return sphere_load(law, numbers(rest)[0], approach)
    if name == "hyperboloid":    # gap t u, r dr = (u + b) du: a cone and a paraboloid
        slope, b = numbers(rest)
        return 2 * moments(law, approach, mpf(1), slope) + 2 * b / slope * primitive(law, -approach)
    b, radius = numbers(rest)
    flat = b * b * law.traction(-approach)
    if name == "truncated":
        return flat + 2 * radius * primitive(law, -approach)
    # int p (b + v) dv, v = r - b, over v^2/(2R): a wedge of exponent 2 and a paraboloid
    if law.mie:
        x = 1 - approach
        wedge = sum(k * x ** (mpf(1) / 2 - e) * sqrt(2 * radius) / 2 * beta(mpf(1) / 2, e - mpf(1) / 2)
                    for k, e in law.terms)
    else:
        wedge = sum(k * exp(e * approach) * sqrt(2 * pi * radius / e) / 2 for k, e in law.terms)
    return flat + 2 * b * wedge + 2 * radius * primitive(law, -approach)


def rigid_load_by_quadrature(law, words, approach):
    """The same over r = e^t, which takes any growth."""
    name, _, rest = words[0].partition(":")
    base = Profile(*words)
    gaps = {"sphere": lambda r: r * r / (2 * base.unit)}
    if name in ("punch", "truncated"):
        b, radius = numbers(rest)
        gaps = {"punch": lambda r: (r - b) ** 2 / (2 * radius), "truncated": lambda r: (r * r - b * b) / (2 * radius)}
    elif name in ("cone", "power"):
        values = numbers(rest)
        n = mpf(1) if name == "cone" else values[1]
        gaps[name] = lambda r: values[0] * r ** n
    elif name == "hyperboloid":
        slope, tip = numbers(rest)
        gaps[name] = lambda r: slope * (sqrt(r * r + tip * tip) - tip)
    elif name == "exact_sphere":
        sphere, end = numbers(rest)[0], base.breaks[0]
        height = sqrt(sphere ** 2 - end ** 2)
        gaps[name] = lambda r: sphere - height + (r * r - end ** 2) / (2 * height)
    gap, b = gaps[name], base.breaks[0] if base.breaks else mpf(0)
    if name == "exact_sphere":
        inner = 2 * quad(lambda t: law.traction(sphere - sphere * cos(t) - approach) * sphere ** 2 * sin(t) * cos(t),
                         [asin(end / sphere) * i / 40 for i in range(41)])
    else:
        inner = b * b * law.traction(-approach)
    # r = b + e^t: to where what is left is below the digits carried; halves of a range that shrinks it each way
    low, high = mpf(-60), mpf(140) if law.mie else mpf(12)
    ends = [low + (high - low) * i / 40 for i in range(41)]
    return inner + 2 * quad(lambda t: law.traction(gap(b + exp(t)) - approach) * (b + exp(t)) * exp(t), ends)


def rigid_row(point, agreement):
    words, law_words = point
    law = Law(law_words)
    step, top = mpf(1) / 40, mpf("0.95") if law.mie else mpf(2)        # Mie: the bodies touch at 1
    grid = [-4 + step * i for i in range(int((top + 4) / step))]
    loads = [rigid_load(law, words, d) for d in grid]
    best = min(range(len(grid)), key=lambda i: loads[i])
    approach = findroot(lambda d: diff(lambda x: rigid_load(law, words, x), d), (grid[best - 1], grid[best + 1]),
                        solver="anderson", tol=mpf(10) ** -25)
    load = rigid_load(law, words, approach)
    agreement.check(f"{words} {law_words}", load, rigid_load_by_quadrature(law, words, approach))
    unit = mpf(1) if words[2] == "-" else mpf(words[2])
    return [law_words, *words, text(-load / unit, DIGITS), text(approach, DIGITS) if abs(approach) > mpf(10) ** -20 else "0"]


def checks():
    """The sphere, by Derjaguin."""
    for words in RIGID_LAWS:
        if abs(rigid_load(Law(words), ("sphere", "-", "100"), mpf(0)) + 200) > mpf(10) ** -30:
            raise ValueError(f"{words}: the rigid sphere pulls off at 2 pi w R")


TABLES = [
    Table("rigid_profiles.csv", "law profile waves radius force approach".split(),
          [(words, law) for words in RIGID_PROFILES for law in RIGID_LAWS], rigid_row,
          header("pull-off of rigid bodies, any law: the minimum over approach of int p(f - D) 2 pi r dr, unbounded. "
                 "law: mie:m;n or morse:a as in general_pull_off.csv",
                 "B. Derjaguin (1934), for the profile and the law of the row; derived anew",
                 "Beta and Gamma functions against quadrature over the radius", "rigid_profiles"),
          "1e-20", "1e-15", 7, "1e-12", checks),
]

if __name__ == "__main__":
    sys.exit(command_line(__doc__, TABLES))
