#!/usr/bin/env python3
"""Closed forms for any profile: JKR, Maugis-Dugdale and the pull-off of rigid bodies.

    jkr_profiles.py --write [DIR]   regenerate jkr_profiles.csv, maugis_profiles.csv, rigid_profiles.csv
    jkr_profiles.py --sample        recompute a sample, compare (exit 1 on disagreement)

A rigid profile f(r) on an elastic half-space is in frictionless contact on the disc r < a. With the Abel transform
g(x) = x int_0^x f'(r)/sqrt(x^2 - r^2) dr the approach without adhesion is g(a) and the load
2 E* int_0^a (g(a) - g(x)) dx = 2 E* int_0^a x g'(x) dx. JKR adds a flat punch whose energy release rate is w:

    D = g(a) - sqrt(2 pi w a/E*),    F = 2 E* [a g(a) - int_0^a g] - sqrt(8 pi w E* a^3).

Maugis-Dugdale: a constant tension s on a < r < c ends where the gap is w/s; it has the transform s sqrt(c^2 - x^2):

    D = g(a) - 2 s sqrt(c^2 - a^2)/E*,
    F = 2 E* [a g(a) - int_0^a g] - 2 s [a sqrt(c^2 - a^2) + c^2 arccos(a/c)],
    gap(c) = (2/pi) {int_a^c (g(x) - D)/sqrt(c^2 - x^2) dx - 2 s (c - a)/E*} = w/s.

Routes: g, int g in closed form (elementary, Struve) and quadrature of them, against integrals over the slope f' alone:

    g(a) = a int_0^(pi/2) f'(a sin t) dt,    a g(a) - int_0^a g = int_0^(pi/2) (a sin t)^2 f'(a sin t) dt,
    int_a^c g(x)/sqrt(c^2 - x^2) dx = int_0^c f'(r) arccos(sqrt((l^2 - r^2)/(c^2 - r^2))) dr, l = max(a, r).

Lengths in units of epsilon, w = epsilon = 1, E* = 1/coupling.
"""

import sys
from dataclasses import dataclass
from functools import lru_cache

from mpmath import acos, asin, beta, diff, exp, findroot, gamma, mp, mpf, nstr, pi, quad, sin, sqrt, struveh

from certified import Table, command_line, text

DIGITS = 18
SCENES_JKR = [  # profile, waves, radius
    ("sphere", "-", "100"), ("sphere", "0.4@10;0.1@3", "100"), ("sphere", "1@20", "41.7"),
    ("cone:0.3", "-", "-"), ("power:0.05;1.5", "-", "-"), ("power:0.001;4", "-", "-"), ("power:0.013;2.7", "-", "-"),
    ("punch:5;20", "-", "-"), ("truncated:5;20", "-", "-"), ("punch:3.7;51", "0.05@4.1", "-"),
    ("cone:0.5", "0.2@7", "-")]
COUPLINGS = "0.05 0.7".split()
STIFF = "12"              # for profiles without waves
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


def wave(amplitude, length):
    """g = (pi/2) A k x H0(kx); int_0^a x H0(kx) dx = a H1(ka)/k."""
    k = 2 * pi / length
    return Base((), lambda r: amplitude * k * sin(k * r), lambda x: pi / 2 * amplitude * k * x * struveh(0, k * x),
                lambda a: pi / 2 * amplitude * a * (k * a * struveh(0, k * a) - struveh(1, k * a)))


MAKERS = {"power": power, "cone": lambda t: power(t, mpf(1)), "punch": punch, "truncated": truncated}


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


RATE = mpf(1) / 10        # of the factor 4
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
    ("truncated:5;20", "-", "-"), ("punch:5;20", "-", "-"), ("sphere", "0.05@30", "100"))
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
                  ("punch:5;20", "-", "-")]


def moments(law, approach, n, factor):
    """int p(C r^n - D) r dr by Beta and Gamma functions."""
    if law.mie:
        x = 1 - approach
        return sum(k * x ** (2 / n - e) * factor ** (-2 / n) / n * beta(2 / n, e - 2 / n) for k, e in law.terms)
    return sum(k * exp(e * approach) * gamma(2 / n) / n * (e * factor) ** (-2 / n) for k, e in law.terms)


def primitive(law, gap):
    """int_gap^inf p dH: the load of a paraboloid by its gap, Derjaguin."""
    return sum(k * ((1 + gap) ** (1 - e) / (e - 1) if law.mie else exp(-e * gap) / e) for k, e in law.terms)


def rigid_load(law, words, approach):
    """Load in pi w epsilon by closed forms: 2 int p(f - D) r dr. Beyond a flat the radius is R (its own gap) for a
    truncated sphere, and b + sqrt(2 R gap) for a rounded punch."""
    name, _, rest = words[0].partition(":")
    if name == "sphere":
        return 2 * mpf(words[2]) * primitive(law, -approach)
    if name in ("cone", "power"):
        values = numbers(rest)
        return 2 * moments(law, approach, *( (mpf(1), values[0]) if name == "cone" else values[::-1]))
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
    gap, b = gaps[name], base.breaks[0] if base.breaks else mpf(0)
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


UNITS = ("lengths and approach in epsilon, approach > 0 pressed together; load > 0 compressive, in units of pi w R where "
         "radius is that of a sphere and of pi w epsilon where radius is -; coupling = w/(E* epsilon)")
PROFILES = ("sphere: r^2/(2R), R = radius; cone:t: t r; power:C;n: C r^n; punch:b;R: 0 up to b, (r - b)^2/(2R) beyond; "
            "truncated:b;R: 0 up to b, (r^2 - b^2)/(2R) beyond; waves A@L;...: each adds A (1 - cos(2 pi r/L)); -: none")


def header(what, source, evidence):
    return {"what": what, "source": source, "kind": "oracle",
            "method": "mpmath, 40 digits; shares no code or method with src/", "profile": PROFILES, "units": UNITS,
            "date": "2026-11-22", "uncertainty": "all digits printed (18, rounded)", "evidence": evidence,
            "generator": "reference/make/jkr_profiles.py",
            "command": "python3 reference/make/jkr_profiles.py --write"}


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


def checks():
    """Known values: the cone of JKR in closed form, and the rigid sphere."""
    c, t = mpf("0.7"), mpf("0.3")
    a = least(("cone:0.3", "-", "-"), "0.7", 3)
    if abs(-jkr(Profile("cone:0.3", "-", "-"), c, a)[1] - 54 * c / pi ** 2 / t ** 3) > mpf(10) ** -25:
        raise ValueError("JKR: the cone pulls off at 54 w^2/(pi E* t^3)")
    for words in RIGID_LAWS:
        if abs(rigid_load(Law(words), ("sphere", "-", "100"), mpf(0)) + 200) > mpf(10) ** -30:
            raise ValueError(f"{words}: the rigid sphere pulls off at 2 pi w R")


TABLES = [
    Table("jkr_profiles.csv", "profile waves coupling radius kind contact_radius approach load".split(),
          list(rows_jkr()), jkr_row,
          header("JKR contact on a full disc, any profile: points of the curve (kind point) and its pull-off, the "
                 "deepest minimum of the load (pull_off_load: force = -load) and of the approach (pull_off_approach) "
                 "over every contact radius", "K. L. Johnson, K. Kendall, A. D. Roberts (1971); Abel transform of the "
                 "profile as in I. N. Sneddon (1965); derived anew",
                 "g and its integral in closed form against integrals over the slope of the profile"),
          "1e-20", "1e-15", 11, "1e-15", checks),
    Table("maugis_profiles.csv", ("profile waves coupling radius tension contact_radius end_of_tension approach "
                                  "load").split(), MAUGIS_SCENES, maugis_row,
          header("Maugis-Dugdale contact, any profile: tension (in w/epsilon) on contact_radius < r < end_of_tension, "
                 "where the gap is epsilon/tension. The gap between the two is not looked at: valid where it rises",
                 "D. Maugis, J. Colloid Interface Sci. 150, 243 (1992), for any profile; derived anew",
                 "closed g with one quadrature against integrals over the slope, exchanged"),
          "1e-18", "1e-15", 9, "1e-15", maugis_checks),
    Table("rigid_profiles.csv", "law profile waves radius force approach".split(),
          [(words, law) for words in RIGID_PROFILES for law in RIGID_LAWS], rigid_row,
          header("pull-off of rigid bodies, any law: the minimum over approach of int p(f - D) 2 pi r dr, unbounded. "
                 "law: mie:m;n or morse:a as in general_pull_off.csv",
                 "B. Derjaguin (1934), for the profile and the law of the row; derived anew",
                 "Beta and Gamma functions against quadrature over the radius"),
          "1e-20", "1e-15", 7, "1e-12"),
]

if __name__ == "__main__":
    sys.exit(command_line(__doc__, TABLES))
