#!/usr/bin/env python3
"""Struve functions H0, H1, H2 and the differences H_n - Y_n (Eq 5 needs H0, H1, H2).

    struve.py --write [DIR]      regenerate struve.csv
    struve.py --sample           recompute a sample, compare (exit 1 on disagreement)

Routes: the power series in integer (fixed-point) arithmetic with enough bits for its cancellation,
against quadrature of an integral representation. Equation numbers are those of the DLMF.
"""

import sys
from fractions import Fraction

from mpmath import asinh, bessely, cos, cosh, exp, mpf, pi, quad, sin, sinh

from certified import Table, command_line, text

DIGITS = 20
FINITE_RANGE = 40         # up to this x H_n is the integral over a finite range

# Numbers above 16 are exact binary fractions, so that reading them in double precision does not change the phase.
POINTS = """1e-8 1e-6 1e-5 0.0001 0.001 0.01 0.03 0.1 0.25 0.3 0.5 0.75 1 1.3 1.6 2 2.5 3 3.14159265358979
3.5 3.9 4 4.33 4.5 4.9 5 6 6.78 7 7.5 7.99 8 8.01 9 9.5 10 11 12 12.5 13 14.9 15 16 16.0078125 17 19.5
20 22.75 24.9921875 25 29.5 30.0078125 33.25 40 49.75 63.9375 100 123.4375 250.5 500.25 1000.5
1024 3141.59375 9999.9375 12345.625 50000.5 100000""".split()

KNOWN = ((1, "2", "0.6467637282835622"), (2, "3", "0.74238666967748318564"),
         (1, "9", "0.7485424374510771033"))

FACTOR = (Fraction(2), Fraction(2, 3), Fraction(2, 15))   # of x^(n+1)/pi: the first term


def series(n, x):
    """H_n from its power series, DLMF 11.2.1, with the terms as integers scaled by a power of two.

    The largest term is about exp(x). It needs x/log 2 bits above the sum, and as many are kept below.
    """
    x = Fraction(x)
    bits = int(float(x) * 1.4427) + 260
    square, over = (x * x).numerator, (x * x).denominator
    term = total = 1 << bits
    k = 0
    while term:
        term = -term * square // (over * (2 * k + 3) * (2 * k + 2 * n + 3))
        if term == -1:
            break
        total += term
        k += 1
    factor = FACTOR[n] * x ** (n + 1)
    return mpf(total) / mpf(2) ** bits * factor.numerator / factor.denominator / pi


def finite_integral(n, x):
    """H_n from DLMF 11.5.1 with t = cos(angle): no special function, no cancellation."""
    weight = (2 / pi, 2 * x / pi, 2 * x * x / (3 * pi))[n]
    pieces = 1 + int(x / 12)
    edges = [pi / 2 * i / pieces for i in range(pieces + 1)]
    return weight * quad(lambda angle: sin(x * cos(angle)) * sin(angle) ** (2 * n), edges,
                         method="gauss-legendre")


def difference_integral(n, x):
    """H_n - Y_n from DLMF 11.5.2 with t = sinh(y), by tanh-sinh quadrature on subintervals."""
    weight = (2 / pi, 2 * x / pi, 2 * x * x / (3 * pi))[n]
    last = asinh(150 / x)      # beyond, exp(-x sinh(y)) < 1e-65
    pieces = 2 + int(last / 2)
    edges = [last * i / pieces for i in range(pieces + 1)]
    return weight * quad(lambda y: exp(-x * sinh(y)) * cosh(y) ** (2 * n), edges)


def row(point, agreement):
    name = point[0]
    x = mpf(name)
    first, second = [], []
    for n in range(3):
        value = series(n, name)
        remainder = difference_integral(n, x)
        other = finite_integral(n, x) if x <= FINITE_RANGE else remainder + bessely(n, x)
        first.append(agreement.check(f"H{n}({name})", value, other))
        second.append(agreement.check(f"H{n}({name}) - Y{n}({name})", remainder,
                                      value - bessely(n, x)))
    return [name] + [text(value, DIGITS) for value in first + second]


def known():
    """Compares published values."""
    for n, x, value in KNOWN:
        digits = len(value) - 2
        if abs(series(n, x) - mpf(value)) > mpf(10) ** -digits:
            raise ValueError(f"H{n}({x}) is not the published {value}")


TABLE = Table(
    name="struve.csv",
    columns=["x", "h0", "h1", "h2", "h0_minus_y0", "h1_minus_y1", "h2_minus_y2"],
    points=[(x,) for x in POINTS],
    row=row,
    header={
        "what": "Struve functions H0, H1, H2 and the differences H_n - Y_n",
        "source": "NIST Digital Library of Mathematical Functions, Eqs 11.2.1, 11.5.1, 11.5.2; known "
                  "values H1(2) = 0.6467637282835622, H2(3) = 0.74238666967748318564, "
                  "H1(9) = 0.7485424374510771033 reproduced (some copies of the TOMS 757 test table "
                  "carry wrong arguments for H1(9), H1(9.5), H1(12), H1(17): these rows settle them)",
        "kind": "oracle",
        "method": "power series in integer arithmetic, as many extra bits as its cancellation takes; "
                  f"against Gauss-Legendre quadrature of 11.5.1 (x <= {FINITE_RANGE}) or tanh-sinh "
                  "quadrature of 11.5.2 plus Y_n; differences: tanh-sinh against series minus Y_n; "
                  "40 digits carried",
        "units": "none; x above 16 are exact binary fractions, all x exact decimals as printed",
        "uncertainty": f"half a unit of digit {DIGITS}",
        "evidence": "both routes at every x",
        "generator": "reference/make/struve.py",
        "command": "python3 reference/make/struve.py --write",
    },
    limit="1e-26", tolerance="1e-19", stride=8, checks=known)


if __name__ == "__main__":
    sys.exit(command_line(__doc__, [TABLE]))
