#!/usr/bin/env python3
"""JKR of any profile: points of the curve and pull-off, and the pull-off against the coupling.

    jkr_profiles.py --write [DIR]   regenerate jkr_profiles.csv and jkr_pull_off.csv
    jkr_profiles.py --sample        recompute a sample, compare (exit 1 on disagreement)

A rigid profile f(r) on an elastic half-space is in frictionless contact on the disc r < a. With the Abel transform
g(x) = x int_0^x f'(r)/sqrt(x^2 - r^2) dr the approach without adhesion is g(a) and the load
2 E* int_0^a (g(a) - g(x)) dx = 2 E* int_0^a x g'(x) dx. JKR adds a flat punch whose energy release rate is w:

    D = g(a) - sqrt(2 pi w a/E*),    F = 2 E* [a g(a) - int_0^a g] - sqrt(8 pi w E* a^3).

Routes: g, int g in closed form (elementary, Struve), against integrals over the slope f' alone:

    g(a) = a int_0^(pi/2) f'(a sin t) dt,    a g(a) - int_0^a g = int_0^(pi/2) (a sin t)^2 f'(a sin t) dt.

Lengths in units of epsilon, w = epsilon = 1, E* = 1/coupling.
"""

import sys
from dataclasses import dataclass
from functools import lru_cache

from mpmath import acos, asin, atan, atanh, diff, findroot, gamma, log, mp, mpf, pi, quad, sin, sqrt, struveh

from certified import Table, command_line, text

DIGITS = 18
SCENES_JKR = [  # profile, waves, radius
    ("sphere", "-", "100"), ("sphere", "0.4@10;0.1@3", "100"), ("sphere", "1@20", "41.7"),
    ("cone:0.3", "-", "-"), ("power:0.05;1.5", "-", "-"), ("power:0.001;4", "-", "-"), ("power:0.013;2.7", "-", "-"),
    ("punch:5;20", "-", "-"), ("truncated:5;20", "-", "-"), ("punch:3.7;51", "0.05@4.1", "-"),
    ("cone:0.5", "0.2@7", "-"), ("exact_sphere:9", "-", "-"), ("exact_sphere:60", "-", "-"), ("hyperboloid:0.3;2", "-", "-"),
    ("hyperboloid:1.5;40", "0.1@7", "-")]
COUPLINGS = "0.05 0.7".split()
STIFF = "12"              # for profiles without waves
LIMITS = [("sphere", "-", "100"), ("cone:0.3", "-", "-"), ("power:0.05;1.5", "-", "-"), ("power:0.001;4", "-", "-"),
          ("punch:5;20", "-", "-"), ("truncated:5;20", "-", "-"), ("sphere", "0.4@12;0.1@5", "50")]
LIMIT_COUPLINGS = "0.001 0.003 0.01 0.03 0.1 0.3 1 3 10 30 100".split()
STIFF_SPHERE = "35.3553390593274 3162.27766016838 100000".split()   # Tabor parameters 50, 1,000 and 10,000
RADII = "0.3 1.7 4.9 7.3 13".split()                   # contact radii of the points, in epsilon


@dataclass(frozen=True)
class Base:
    """A profile: breaks of its slope, slope f', and in closed form g and a g(a) - int_0^a g."""
    breaks: tuple
    slope: object
    g: object
    press: object


def power(factor, n):
    kappa = sqrt(pi) / 2 * n * gamma(n / 2) / gamma((n + 1) / 2)
    return Base((), lambda r: factor * n * r ** (n - 1), lambda x: kappa * factor * x ** n,
                lambda a: kappa * factor * n / (n + 1) * a ** (n + 1))


def truncated(b, radius):
    """g = (x/R) sqrt(x^2 - b^2): its integral is (x^2 - b^2)^(3/2)/(3R)."""
    def root(x):
        return sqrt(x * x - b * b)

    return Base((b,), lambda r: r / radius if r > b else mpf(0),
                lambda x: x * root(x) / radius if x > b else mpf(0),
                lambda a: (a * a * root(a) - root(a) ** 3 / 3) / radius if a > b else mpf(0))


def punch(b, radius):
    """g = (x/R) [sqrt(x^2 - b^2) - b arccos(b/x)]; int x arccos(b/x) = [x^2 arccos(b/x) - b sqrt(x^2 - b^2)]/2."""
    def root(x):
        return sqrt(x * x - b * b)

    def g(x):
        return x / radius * (root(x) - b * acos(b / x)) if x > b else mpf(0)

    def press(a):
        if a <= b:
            return mpf(0)
        area = (root(a) ** 3 / 3 - b / 2 * (a * a * acos(b / a) - b * root(a))) / radius
        return a * g(a) - area

    return Base((b,), lambda r: (r - b) / radius if r > b else mpf(0), g, press)


def exact_sphere(radius):
    """f = R - sqrt(R^2 - r^2) up to e = 1023/1024 R, and the parabola with the same value and slope beyond. With u = r^2 the
    inner part of g/x is half the integral of 1/sqrt((R^2 - u)(x^2 - u)), that of the press half the integral of u times
    this; both are in tables of integrals."""
    end = (1 - mpf(2) ** -10) * radius
    height = sqrt(radius ** 2 - end ** 2)

    def logarithm(x):
        if x <= end:
            return atanh(x / radius)
        return log((radius + x) / (height + sqrt(x * x - end ** 2)))

    def beyond(x):
        return sqrt(x * x - end ** 2) if x > end else mpf(0)

    def press(a):
        s = beyond(a)
        return ((radius ** 2 + a * a) * logarithm(a) - radius * a + height * s) / 2 + (a * a * s - s ** 3 / 3) / height

    return Base((end,), lambda r: r / (sqrt(radius ** 2 - r * r) if r <= end else height),
                lambda x: x * logarithm(x) + x * beyond(x) / height, press)


def hyperboloid(slope, b):
    """f = t (sqrt(r^2 + b^2) - b): int x arctan(x/b) = [(x^2 + b^2) arctan(x/b) - b x]/2."""
    return Base((), lambda r: slope * r / sqrt(r * r + b * b), lambda x: slope * x * atan(x / b),
                lambda a: slope * (a * a * atan(a / b) - ((a * a + b * b) * atan(a / b) - b * a) / 2))


def wave(amplitude, length):
    """g = (pi/2) A k x H0(kx); int_0^a x H0(kx) dx = a H1(ka)/k."""
    k = 2 * pi / length
    return Base((), lambda r: amplitude * k * sin(k * r), lambda x: pi / 2 * amplitude * k * x * struveh(0, k * x),
                lambda a: pi / 2 * amplitude * a * (k * a * struveh(0, k * a) - struveh(1, k * a)))


MAKERS = {"power": power, "cone": lambda t: power(t, mpf(1)), "punch": punch, "truncated": truncated,
          "exact_sphere": exact_sphere, "hyperboloid": hyperboloid}


def numbers(words):
    return [mpf(word) for word in words.replace(";", ",").split(",")]


class Profile:
    """A profile with its waves: slope, and g and press in closed form (route 1) or from the slope (route 2)."""

    def __init__(self, profile, waves, radius):
        name, _, rest = profile.partition(":")
        first = power(1 / (2 * mpf(radius)), mpf(2)) if name == "sphere" else MAKERS[name](*numbers(rest))
        pairs = [] if waves == "-" else [[mpf(x) for x in one.split("@")] for one in waves.split(";")]
        self.parts = [first, *(wave(*pair) for pair in pairs)]
        self.waves = [(amplitude, 2 * pi / length) for amplitude, length in pairs]       # A, k
        self.breaks = first.breaks
        self.unit = mpf(1) if radius == "-" else mpf(radius)

    def slope(self, r):
        return sum(part.slope(r) for part in self.parts)

    def gap(self, r):
        """f by quadrature of the slope."""
        return quad(self.slope, self.pieces(mpf(0), r))

    def g(self, x):
        return sum(part.g(x) for part in self.parts)

    def press(self, a):
        return sum(part.press(a) for part in self.parts)

    def pieces(self, low, high):
        """Ends of the pieces of [low, high] for quadrature: breaks, and pieces of the shortest wave."""
        inner = [b for b in self.breaks if low < b < high]
        k = max((k for _, k in self.waves), default=mpf(0))
        count = 1 + int(k * (high - low) / 12)
        return sorted({low, high, *inner, *(low + (high - low) * i / count for i in range(1, count))})

    def g_of_slope(self, x):
        return x * quad(lambda t: self.slope(x * sin(t)), self.angles(x))

    def press_of_slope(self, a):
        return quad(lambda t: (a * sin(t)) ** 2 * self.slope(a * sin(t)), self.angles(a))

    def angles(self, a):
        return [asin(r / a) if r < a else pi / 2 for r in self.pieces(mpf(0), a)]


def jkr(profile, coupling, a, closed=True):
    """(approach, load in pi w epsilon) at contact radius a."""
    g, press = (profile.g, profile.press) if closed else (profile.g_of_slope, profile.press_of_slope)
    return (g(a) - sqrt(2 * pi * a * coupling),
            (2 * press(a) / coupling - sqrt(8 * pi * a ** 3 / coupling)) / pi)


def excess(profile, coupling, a, xi):
    """g'(a) - xi sqrt(pi w/(2 E* a)), by which the load (xi = 3) and the approach (1) rise with a."""
    return diff(profile.g, a) - xi * sqrt(pi * coupling / (2 * a))


BESIDE = mpf(10) ** -15   # of a corner, relative
SCAN = 24                 # points of the scan a wavelength, and a decade


def beyond_minima(profile, coupling, a):
    """Whether load and approach are positive from here on: the waves add at most (pi/2) A (1.2 sqrt(ka) + 2) times
    a to press, and times 1 to g, since |x H0 - H1| and |x H0| < 1.2 sqrt(x) + 2 for every x; the profile without
    waves grows faster than these and than the adhesion once it has passed them."""
    waves = sum(pi / 2 * amplitude * (mpf("1.2") * sqrt(k * a) + 2) for amplitude, k in profile.waves)
    press, g = profile.parts[0].press(a) - waves * a, profile.parts[0].g(a) - waves
    return 2 * press / coupling > sqrt(8 * pi * a ** 3 / coupling) and g > sqrt(2 * pi * a * coupling)


@lru_cache(maxsize=None)
def least(words, coupling, xi):
    """The contact radius of the deepest minimum of the load (xi = 3) or of the approach (1), from the closed forms:
    a scan in double precision, the lowest refined."""
    profile, c = Profile(*words), mpf(coupling)
    which = 1 if xi == 3 else 0
    mp.dps, kept = 15, mp.dps
    try:
        a, radii = mpf("1e-4"), []
        step = 2 * pi / max(k for _, k in profile.waves) / SCAN if profile.waves else None
        while True:
            radii.append(a)
            a = a * mpf(10) ** (mpf(1) / SCAN) if step is None or a * mpf("0.039") < step else a + step
            if beyond_minima(profile, c, a):
                radii.append(a)     # the minimum may be a corner just before it
                break
        found = [jkr(profile, c, a)[which] for a in radii]
    finally:
        mp.dps = kept
    best = min(range(len(radii)), key=lambda i: found[i])
    if best in (0, len(radii) - 1):
        raise ValueError(f"{words}: no minimum inside the scan")
    low, high = radii[best - 1], radii[best + 1]
    for edge in profile.breaks:                   # where g' jumps the minimum may be a corner
        if low < edge < high:
            before, beyond = edge * (1 - BESIDE), edge * (1 + BESIDE)
            if excess(profile, c, before, xi) < 0 < excess(profile, c, beyond, xi):
                return edge
            low, high = (beyond, high) if excess(profile, c, beyond, xi) < 0 else (low, before)
    return findroot(lambda a: excess(profile, c, a, xi), (low, high), solver="anderson", tol=mpf(10) ** -30)


def rows_jkr():
    for words in SCENES_JKR:
        for coupling in COUPLINGS + [STIFF] * (words[1] == "-"):
            for a in RADII:
                yield words, coupling, "point", a
            yield words, coupling, "pull_off_load", None
            yield words, coupling, "pull_off_approach", None


def jkr_row(point, agreement):
    words, coupling, kind, a = point
    profile, c = Profile(*words), mpf(coupling)
    place = mpf(a) if a else least(words, coupling, 3 if kind == "pull_off_load" else 1)
    approach, load = jkr(profile, c, place)
    other = jkr(profile, c, place, closed=False)
    label = f"{words} coupling {coupling} {kind} {a or ''}"
    agreement.check(label + " approach", approach, other[0], scale=abs(approach) + sqrt(2 * pi * place * c))
    agreement.check(label + " load", load, other[1], scale=abs(load) + sqrt(8 * place ** 3 / pi / c))
    profile_words, waves, radius = words
    return [profile_words, waves, coupling, radius, kind, text(place, DIGITS), text(approach, DIGITS),
            text(load / profile.unit, DIGITS)]


def limit_row(point, agreement):
    words, coupling = point
    profile, waves, radius, _, place, approach, load = [*words, *jkr_row((words, coupling, "pull_off_load", None), agreement)[4:]]
    return [profile, waves, coupling, radius, place, "0" if abs(mpf(approach)) < mpf(10) ** -30 else approach,
            load.removeprefix("-")]


UNITS = ("lengths and approach in epsilon, approach > 0 pressed together; load > 0 compressive, in units of pi w R where "
         "radius is that of a sphere and of pi w epsilon where radius is -; coupling = w/(E* epsilon)")
PROFILES = ("sphere: r^2/(2R), R = radius; cone:t: t r; power:C;n: C r^n; punch:b;R: 0 up to b, (r - b)^2/(2R) beyond; "
            "truncated:b;R: 0 up to b, (r^2 - b^2)/(2R) beyond; {}waves A@L;...: each adds A (1 - cos(2 pi r/L)); -: none")
ROUND = ("exact_sphere:R: R - sqrt(R^2 - r^2) up to 1023/1024 R, the parabola of the same value and slope beyond; "
         "hyperboloid:t;b: t (sqrt(r^2 + b^2) - b); ")


def header(what, source, evidence, generator="jkr_profiles", more=ROUND):
    return {"what": what, "source": source, "kind": "oracle",
            "method": "mpmath, 40 digits; shares no code or method with src/", "profiles": PROFILES.format(more), "units": UNITS,
            "date": "2026-11-22", "uncertainty": "all digits printed (18, rounded)", "evidence": evidence,
            "generator": f"reference/make/{generator}.py",
            "command": f"python3 reference/make/{generator}.py --write"}


def checks():
    """The pull-off of a cone in closed form."""
    c, t = mpf("0.7"), mpf("0.3")
    a = least(("cone:0.3", "-", "-"), "0.7", 3)
    if abs(-jkr(Profile("cone:0.3", "-", "-"), c, a)[1] - 54 * c / pi ** 2 / t ** 3) > mpf(10) ** -25:
        raise ValueError("JKR: the cone pulls off at 54 w^2/(pi E* t^3)")


TABLES = [
    Table("jkr_profiles.csv", "profile waves coupling radius kind contact_radius approach load".split(),
          list(rows_jkr()), jkr_row,
          header("JKR contact on a full disc, any profile: points of the curve (kind point) and its pull-off, the "
                 "deepest minimum of the load (pull_off_load: force = -load) and of the approach (pull_off_approach) "
                 "over every contact radius", "K. L. Johnson, K. Kendall, A. D. Roberts (1971); Abel transform of the "
                 "profile as in I. N. Sneddon (1965); derived anew",
                 "g and its integral in closed form against integrals over the slope of the profile"),
          "1e-20", "1e-15", 11, "1e-15", checks),
    Table("jkr_pull_off.csv", "profile waves coupling radius contact_radius approach force".split(),
          [(words, coupling) for words in LIMITS for coupling in LIMIT_COUPLINGS + STIFF_SPHERE * (words == LIMITS[0])],
          limit_row,
          header("pull-off of a JKR contact on a full disc against the coupling: the deepest minimum of the load over every "
                 "contact radius, force = -load. The limit of any law for large coupling",
                 "as jkr_profiles.csv", "g and its integral in closed form against integrals over the slope of the profile",
                 more=""),
          "1e-20", "1e-15", 9, "1e-15"),
]

if __name__ == "__main__":
    sys.exit(command_line(__doc__, TABLES))
