"""Contact on any number of annuli and a central disc, route 1: the tractions of the contacts by collocation.

Units: radii in lambda, heights and approach in lambda^2/R, pressure in E* lambda/R. The deflection of the surface is

    u(r) = int G(r, s) p(s) s ds,    G(r, s) = (4/(pi max)) K(min/max) = 2/agm(r + s, |r - s|),

and u = D - F(r) in the contacts, F(r) = r^2/2 + alpha (1 - cos 2 pi r).

On an annulus p s h sqrt(1 - t^2) is a Chebyshev series in t, r = middle + h t. Its own deflection is that of
G = a ln|r - s| + b with smooth a = -4/(pi agm(r + s, 2 sqrt(rs))) and b: the logarithm is integrated exactly,
int ln|t - t'| T_n(t')/sqrt(1 - t'^2) dt' = -(pi/n) T_n(t), the rest by Gauss-Chebyshev rules.

On a disc of radius b p = sum c_n P_2n(y)/y, y = sqrt(1 - r^2/b^2), whose deflection is pi b P_2n(0)^2 P_2n(y) within it.

The tension at an edge is K/sqrt(2 pi d), d the distance from it.
"""

from functools import lru_cache

import numpy as np
from scipy.special import eval_legendre

PI = np.pi
FINER = 2                 # points of a rule between different contacts, in those of the source
LEAST, DENSITY = 1.6, 0.8 # nodes for each digit, of a contact and of a wavelength in it
MOST = 600                # nodes of a contact


def agm(a, b):
    """The arithmetic-geometric mean of arrays."""
    while np.max(np.abs(a - b) / a) > 1e-8:        # the mean of the last two is off by the square of this
        a, b = 0.5 * (a + b), np.sqrt(a * b)
    return 0.5 * (a + b)


def kernel(r, s):
    return 2.0 / agm(r + s, np.abs(r - s))


@lru_cache(maxsize=None)
def chebyshev(n):
    """Nodes t of Gauss-Chebyshev, matrix of the integral of ln|t - t'| f(t')/sqrt(1 - t'^2), transform to the
    coefficients, and the interpolation to FINER n nodes."""
    angle = (np.arange(n) + 0.5) * PI / n
    order = np.arange(n)
    waves = np.cos(np.outer(order, angle))                       # T_m(t_j)
    transform = 2.0 / n * waves
    transform[0] *= 0.5
    eigen = np.concatenate([[-PI * np.log(2.0)], -PI / order[1:]])
    logarithm = (waves.T * eigen) @ transform
    fine = (np.arange(FINER * n) + 0.5) * PI / (FINER * n)
    return np.cos(angle), logarithm, transform, np.cos(fine), np.cos(np.outer(fine, order)) @ transform


@lru_cache(maxsize=None)
def legendre(n):
    """Collocation points y, P_2m(y), P_2m(0), and a Gauss rule on 0 < y < 1 with P_2m there."""
    def half(count):
        x, w = np.polynomial.legendre.leggauss(2 * count)
        return x[count:], w[count:]

    even = 2 * np.arange(n)
    y = half(n)[0]
    fine, weights = half(FINER * n)
    centre = eval_legendre(even, 0.0)
    return (y, eval_legendre(even[None, :], y[:, None]), centre, fine,
            weights[:, None] * eval_legendre(even[None, :], fine[:, None]))


def count_of(width, rate, digits):
    """Nodes of a contact, whose series converges as exp(-rate n): the nearest edge of another contact decides."""
    return min(MOST, int(digits * max(LEAST + DENSITY * width, np.log(10.0) / rate)))


class Disc:
    """The central contact 0 < r < b."""

    def __init__(self, low, high, groove, digits):
        rate = 2.0 * np.arcsinh(np.sqrt((1.0 + groove / high)**2 - 1.0)) if np.isfinite(groove) else np.inf
        self.b, self.n = high, count_of(high - low, rate, digits)
        y, self.values, self.centre, fine, self.rule = legendre(self.n)
        self.nodes = high * np.sqrt(1.0 - y * y)
        self.sources = high * np.sqrt(1.0 - fine * fine)

    def own(self):
        return PI * self.b * self.values * self.centre**2

    def at(self, r):
        """Deflection at r outside of the contact, a column for each coefficient."""
        return self.b**2 * kernel(r[:, None], self.sources[None, :]) @ self.rule

    def load(self, c):
        """int p s ds."""
        return self.b**2 * c[0]

    def intensities(self, c):
        return [-np.sqrt(PI * self.b) * (self.centre @ c)]


class Annulus:
    """A contact low < r < high, low > 0."""

    def __init__(self, low, high, groove, digits):
        self.middle, self.half = 0.5 * (low + high), 0.5 * (high - low)
        self.n = count_of(high - low, np.arccosh(1.0 + min(groove, low) / self.half), digits)
        t, self.logarithm, self.transform, fine, self.interpolation = chebyshev(self.n)
        self.nodes = self.middle + self.half * t
        self.sources = self.middle + self.half * fine

    def own(self):
        r, s = self.nodes[:, None], self.nodes[None, :]
        a = -4.0 / (PI * agm(r + s, 2.0 * np.sqrt(r * s)))
        apart = np.abs(r - s) + np.eye(self.n)
        b = np.where(np.eye(self.n) > 0, 2.0 * np.log(8.0 * r) / (PI * r), 2.0 / agm(r + s, apart) - a * np.log(apart))
        return a * (self.logarithm + np.log(self.half) * PI / self.n) + b * PI / self.n

    def at(self, r):
        return PI / (FINER * self.n) * kernel(r[:, None], self.sources[None, :]) @ self.interpolation

    def load(self, q):
        return PI * np.mean(q)

    def intensities(self, q):
        series = self.transform @ q
        signs = np.where(np.arange(self.n) % 2, -1.0, 1.0)
        scale = np.sqrt(PI / self.half)
        return [-(signs @ series) * scale / (self.middle - self.half), -series.sum() * scale / (self.middle + self.half)]


def initial_gap(alpha, r):
    return 0.5 * r * r + alpha * (1.0 - np.cos(2.0 * PI * r))


class Contact:
    """The tractions under the edges low, high, low, high... of contacts (a first low of 0: a disc), which are linear in
    the approach D: load = load[0] + D load[1], and so the stress intensities at the edges in this order (0 left out)."""

    def __init__(self, alpha, edges, digits=15):
        self.alpha, self.edges = alpha, np.asarray(edges, float)
        pairs = self.edges.reshape(-1, 2)
        grooves = np.concatenate([[np.inf], pairs[1:, 0] - pairs[:-1, 1], [np.inf]])
        self.parts = [(Disc if low == 0.0 else Annulus)(low, high, min(left, right), digits)
                      for (low, high), left, right in zip(pairs, grooves, grooves[1:])]
        nodes = np.concatenate([part.nodes for part in self.parts])
        ends = np.cumsum([0] + [part.n for part in self.parts])
        self.slices = [slice(i, j) for i, j in zip(ends, ends[1:])]
        matrix = np.empty((len(nodes), len(nodes)))
        for mine, part in zip(self.slices, self.parts):
            for other, there in zip(self.slices, self.parts):
                matrix[other, mine] = part.own() if part is there else part.at(there.nodes)
        right = np.stack([-initial_gap(alpha, nodes), np.ones(len(nodes))], axis=1)
        self.solution = np.linalg.solve(matrix, right)
        columns = [self.solution[:, 0], self.solution[:, 1]]
        self.load = np.array([sum(part.load(c[mine]) for part, mine in zip(self.parts, self.slices)) for c in columns])
        self.intensity = np.array([[k for part, mine in zip(self.parts, self.slices) for k in part.intensities(c[mine])]
                                   for c in columns])

    def intensities(self, approach):
        return self.intensity[0] + approach * self.intensity[1]

    def load_at(self, approach):
        return self.load[0] + approach * self.load[1]

    def gap(self, approach, r):
        """The gap at radii outside of the contacts."""
        tractions = self.solution @ np.array([1.0, approach])
        u = sum(part.at(r) @ tractions[mine] for part, mine in zip(self.parts, self.slices))
        return u - approach + initial_gap(self.alpha, r)
