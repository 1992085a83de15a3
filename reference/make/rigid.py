#!/usr/bin/env python3
"""The rigid wavy sphere: load (Eq 22) and pull-off.

    rigid.py --write [DIR]       regenerate rigid_integral, rigid_curves, rigid_pull_off and rigid_limit.csv
    rigid.py --sample            recompute a sample, compare (exit 1 on disagreement)

With x = 1 - approach and q(t) = x + A (1 - cos t) + A t^2/(8 pi^2 alpha), Eqs 21-22 are

    load = -(4 A/(3 pi^2 alpha)) int_0^inf [q^-3 - q^-9] t dt.

Route 1 (panels): Gauss-Legendre on quarter waves, split geometrically towards the crests, over N
periods. The rest follows by Richardson extrapolation in 1/N^2.
Route 2 (folded): t = phi + 2 pi n. The sum over n >= 0 comes first (direct terms, then
Euler-Maclaurin, whose integral is elementary), then tanh-sinh quadrature over phi in 0..2 pi.
Both use extended precision (64-bit mantissa), which gives 16 to 18 digits.
"""

import math
import sys
from functools import lru_cache

import numpy as np
from mpmath import bernfrac, mp, mpf

from certified import INTERFACE_UNITS, PAPER, Table, command_line, text

LONG = np.longdouble
DIGITS = 17
PI = LONG("3.14159265358979323846264338327950288")

AMPLITUDES = "-3 -0.5 0 1 2 4".split()                  # log10 A of Figure 7
ALPHAS = [str(x) for x in (-4, -3.75, -3.5, -3.25, -3, -2.75, -2.5, -2.25, -2, -1.75, -1.5, -1.25, -1,
                           -0.75, -0.5, -0.25, 0, 0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75, 2)]
PLAIN = [("0.25", "1"), ("0.37", "3.3"), ("1.7", "27")]         # alpha, A themselves

# Figure 6: A = 1; distances 1/(a + k h), closest where the load is steep, up to LAST_LOAD.
CURVES = ["0.0001", "0.01", "0.1", "1", "10"]
FAR_DISTANCE, NEAR_DISTANCE, CURVE_STEP, LAST_LOAD = 6, 0.3, 0.012, 1

# amplitude, wavelength, radius of the limit of small Tabor parameters.
LIMITS = [(amplitude, "20", "100") for amplitude in "0.1 1 10 100 1000 10000".split()]

INTEGRAL_PAIRS = [("0.25", "1"), ("0.0001", "1"), ("100", "0.001"), ("100", "10000"), ("0.01", "10000"),
                  ("0.37", "3.3"), ("1.7", "27"), ("13", "0.3"), ("0.003", "150"), ("1", "1000")]
APPROACHES = ["-30", "-3.7", "-1", "-0.1", "0", "0.15", "0.3", "0.6"]

KNOWN = (("0.25", "1", "0.7410559"), ("0.0001", "1", "1.992148"))          # alpha, A, force

# Terms coefficient * q^-power: of the load, its first and second derivative in x.
TERMS = (((1, 3), (-1, 9)), ((-3, 4), (9, 10)), ((12, 5), (-90, 11)))


def extended(value):
    """An mpmath number or text in extended precision."""
    return LONG(mp.nstr(mpf(value), 25))


def exact(value):
    """The exact value of an extended-precision number in mpmath."""
    high = float(value)
    return mpf(high) + mpf(float(value - LONG(high)))


@lru_cache(maxsize=None)
def gauss(count):
    """Gauss-Legendre nodes and weights on 0..1, by Newton's method in extended precision."""
    z = np.polynomial.legendre.leggauss(count)[0].astype(LONG)
    for _ in range(4):
        before, value = np.ones_like(z), z
        for n in range(2, count + 1):
            before, value = value, ((2 * n - 1) * z * value - (n - 1) * before) / n
        derivative = count * (z * value - before) / (z * z - 1)
        z = z - value / derivative
    return (1 + z) / 2, 1 / ((1 - z * z) * derivative ** 2)


# Route 1.

def panels_integral(alpha, amplitude, x, order):
    """int_0^inf (d/dx)^order [q^-3 - q^-9] t dt by panels over N, 2N, ..., 32N periods."""
    nodes, weights = gauss(20)
    slope = amplitude / (8 * PI ** 2 * alpha)
    reach = min(float(np.sqrt(x / (amplitude / 2 + slope))) / 2, math.pi / 2)   # width of the crest
    edges = [0.0, reach]
    while edges[-1] < math.pi / 2:
        edges.append(min(edges[-1] * 2, math.pi / 2))
    crest = np.array(edges, dtype=LONG) / LONG(edges[-1]) * (PI / 2)
    trough = PI - crest[::-1]
    half = np.concatenate([crest, trough[1:]])
    marks = np.concatenate([half, (2 * PI - half[::-1])[1:]])
    widths = np.diff(marks)
    phi = (marks[:-1, None] + widths[:, None] * nodes).ravel()
    weight = (widths[:, None] * weights).ravel()
    wave = 2 * amplitude * np.sin(phi / 2) ** 2
    first = max(4, 3 * math.ceil(math.sqrt(float(2 * alpha * x / amplitude + 4 * alpha))))
    sums, total, begin = [], LONG(0), 0
    for level in range(6):
        end = first * 2 ** level
        batch = max(1, 100000 // len(phi))
        for low in range(begin, end, batch):
            n = np.arange(low, min(end, low + batch)).astype(LONG)
            t = phi + 2 * PI * n[:, None]
            total += np.sum(combination(x + wave + slope * t * t, order) * t * weight)
        begin = end
        sums.append(total)
    power = 4 + 2 * order                  # the rest falls as N^-4, N^-6, ... (N^-6, ... of q^-4)
    while len(sums) > 1:
        factor = LONG(2) ** power
        sums = [(factor * b - a) / (factor - 1) for a, b in zip(sums, sums[1:])]
        power += 2
    return sums[0]


def combination(q, order):
    """(d/dx)^order [q^-3 - q^-9]."""
    inverse = 1 / q
    third = inverse ** 3
    sixth = third * third
    (c, _), (d, _) = TERMS[order]
    return third * inverse ** order * (c + d * sixth)


# Route 2.

@lru_cache(maxsize=None)
def tanh_sinh(step, kind):
    """Nodes, as distances from the nearer end of 0..1, and weights, as numbers of a kind."""
    count = math.ceil(4.2 / step)
    u = np.arange(-count, count + 1).astype(kind) * kind(step)
    s = PI / 2 * np.sinh(np.abs(u))
    distance = 1 / (1 + np.exp(2 * s))
    weight = PI / 4 * np.cosh(u) / np.cosh(s) ** 2 * kind(step)
    return u < 0, distance, weight


@lru_cache(maxsize=None)
def bernoulli(number):
    numerator, denominator = bernfrac(number)
    return LONG(numerator) / denominator


def folded_sum(start, offset, power):
    """sum_{n >= 0} (n + a)/((n + a)^2 + offset)^power; start = a, offset > 0, both arrays, or rows of offsets."""
    direct = 14
    total = np.zeros_like(offset)
    for n in range(direct):
        t = start + n
        total += t / (t * t + offset) ** power
    t = start + direct
    base = t * t + offset
    total += base ** (1 - power) / (2 * (power - 1)) + t / base ** power / 2
    # Taylor coefficients of z/(z^2 + offset)^power about t give the odd derivatives.
    count = 20
    inverse = [base ** -power]
    for j in range(1, count):              # (base + 2 t h + h^2)^-power by its recurrence
        value = -(2 * t * (power + j - 1)) * inverse[j - 1]
        if j > 1:
            value = value - (2 * power + j - 2) * inverse[j - 2]
        inverse.append(value / (j * base))
    for m in range(1, count // 2):
        odd = 2 * m - 1
        derivative_over_factorial = t * inverse[odd] + inverse[odd - 1]
        total -= bernoulli(2 * m) / (2 * m) * derivative_over_factorial
    return total


def folded_integral(alpha, amplitude, x, order, step=1 / 64, kind=LONG):
    """The same integral: first the sum over periods, then tanh-sinh quadrature over a period."""
    scale = amplitude / (2 * alpha)        # A t^2/(8 pi^2 alpha) = scale (n + a)^2, a = phi/(2 pi)
    from_left, distance, weight = tanh_sinh(step, kind)
    total = LONG(0)
    for half in (0, 1):                    # 0..pi and pi..2 pi: crests at the outer ends
        turn = np.where(from_left, distance, 1 - distance) / 2      # from the crest of this half
        start = turn if half == 0 else 1 - turn
        wave = 2 * amplitude * np.sin(PI * turn) ** 2
        offset = (x + wave) / scale
        for coefficient, power in TERMS[order]:
            value = folded_sum(start, offset, power) * scale ** -power
            total += coefficient * np.sum(value * weight, axis=-1) * PI * 2 * PI
    return total


def load(route, alpha, amplitude, x, order=0):
    """Eq 22 and its derivatives in x."""
    return -4 * amplitude / (3 * PI ** 2 * alpha) * route(alpha, amplitude, x, order)


# Tables.

def parameters(words, logarithms):
    if logarithms:
        return tuple(extended(mpf(10) ** mpf(word)) for word in words)
    return tuple(LONG(word) for word in words)


def integral_row(point, agreement):
    alpha, amplitude = parameters(point[:2], False)
    x = 1 - LONG(point[2])
    value = load(folded_integral, alpha, amplitude, x)
    other = load(panels_integral, alpha, amplitude, x)
    agreement.check(f"Eq 22 {point}", exact(value), exact(other))
    return [*point, text(exact(value), DIGITS)]


def curve_points():
    """(alpha, A, number, approach) along each curve."""
    points = []
    for alpha in CURVES:
        steps = math.floor((1 / NEAR_DISTANCE - 1 / FAR_DISTANCE) / CURVE_STEP)
        xs = [round(1 / (1 / FAR_DISTANCE + k * CURVE_STEP), 5) for k in range(steps + 1)]
        kept = [x for x, value in zip(xs, load(coarse, LONG(alpha), LONG(1), np.array(xs))) if value < LAST_LOAD]
        points += [(alpha, "1", str(i + 1), f"{1 - x:.5f}") for i, x in enumerate(kept)]
    return points


def curve_row(point, agreement):
    alpha, amplitude, index, approach = point
    return [alpha, amplitude, index, *integral_row((alpha, amplitude, approach), agreement)[2:]]


def pull_off(alpha, amplitude):
    """x of the global minimum of the load, from the refined local minima of a scan.

    Above x = 3^(1/6) = 1.2009 the tension at every point decreases with x, so there is no minimum.
    """
    xs = np.concatenate([np.geomspace(0.08, 0.5, 30), np.linspace(0.5, 1.21, 143)[1:]]).astype(LONG)
    loads = load(coarse, alpha, amplitude, xs)
    found = []
    for i in range(1, len(xs) - 1):
        if loads[i - 1] >= loads[i] <= loads[i + 1]:
            x = refine(folded_integral, alpha, amplitude, xs[i])
            found.append((load(folded_integral, alpha, amplitude, x), x))
    return min(found)[1]


def coarse(alpha, amplitude, xs, order):
    """At many x, for scans, which need no extended precision."""
    return folded_integral(alpha, amplitude, xs[:, None].astype(float), order, 1 / 24, float)


def refine(route, alpha, amplitude, x, steps=15):
    """Newton's method for the zero of the slope. The curvature is from route 2; it only affects the convergence."""
    for _ in range(steps):
        change = load(route, alpha, amplitude, x, 1) / load(folded_integral, alpha, amplitude, x, 2)
        x = x - change
        if abs(change) < 3e-18 * x:
            break
    return x


def pull_off_row(point, agreement):
    words, logarithms = point
    alpha, amplitude = parameters(words, logarithms)
    x = pull_off(alpha, amplitude)
    other = refine(panels_integral, alpha, amplitude, x, steps=3)
    value = load(folded_integral, alpha, amplitude, x)
    agreement.check(f"pull-off {words}, load", exact(value),
                    exact(load(panels_integral, alpha, amplitude, other)))
    agreement.check(f"pull-off {words}, approach", exact(x), exact(other))
    printed = words if not logarithms else [text(exact(v), DIGITS).removesuffix(".0") for v in (alpha, amplitude)]
    return [*printed, text(-exact(value), DIGITS), text(1 - exact(x), DIGITS)]


def limit_row(words, agreement):
    amplitude, wavelength, radius = (LONG(word) for word in words)
    alpha = amplitude * radius / (wavelength * wavelength)
    return [*words, *pull_off_row(((str(alpha), words[0]), False), agreement)[2:]]


def known():
    """Compares known forces, and a smooth sphere (Bradley, Eq 23): the force tends to 2 as alpha tends to 0."""
    for alpha, amplitude, force in KNOWN:
        alpha, amplitude = LONG(alpha), LONG(amplitude)
        value = -load(folded_integral, alpha, amplitude, pull_off(alpha, amplitude))
        if abs(value - LONG(force)) > 10.0 ** (1 - len(force)) * 5:
            raise ValueError(f"pull-off at alpha {alpha}, A {amplitude}: {value}, not {force}")
    x, flat = LONG("1.1"), LONG("1e-20")
    bradley = -2 * (4 * x ** 6 - 1) / (3 * x ** 8)
    # A smooth sphere: the waves vanish and the curvature remains.
    if abs(load(folded_integral, flat, flat, x) / bradley - 1) > 1e-16:
        raise ValueError("a vanishing waviness is not Bradley's sphere")


def header(what, evidence, uncertainty):
    return {
        "what": what,
        "source": f"{PAPER}, Eqs 21-22",
        "kind": "oracle",
        "method": "sum over periods (Euler-Maclaurin) then tanh-sinh quadrature over one period, against "
                  "20-node Gauss-Legendre panels on quarter waves split towards the crests, with "
                  "Richardson extrapolation in the number of periods; extended precision, 64-bit mantissa",
        "units": INTERFACE_UNITS + "; alpha = A R/lambda^2",
        "uncertainty": uncertainty,
        "evidence": evidence,
        "tabor": "0",
        "generator": "reference/make/rigid.py",
        "command": "python3 reference/make/rigid.py --write",
    }


TABLES = [
    Table("rigid_integral.csv", ["alpha", "amplitude", "approach", "load"],
          [(*pair, approach) for pair in INTEGRAL_PAIRS for approach in APPROACHES],
          integral_row,
          header("load against approach of the rigid wavy sphere, Eq 22", "both routes for every row",
                 "1e-16 relative"),
          limit="1e-16", tolerance="1e-16", stride=29),
    Table("rigid_curves.csv", ["alpha", "amplitude", "index", "approach", "load"],
          curve_points(), curve_row,
          header("load against approach of the rigid wavy sphere, Eq 22: curves of Figure 6, points in "
                 f"order from approach {1 - FAR_DISTANCE} to a load of {LAST_LOAD}",
                 "both routes for every row", "1e-16"),
          limit="1e-16", tolerance="1e-16", absolute="1e-17", stride=331),
    Table("rigid_pull_off.csv", ["alpha", "amplitude", "force", "approach"],
          [(pair, False) for pair in PLAIN]
          + [((alpha, amplitude), True) for amplitude in AMPLITUDES for alpha in ALPHAS],
          pull_off_row,
          header("pull-off (global minimum of the load over approach) of the rigid wavy sphere, Eq 22",
                 "minimum found on both routes, force and 1 - approach compared; global: every local "
                 "minimum of a scan of 1 - approach from 0.08 to 1.21 (above 3^(1/6) every tension falls "
                 "with the gap)",
                 "1e-16 relative of force; 1e-16 absolute of approach"),
          limit="1e-16", tolerance="1e-16", absolute="1e-16", stride=51, checks=known),
    Table("rigid_limit.csv", ["amplitude", "wavelength", "radius", "force", "approach"], LIMITS, limit_row,
          {key: value for key, value in header(
              "pull-off of the rigid wavy sphere, Eq 22, that the elastic one tends to as the Tabor "
              "parameter goes to 0", "as rigid_pull_off.csv",
              "1e-16 relative of force; 1e-16 absolute of approach").items() if key != "tabor"},
          limit="1e-16", tolerance="1e-16", absolute="1e-16", stride=5),
]


if __name__ == "__main__":
    sys.exit(command_line(__doc__, TABLES))
