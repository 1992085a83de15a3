#!/usr/bin/env python3
"""Maugis-Dugdale of any profile: states of contact.

    maugis_profiles.py --write [DIR]   regenerate maugis_profiles.csv
    maugis_profiles.py --sample        recompute a sample, compare (exit 1 on disagreement)

Maugis-Dugdale: a constant tension s on a < r < c ends where the gap is w/s; it has the transform s sqrt(c^2 - x^2):

    D = g(a) - 2 s sqrt(c^2 - a^2)/E*,
    F = 2 E* [a g(a) - int_0^a g] - 2 s [a sqrt(c^2 - a^2) + c^2 arccos(a/c)],
    gap(c) = (2/pi) {int_a^c (g(x) - D)/sqrt(c^2 - x^2) dx - 2 s (c - a)/E*} = w/s.

with the transform g and the units of jkr_profiles.py. Routes: closed g with one quadrature, against integrals over the
slope alone, where int_a^c g(x)/sqrt(c^2 - x^2) dx = int_0^c f'(r) arccos(sqrt((l^2 - r^2)/(c^2 - r^2))) dr,
l = max(a, r).
"""

import sys

from mpmath import acos, asin, findroot, mpf, nstr, pi, quad, sin, sqrt

from certified import Table, command_line, text
from jkr_profiles import DIGITS, Profile, header, jkr

RATE = mpf(1) / 10        # of the factor 4


def maugis(profile, coupling, tension, a, c, closed=True):
    """(approach, load in pi w epsilon, gap at c less w/s) of the contact radius a and the end c of the tension."""
    modulus, s = 1 / coupling, sqrt(c * c - a * a)
    g, press = (profile.g, profile.press) if closed else (profile.g_of_slope, profile.press_of_slope)
    approach = g(a) - 2 * tension * s / modulus
    load = 2 * modulus * press(a) - 2 * tension * (a * s + c * c * acos(a / c))
    if closed:
        # x = c sin(t): the root at c is gone
        integral = quad(lambda t: profile.g(c * sin(t)), [asin(x / c) for x in profile.pieces(a, c)])
    else:
        # int x dx/sqrt((x^2 - r^2)(c^2 - x^2)) from max(a, r) to c
        def weight(r):
            return acos(sqrt((a * a - r * r) / (c * c - r * r)))

        integral = quad(lambda r: profile.slope(r) * weight(r), profile.pieces(mpf(0), a)) + quad(
            lambda r: profile.slope(r), profile.pieces(a, c)) * pi / 2
    gap = 2 / pi * (integral - approach * acos(a / c) - 2 * tension * (c - a) / modulus)
    return approach, load / pi, gap - 1 / tension


def end_of_tension(profile, coupling, tension, a):
    """c of a contact radius a."""
    def far(c):
        return maugis(profile, coupling, tension, a, c)[2]

    high = a * mpf("1.001")
    while far(high) < 0:
        high = a + 2 * (high - a)
    return findroot(far, (a + (high - a) / 2 * mpf("0.999"), high), solver="anderson", tol=mpf(10) ** -30)


MAUGIS_SCENES = [(words, coupling, tension, a) for words in (
    ("sphere", "-", "100"), ("cone:0.3", "-", "-"), ("power:0.05;1.5", "-", "-"), ("power:0.001;4", "-", "-"),
    ("truncated:5;20", "-", "-"), ("punch:5;20", "-", "-"), ("sphere", "0.05@30", "100"),
    ("exact_sphere:25", "-", "-"), ("hyperboloid:0.3;2", "-", "-"))
    for coupling, tension in (("0.05", "1.0264"), ("2", "1.0264"), ("0.7", "3"))
    for a in ("6.3", "9.1")]


def maugis_row(point, agreement):
    words, coupling, tension, a = point
    profile, k, s, radius = Profile(*words), mpf(coupling), mpf(tension), mpf(a)
    c = end_of_tension(profile, k, s, radius)
    one, two = (maugis(profile, k, s, radius, c, closed) for closed in (True, False))
    scales = abs(one[0]) + 2 * s * k * sqrt(c * c - radius * radius), abs(one[1]) + s * c * c, 1 / s
    for name, x, y, scale in zip(("approach", "load", "gap"), one, two, scales):
        agreement.check(f"{point} {name}", x, y, scale=scale)
    return [words[0], words[1], coupling, words[2], tension, a, text(c, DIGITS), text(one[0], DIGITS),
            text(one[1] / profile.unit, DIGITS)]


def maugis_checks():
    """The sphere as Maugis gives it, in units (pi w R^2/K)^(1/3) of the contact radius, K = 4 E*/3; and other profiles
    tend to JKR at equal contact radius as tension^-2."""
    sphere, radius, coupling, tension, a = ("sphere", "-", "100"), mpf(100), mpf("0.7"), mpf("1.3"), mpf(9)
    stiffness = 4 / (3 * coupling)
    c = end_of_tension(Profile(*sphere), coupling, tension, a)
    m, s = c / a, a / (pi * radius ** 2 / stiffness) ** (mpf(1) / 3)
    number = 2 * tension * (radius / (pi * stiffness ** 2)) ** (mpf(1) / 3)
    root, angle = sqrt(m * m - 1), acos(1 / m)
    condition = (number * s * s / 2 * (root + (m * m - 2) * angle)
                 + 4 * number ** 2 * s / 3 * (root * angle - m + 1))
    load = s ** 3 - number * s * s * (root + m * m * angle)
    computed = maugis(Profile(*sphere), coupling, tension, a, c)[1] / radius
    if abs(condition - 1) > mpf(10) ** -25 or abs(load - computed) > mpf(10) ** -25:
        raise ValueError("Maugis-Dugdale: not the equations of Maugis for the sphere")
    for words in ("cone:0.3", "-", "-"), ("power:0.001;4", "-", "-"), ("truncated:5;20", "-", "-"):
        profile = Profile(*words)
        exact = jkr(profile, coupling, a)[1]
        far, near = (maugis(profile, coupling, t, a, end_of_tension(profile, coupling, t, a))[1] - exact
                     for t in (mpf(100), mpf(200)))
        if not abs(far / near - 4) < RATE:
            raise ValueError(f"{words}: Maugis-Dugdale tends to JKR by a factor {nstr(far / near, 5)} as the tension "
                             "doubles, expected 4")


TABLES = [
    Table("maugis_profiles.csv", ("profile waves coupling radius tension contact_radius end_of_tension approach "
                                  "load").split(), MAUGIS_SCENES, maugis_row,
          header("Maugis-Dugdale contact, any profile: tension (in w/epsilon) on contact_radius < r < end_of_tension, "
                 "where the gap is epsilon/tension. The gap between the two is not looked at: valid where it rises",
                 "D. Maugis, J. Colloid Interface Sci. 150, 243 (1992), for any profile; derived anew",
                 "closed g with one quadrature against integrals over the slope, exchanged", "maugis_profiles"),
          "1e-18", "1e-15", 9, "1e-15", maugis_checks),
]

if __name__ == "__main__":
    sys.exit(command_line(__doc__, TABLES))
