"""Contact with grooves, route 2: the gap in the grooves by least squares.

Units as in groove_tractions. With the Abel transforms g of the initial gap and Q of the gap h in the grooves

    phi(x) = (D - g + Q)/2,    Q(x) = d/dx int_0^x r h dr/sqrt(x^2 - r^2) = x int_0^x h'(r) dr/sqrt(x^2 - r^2)

the deflection is (4/pi) int_0^r phi dx/sqrt(r^2 - x^2), the load int p s ds = (2/pi) int_0^a phi dx, and the elastic energy
is proportional to int_0^a phi^2 dx, a the outer edge. At given D the gap in the grooves makes the energy least: a linear
problem of least squares. No singular kernel and no traction is involved.

In a groove B < t = r^2 < C dh/dt = sum c_n T_n(t)/sqrt((t - B)(C - t)), n > 0. With t = B + (min(X, C) - B) cos^2 y,
X = x^2, Q = 2x int_0^(pi/2) sum c_n T_n dy/sqrt(|C - X| + (min(X, C) - B) sin^2 y), which is logarithmic at x^2 = C.
"""

from functools import lru_cache

import numpy as np
from scipy.special import struve

PI = np.pi
NODES = 24                # of the inner rules, more than one and a half times the degree of the gap


@lru_cache(maxsize=None)
def double_exponential(degree):
    """A rule on 0 < x < 1 for squares of functions of this degree: distances from both ends, and weights."""
    step = 1.0 / (12.0 + degree)
    u = np.arange(-3.4, 3.4 + 0.5 * step, step)
    q = np.exp(-PI * np.sinh(np.abs(u)))
    near, far = q / (1.0 + q), 1.0 / (1.0 + q)
    weights = step * PI * np.cosh(u) * near * far
    return np.where(u < 0, near, far), np.where(u < 0, far, near), weights


@lru_cache(maxsize=None)
def gauss(count):
    x, w = np.polynomial.legendre.leggauss(count)
    return 0.5 * (1.0 + x), 0.5 * w


def abel_of_profile(alpha, x):
    return x * x + 0.5 * PI * alpha * 2.0 * PI * x * struve(0, 2.0 * PI * x)


class Groove:
    """A groove between two contacts."""

    first, power = 1, 0.0     # of the order n; of t in dh/dt over that of a groove between contacts

    def __init__(self, low, high, room, digits):
        """Given: the edges, and the distance to the nearest other edge on either side."""
        self.low, self.high = low, high
        self.b, self.c = low * low, high * high
        half = 0.5 * (self.c - self.b)
        z = 1.0 + min(self.b - (low - room[0])**2 if low > 0.0 else np.inf, (high + room[1])**2 - self.c) / half
        self.n = int(digits * max(1.6 + 0.8 * (high - low), np.log(10.0) / np.arccosh(z)))
        self.order = np.arange(self.first, self.n + 1)

    def transform(self, x, after, beyond):
        """Q at radii x > low for each coefficient. after, beyond: x - low, x - high, to all their digits."""
        size = np.abs(beyond) * (x + self.high)                        # |C - X|
        span = np.where(beyond < 0.0, after * (x + self.low), self.c - self.b)
        ratio = np.sqrt(size / span)[:, None]
        nodes, weights = gauss(NODES + 3 * self.n // 2)
        v = np.arcsinh(np.sqrt(0.5) / ratio) * nodes
        inner = ratio * np.sinh(v)                                     # sin y up to pi/4
        y = 0.25 * PI * (1.0 + nodes)
        sine = np.concatenate([inner, np.broadcast_to(np.sin(y), inner.shape)], axis=1)
        rule = np.concatenate([np.arcsinh(np.sqrt(0.5) / ratio) * weights / np.sqrt(1.0 - inner**2),
                               0.25 * PI * weights / np.sqrt(ratio**2 + np.sin(y)**2)], axis=1)
        t = span[:, None] * (1.0 - sine**2) / (self.c - self.b)         # 0 at B, 1 at C
        rule = rule * (t * (self.c - self.b))**self.power
        before, now, t = rule * (2.0 * t - 1.0), rule, 2.0 * (2.0 * t - 1.0)   # T_-1, T_0
        values = np.empty((len(x), self.n + 1))
        for n in range(self.n + 1):
            values[:, n] = np.sum(now, axis=1)
            before, now = now, t * now - before
        values = values[:, self.order]
        return 2.0 * (x / np.sqrt(span))[:, None] * values

    def intensities(self, c):
        scale = PI / (self.c - self.b)
        return [np.sqrt(scale * self.low) * (c @ (-1.0) ** self.order), -np.sqrt(scale * self.high) * c.sum()]

    def gap(self, c, r):
        angle = 2.0 * np.arcsin(np.sqrt((r * r - self.b) / (self.c - self.b)))
        return sum(value * (-1) ** n * np.sin(n * angle) / n for n, value in zip(self.order, c))


class Hole(Groove):
    """The groove 0 < r < c without a disc in it: dh/dt = sum c_n T_n(t)/sqrt(C - t), n >= 0, and Q has the summand h(0)."""

    first, power = 0, 0.5

    def gaps(self, r):
        """h(r) for each coefficient."""
        y = np.arccos(r / self.high)
        return -self.high * np.stack([np.sin((2 * n + 1) * y) / (2 * n + 1) + np.sin((2 * n - 1) * y) / (2 * n - 1)
                                      for n in self.order], axis=-1)

    def gap(self, c, r):
        return self.gaps(r) @ c

    def transform(self, x, after, beyond):
        return super().transform(x, after, beyond) + self.gaps(0.0)

    def intensities(self, c):
        return [-np.sqrt(PI * self.high) * c.sum()]


class Gaps:
    """As groove_tractions.Contact."""

    def __init__(self, alpha, edges, digits=15):
        disc = edges[0] == 0.0
        edges = np.array([0.0, *(x for x in edges if x > 0.0)])
        self.alpha, self.outer = alpha, edges[-1]
        width = np.diff(edges)
        self.grooves = [] if disc else [Hole(0.0, edges[1], (0.0, width[1]), digits)]
        self.grooves += [Groove(edges[i], edges[i + 1], (width[i - 1], width[i + 1]), digits)
                         for i in range(1 if disc else 2, len(width), 2)]
        places = np.cumsum([0] + [len(groove.order) for groove in self.grooves])
        self.slices = [slice(i, j) for i, j in zip(places, places[1:])]
        left, right, weights = double_exponential(max((groove.n for groove in self.grooves), default=0))
        rows = [self.row(low, high, left * (high - low), right * (high - low)) for low, high in zip(edges, edges[1:])]
        weights = np.concatenate([weights * (high - low) for low, high in zip(edges, edges[1:])])
        matrix, x = np.concatenate([row[0] for row in rows]), np.concatenate([row[1] for row in rows])
        right = np.stack([-abel_of_profile(alpha, x), np.ones(len(x))], axis=1)
        root = np.sqrt(weights)[:, None]
        self.solution = np.linalg.lstsq(root * matrix, -root * right, rcond=None)[0] if self.grooves else np.zeros((0, 2))
        self.load = weights @ (right + matrix @ self.solution) / PI
        end = np.array([-abel_of_profile(alpha, self.outer), 1.0])                 # 2 phi at the outer edge
        end += self.row(edges[-2], self.outer, width[-1:], np.zeros(1))[0][0] @ self.solution
        self.rule, self.phi = (x, weights), 0.5 * (right + matrix @ self.solution)
        inside = [[k for groove, mine in zip(self.grooves, self.slices) for k in groove.intensities(c[mine])]
                  for c in self.solution.T]
        self.intensity = np.column_stack([np.reshape(inside, (2, -1)), -end / np.sqrt(PI * self.outer)])

    def row(self, low, high, after, before):
        """(Q for each coefficient, x) at the distances `after` low and `before` high."""
        x = np.where(after < before, low + after, high - before)
        matrix = np.zeros((len(x), self.slices[-1].stop if self.slices else 0))
        for groove, mine in zip(self.grooves, self.slices):
            if low >= groove.low:
                beyond = -before if low == groove.low else after if low == groove.high else x - groove.high
                matrix[:, mine] = groove.transform(x, after if low == groove.low else x - groove.low, beyond)
        return matrix, x

    def intensities(self, approach):
        return self.intensity[0] + approach * self.intensity[1]

    def load_at(self, approach):
        return self.load[0] + approach * self.load[1]

    def gap(self, approach, r):
        """The gap at radii r outside of the contacts."""
        c = self.solution @ np.array([1.0, approach])
        for groove, mine in zip(self.grooves, self.slices):
            if np.all((r >= groove.low) & (r <= groove.high)):
                return groove.gap(c[mine], r)
        x, weights = self.rule
        tractions = weights * (self.phi @ np.array([1.0, approach]))
        u = 4.0 / PI * (tractions / np.sqrt((r[:, None] - x) * (r[:, None] + x))).sum(axis=1)
        return u - approach + 0.5 * r * r + self.alpha * (1.0 - np.cos(2.0 * PI * r))
