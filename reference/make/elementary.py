#!/usr/bin/env python3
"""Elementary and special functions of doubles, to twice the precision of a double.

    elementary.py --write [DIR]      regenerate elementary.csv
    elementary.py --sample           recompute a sample, compare (exit 1 on disagreement)

Routes: mpmath against the `decimal` module of Python (exponential, logarithms, and Taylor's series of sine, cosine and
arctangent), and for the special functions against quadrature of an integral representation.
"""

import decimal
import random
import sys
from decimal import Decimal

import mpmath
from mpmath import mp, mpf

from certified import Table, command_line

decimal.setcontext(decimal.Context(prec=800, Emax=decimal.MAX_EMAX, Emin=decimal.MIN_EMIN))


def series(term, factor):
    """The sum of the terms t_0 = term, t_(k+1) = t_k factor(k)."""
    total, k = term, 0
    while term and term.adjusted() > total.adjusted() - 800:
        term *= factor(k)
        total += term
        k += 1
    return total


def arctangent(x):
    """Of 0 <= x <= 1, by halving the angle, then Taylor's series."""
    halvings = 0
    while x > Decimal("0.05"):
        x /= 1 + (1 + x * x).sqrt()
        halvings += 1
    total, power, k = Decimal(0), x, 0
    while power and power.adjusted() > x.adjusted() - 800:
        total += (-1) ** k * power / (2 * k + 1)
        power *= x * x
        k += 1
    return total * 2 ** halvings


PI = 4 * (4 * arctangent(Decimal(1) / 5) - arctangent(Decimal(1) / 239))


def sine(x, quarter):
    """sin(x + quarter pi/2)."""
    turns = (x / (PI / 2)).to_integral_value()
    x -= turns * (PI / 2)
    place = (int(turns) + quarter) % 4
    even = 1 - place % 2
    value = series(x if even else Decimal(1), lambda k: -x * x / ((2 * k + 1 + even) * (2 * k + 2 + even)))
    return -value if place > 1 else value


def angle(y, x):
    """atan2(y, x)."""
    least, most = sorted((abs(x), abs(y)))
    value = arctangent(least / most)
    value = PI / 2 - value if abs(y) > abs(x) else value
    value = PI - value if x < 0 else value
    return -value if y < 0 else value


def power(x, y):
    return (y * x.ln()).exp()


def inverse_sine(x):
    """Hyperbolic."""
    size = (abs(x) + (x * x + 1).sqrt()).ln()
    return -size if x < 0 else size


def integral(f, edges):
    return mpmath.quad(f, edges)


def gamma_integral(x):
    """By the recurrence from Gamma(x + 20), whose integrand is smooth at 0."""
    shift = 20
    most = x + shift
    return (integral(lambda t: t ** (most - 1) * mpmath.exp(-t), mpmath.linspace(0, 4 * most + 120, 40))
            / mpmath.rf(x, shift))


def beta_integral(a, b, x=1):
    """With t = x s^p, which makes the integrand smooth at 0; at 1 for x = 1 likewise, by halves."""
    def part(a, b, x):
        p = 12 / min(a, mpf(1))
        return integral(lambda s: p * x ** a * s ** (p * a - 1) * (1 - x * s ** p) ** (b - 1), [0, 0.3, 0.6, 0.8, 0.9, 0.95, 1])
    return part(a, b, x) if x < 0.75 else part(a, b, mpf(0.5)) + part(b, a, mpf(0.5)) - (part(b, a, 1 - mpf(x)) if x < 1 else 0)


def bessel_i(x):
    return integral(lambda t: mpmath.exp(x * (mpmath.cos(t) - 1)), mpmath.linspace(0, mpmath.pi, 9)) / mpmath.pi


def both(of_mpmath, of_decimal):
    """The two routes of an elementary function."""
    return (of_mpmath, lambda *x: mpf(str(of_decimal(*(Decimal(float(a)) for a in x)))))


ROUTES = {
    "exp": both(mpmath.exp, Decimal.exp),
    "expm1": both(mpmath.expm1, lambda x: x.exp() - 1),
    "log": both(mpmath.log, Decimal.ln),
    "log1p": both(mpmath.log1p, lambda x: (1 + x).ln()),
    "log10": both(mpmath.log10, Decimal.log10),
    "pow": both(mpmath.power, power),
    "sin": both(mpmath.sin, lambda x: sine(x, 0)),
    "cos": both(mpmath.cos, lambda x: sine(x, 1)),
    "sinpi": both(mpmath.sinpi, lambda x: sine(x * PI, 0)),
    "cospi": both(mpmath.cospi, lambda x: sine(x * PI, 1)),
    "atan2": both(mpmath.atan2, angle),
    "sinh": both(mpmath.sinh, lambda x: (x.exp() - (-x).exp()) / 2),
    "cosh": both(mpmath.cosh, lambda x: (x.exp() + (-x).exp()) / 2),
    "asinh": both(mpmath.asinh, inverse_sine),
    "cbrt": both(mpmath.cbrt, lambda x: power(x, Decimal(1) / 3)),
    "hypot": both(mpmath.hypot, lambda x, y: (x * x + y * y).sqrt()),
    "gamma": (lambda x: mpmath.gamma(x), gamma_integral),
    "beta": (mpmath.beta, beta_integral),
    "beta_incomplete": (lambda a, b, x: mpmath.betainc(a, b, 0, x), beta_integral),
    "bessel_i0_scaled": (lambda x: mpmath.besseli(0, x) * mpmath.exp(-x), bessel_i),
}
SMOOTH = {"gamma", "beta", "beta_incomplete", "bessel_i0_scaled"}  # compared with quadrature


def points():
    """Hard cases of the literature, ends of ranges, and arguments at random."""
    draw = random.Random(28)

    def sizes(low, high, count, signs=False):
        return [(draw.choice((-1, 1)) if signs else 1) * 10 ** draw.uniform(low, high) for _ in range(count)]

    made = []
    for x in [1e-250, -1e-9, 7.5417527749959590e-10, 0.5, 1.0, -640.0, 699.0, 0.6931471805599453] + sizes(-6, 2.8, 20, True):
        made.append(("exp", x))
    for x in [1e-17, -1e-8, 0.3, -0.7, 1.0, 37.0, -36.0] + sizes(-9, 1.5, 16, True):
        made.append(("expm1", x))
    for x in [1e-280, 2.3e-308, 0.9999999999999999, 1.0000000000000002, 2.0, 0.7071067811865475, 1.7e308] + sizes(-300, 300, 12) + sizes(-1, 1, 12):
        made += [("log", x), ("log10", x)]
    for x in [1e-18, -1e-9, -0.9999999, 1e-3, 1.0, 1e15] + sizes(-12, 2, 14):
        made.append(("log1p", x))
    for x, y in [(2.0, 0.5), (1.0000000001, 1e9), (0.1, 250.0), (10.0, -250.0), (1.0000000000000002, 1e18), (3.0, 7.0)] + \
            list(zip(sizes(-8, 8, 24), sizes(-2, 1.5, 24, True))):
        made.append(("pow", x, y))
    for x in [1e-9, 0.7853981633974483, 1.5707963267948966, 3.141592653589793, 22.0, 1e5, 6381956970095103.0 * 2.0 ** 797,
              1.7e308, 355.0, 103993.0] + sizes(-4, 1, 12, True) + sizes(1, 300, 8, True):
        made += [("sin", x), ("cos", x)]
    for x in [1e-250, 1e-9, 0.25, 0.4999999999999999, 1.0000000000000002, 123456.789, 4503599627370495.5] + sizes(-5, 3, 16, True):
        made += [("sinpi", x), ("cospi", x)]
    for y, x in [(1e-250, 1.0), (1.0, -1.0), (-1.0, 1e-250), (1.0, 1.0000000000000002)] + list(zip(sizes(-3, 3, 16, True), sizes(-3, 3, 16, True))):
        made.append(("atan2", y, x))
    for x in [1e-10, 0.3, 1.0, 39.0, 41.0, 709.9] + sizes(-6, 2.8, 14, True):
        made += [("sinh", x), ("cosh", x)]
    for x in [1e-12, 1.0, 1e8, 1e200] + sizes(-5, 5, 12, True):
        made.append(("asinh", x))
    for x in [8.0, 1e-300, 1e300, 2.0] + sizes(-10, 10, 12):
        made.append(("cbrt", x))
    for x, y in [(3.0, 4.0), (1e200, 1e200), (1e-200, 3e-200), (1.0, 1e-8)] + list(zip(sizes(-3, 3, 12), sizes(-3, 3, 12))):
        made.append(("hypot", x, y))
    for x in [0.5, 1.0, 1.5, 5.0, 0.01, 30.25, 100.0] + sizes(-1, 1.8, 10):
        made.append(("gamma", x))
    for a, b in [(0.5, 0.5), (1.0, 3.0), (20.0, 0.5)] + list(zip(sizes(-0.5, 1.3, 10), sizes(-0.5, 1.3, 10))):
        made += [("beta", a, b), ("beta_incomplete", a, b, draw.uniform(0.02, 0.98))]
    for x in [1e-6, 0.5, 1.0, 10.0, 29.0, 31.0, 700.0] + sizes(-1, 3, 10):
        made.append(("bessel_i0_scaled", x))
    return made


def row(point, agreement):
    name, arguments = point[0], point[1:]
    mp.dps = 40 if name in SMOOTH else 100
    first, second = ROUTES[name]
    value, other = first(*map(mpf, arguments)), second(*map(mpf, arguments))
    if name in SMOOTH:
        agreement.check(f"{point}", value, other, 1e6 * max(abs(value), mpf("0.01")))
    else:
        agreement.check(f"{point}", value, other, abs(value) or 1)
    high = float(value)
    return [name] + [repr(float(x)) for x in (arguments + (0.0, 0.0))[:3]] + [repr(high), repr(float(value - mpf(high)))]


TABLE = Table(
    name="elementary.csv",
    columns=["function", "a", "b", "c", "value", "rest"],
    points=points(),
    row=row,
    header={
        "what": "elementary and special functions of the doubles a, b, c: pow(a, b), atan2(a, b), hypot(a, b), beta(a, b), "
                "beta_incomplete(a, b; c), the others of a",
        "source": "mpmath; Python's decimal module; integral representations of the NIST Digital Library of Mathematical "
                  "Functions (5.2.1, 5.12.1, 8.17.1, 10.32.1)",
        "kind": "oracle",
        "method": "mpmath at 100 digits against exponential and logarithm of libmpdec and Taylor's series at 800 digits; for "
                  "gamma, beta and Bessel functions at 40 digits against quadrature, to 1e-24",
        "units": "none; the arguments are the doubles as printed; the value is `value` + `rest`, two doubles",
        "uncertainty": "1e-31 of the value",
        "evidence": "both routes at every point",
        "generator": "reference/make/elementary.py",
        "command": "python3 reference/make/elementary.py --write",
        "date": "2026-11-24",
    },
    limit="1e-30", tolerance="1e-16", stride=7, absolute="0")


if __name__ == "__main__":
    sys.exit(command_line(__doc__, [TABLE]))
