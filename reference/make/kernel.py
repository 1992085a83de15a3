#!/usr/bin/env python3
"""The elastic kernel (Eq 12), ring coefficients (Eq A4), overlapping-triangle coefficients (Sec. 3.1).

    kernel.py --write [DIR]      regenerate kernel.csv
    kernel.py --sample           recompute a sample, compare (exit 1 on disagreement)

Routes: complete elliptic integrals by the arithmetic-geometric mean, against quadrature of the
Copson (double Abel) form, which contains no elliptic integral:
u(r) = 4/pi int_0^(pi/2) g(r sin(angle)) d(angle), g(t) = int_0^inf p(sqrt(t^2 + x^2)) dx, E* = 1.
"""

import sys

from mpmath import agm, cos, ellipe, ellipk, log, mpf, pi, quad, sin, sqrt

from certified import PAPER, Table, command_line, text

DIGITS = 20
NOT_THERE = "-"           # in a column that this kind of row does not use

POINT_PAIRS = """0 1|1 0|0 1e-9|1 1.5|1.5 1|0.3 0.7|1 1e-8|1e-8 1|1 0.999|1 0.999999|1 0.999999999999
0.999999999999 1|1 1.0000000000000001|123.456 7.89|100 99.75|1e5 99999.5|1e-6 1.1e-6|3.7 41.9|2.5 2.25"""

RING_TRIPLES = """0 1 0|0 1 0.5|0 1 1|0 1 3|0 0.001 0|0 1e-6 100|0 0.2 0.2|1 2 0|1 2 0.5|1 2 1|1 2 1.5
1 2 2|1 2 2.5|1 2 20|1 1.001 1|1 1.001 1.0005|1 1.001 1.001|1 1.001 0.999|1 1.001 50|99.8 100 99.8
99.8 100 99.9|99.8 100 100|99.8 100 0|99.8 100 0.1|0.1 0.2 99.9|0.1 0.2 100|7.3 7.9 7.6|7.3 7.9 7.30001
1e-5 2e-5 1e-5|12.34 56.78 33.3|1 1.000001 1|1 1.000001 1.000001|3 1000 3.5"""

TRIANGLE_QUADS = """0 0 1 0|0 0 1 0.5|0 0 1 1|0 0 1 2|0 0 0.2 0|0 0 0.2 99.8|0 1 2 0|0 1 2 1|0 1 2 0.5
0 1 2 2|0 1 2 3|0 0.2 0.4 0.2|1 2 3 0|1 2 3 1|1 2 3 1.5|1 2 3 2|1 2 3 3|1 2 3 10|1 2 3 1.999999
1 1.1 1.5 1.1|1 1.1 1.5 1|1 1.1 1.5 1.5|1 1.1 1.5 1.2|99.6 99.8 100 99.8|99.6 99.8 100 99.6
99.6 99.8 100 100|99.6 99.8 100 0|99.6 99.8 100 50|99.8 100 100 100|99.8 100 100 99.8|99.8 100 100 0.2
0.2 0.4 0.6 99|7.3 7.4 8.9 7.45|7.3 7.4 8.9 7.35|1e-4 2e-4 3e-4 2e-4|10 10.001 10.002 10.001
10 10.001 10.002 10.002|10 10.001 10.5 10.003|0.5 40 41 40"""


def points():
    """The points (kind, r, s1, s2, s3). In the lists above the radius r is the last number."""
    def words(lists):
        return [entry.split() for line in lists.split("\n") for entry in line.split("|")]
    return ([("point", r, s, "", "") for r, s in words(POINT_PAIRS)]
            + [("ring", r, a, b, "") for a, b, r in words(RING_TRIPLES)]
            + [("triangle", r, a, b, c) for a, b, c, r in words(TRIANGLE_QUADS)])


# Complete elliptic integrals.

def kernel(r, s):
    """Eq 12, with the modulus k; mpmath takes the parameter k^2."""
    low, high = min(r, s), max(r, s)
    return 4 / (pi * high) * ellipk((low / high) ** 2)


def ring_function(c, r):
    """F(c, r), Eq A2, times 4/pi."""
    if c == 0:
        return mpf(0)
    if r <= c:
        return 4 / pi * c * ellipe((r / c) ** 2)
    square = (c / r) ** 2
    return 4 / pi * r * (ellipe(square) - (1 - square) * ellipk(square))


def kernel_offset(r, d):
    """G(r, r + d). It takes d, to avoid the cancellation in the complementary modulus near d = 0."""
    high = max(r, r + d)
    return 2 / (high * agm(1, sqrt(abs(d) * (2 * r + d)) / high))


def side(r, top, foot):
    """int G(r, s) p(s) s ds, with p linear from 1 at top to 0 at foot; the panels in d = s - r are graded towards 0."""
    low, high = sorted((top - r, foot - r))
    edges = {low, high}
    steps = [sign * (foot - top) * mpf(8) ** -i for i in range(13) for sign in (-1, 1)]
    edges.update(d for d in steps + [mpf(0)] if low < d < high)
    return quad(lambda d: kernel_offset(r, d) * (r + d) * (foot - r - d) / (foot - top),
                sorted(edges))


def triangle_elliptic(a, b, c, r):
    """Eq 11 for p that decreases linearly from 1 at b to 0 at a and at c."""
    return (side(r, b, a) if b > a else 0) + (side(r, b, c) if c > b else 0)


# Copson form.

def kernel_copson(r, s):
    """The deflection of a ring load of unit strength at s: g(t) = 1/sqrt(s^2 - t^2) for t < s."""
    low, high = min(r, s), max(r, s)
    gap = (high - low) * (high + low)
    near = sqrt(gap) / high
    edges = [mpf(0)] + [near * 4**i for i in range(60) if near * 4**i < 1] + [pi / 2]
    return 4 / pi * quad(lambda angle: 1 / sqrt(gap + (low * sin(angle)) ** 2), edges)


def abel(p0, p1, a, b, square):
    """g(t) of the traction p0 + p1 s on a < s < b; square = t^2."""
    def primitive(radius):
        x = sqrt(max(radius * radius - square, mpf(0)))
        value = p0 * x
        if p1:
            value += p1 * x * radius / 2
            if square > 0:
                value += p1 * square / 2 * log((x + radius) / sqrt(square))
        return value
    if square >= b * b:
        return mpf(0)
    return primitive(b) - (primitive(a) if square < a * a else 0)


def deflection_copson(pieces, r):
    """Deflection at r of pieces (p0, p1, a, b) of linear traction, by quadrature over t.

    The edges a, b of the pieces below r, and r itself, are ends of panels in t = r sin(angle).
    """
    if r == 0:
        return 4 / pi * pi / 2 * sum(abel(*piece, mpf(0)) for piece in pieces)
    radii = sorted({x for piece in pieces for x in piece[2:] if 0 < x < r})
    marks = [mpf(0)] + radii + [r]
    total = mpf(0)
    for low, high in zip(marks, marks[1:]):
        # t^2 = low^2 + (high^2 - low^2) sin^2(angle): dt and the square roots stay regular.
        span = (high - low) * (high + low)
        rest = (r - high) * (r + high)

        def integrand(angle):
            sine, cosine = sin(angle), cos(angle)
            square = low * low + span * sine * sine
            below = span * cosine * cosine + rest        # r^2 - t^2
            g = sum(abel(*piece, square) for piece in pieces)
            if high == r:
                jacobian = sqrt(span) * sine / sqrt(square) if low else mpf(1)
            else:
                jacobian = span * sine * cosine / (sqrt(square) * sqrt(below)) if low else \
                    sqrt(span) * cosine / sqrt(below)
            return g * jacobian
        total += quad(integrand, graded())
    return 4 / pi * total


def graded():
    """Panels of the angle, graded towards both ends, near which there are square roots and logarithms."""
    ends = [pi / 2 * mpf(8) ** -i for i in range(1, 9)]
    return [mpf(0)] + ends[::-1] + [pi / 2 - x for x in ends] + [pi / 2]


def row(point, agreement):
    kind = point[0]
    numbers = [mpf(x) for x in point[1:] if x]
    r = numbers[0]
    if kind == "point":
        value, other = kernel(*numbers), kernel_copson(*numbers)
        agreement.check(f"{point} agm", value, 2 / agm(r + numbers[1], abs(r - numbers[1])))
    elif kind == "ring":
        a, b = numbers[1:]
        value = ring_function(b, r) - ring_function(a, r)
        other = deflection_copson([(mpf(1), mpf(0), a, b)], r)
    else:
        a, b, c = numbers[1:]
        pieces = []
        if b > a:
            pieces.append((-a / (b - a), 1 / (b - a), a, b))
        if c > b:
            pieces.append((c / (c - b), -1 / (c - b), b, c))
        value = triangle_elliptic(a, b, c, r)
        other = deflection_copson(pieces, r)
    agreement.check(str(point), value, other)
    return [cell or NOT_THERE for cell in point] + [text(value, DIGITS)]


TABLE = Table(
    name="kernel.csv",
    columns=["kind", "r", "s1", "s2", "s3", "value"],
    points=points(),
    row=row,
    header={
        "what": "point: the kernel G(r, s1); ring: deflection at r of unit traction on s1 < s < s2 "
                "(influence coefficient); triangle: deflection at r of a traction 1 at s2 falling "
                "linearly to 0 at s1 and s3 (s1 = s2 or s2 = s3: one side only). E* = 1. -: the kind has "
                "no such radius",
        "source": f"{PAPER}, Eqs 11, 12, A1-A4, Sec. 3.1",
        "kind": "oracle",
        "method": "complete elliptic integrals (arithmetic-geometric mean; triangles: tanh-sinh "
                  "quadrature of Eq 11 closing in on the logarithm), against tanh-sinh quadrature of "
                  "the Copson form, which has no elliptic integral; points also against "
                  "2/agm(r+s, |r-s|); 40 digits carried",
        "units": "r, s1, s2, s3 in any one length; point: 1/length, ring and triangle: length, all "
                 "times 1/E* of unit traction",
        "uncertainty": f"half a unit of digit {DIGITS}",
        "evidence": "both routes for every row",
        "generator": "reference/make/kernel.py",
        "command": "python3 reference/make/kernel.py --write",
    },
    limit="1e-22", tolerance="1e-19", stride=9)


if __name__ == "__main__":
    sys.exit(command_line(__doc__, [TABLE]))
