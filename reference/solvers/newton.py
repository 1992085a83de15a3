"""The method of the paper with NumPy: equal triangular elements, Newton's method with a dense LU factorisation, and
pseudo-arclength continuation. Written from the paper (Eqs 9-16); shares nothing with src/.

Lengths in epsilon. The unknowns are the gaps H at the nodes and the approach D:
    H + D - r^2/(2R) - A (1 - cos(2 pi r/lambda)) - c G p(H) = 0,   c = mu^(3/2)/sqrt(R)   (Eqs 2, 15, 16)
    p(H) = -(8/3) [(1 + H)^-3 - (1 + H)^-9],   W/(pi w R) = (2/R) int p r dr               (Eqs 9, 17)
An unbounded surface is cut at r = R; the load beyond is that of the undeformed surfaces (Eq 11).
"""

import numpy as np
from scipy.interpolate import CubicHermiteSpline
from scipy.linalg import lu_factor, lu_solve
from scipy.optimize import brentq
from scipy.special import ellipkm1

import ask

STEP, LONGEST, SHORTEST = 0.05, 0.1, 1e-7    # of the arclength; the longest one applies near contact
STRAIGHT = 0.97                               # least cosine of the angle between neighbouring tangents


def kernel(r, s):
    """G(r, s) of Eq 12; ellipkm1 takes 1 - k^2 = ((r - s)/(r + s))^2."""
    return 4.0 / (np.pi * (r + s)) * ellipkm1(((r - s) / (r + s))**2)


def influence(r):
    """int G(r_i, s) phi_j(s) s ds for the hat functions phi_j. In the elements beside r_i a substitution removes the
    logarithmic singularity."""
    n, h = len(r), r[1]
    matrix = np.zeros((n, n))
    x, w = np.polynomial.legendre.leggauss(8)
    x, w = 0.5 * (x + 1), 0.5 * w
    y, v = np.polynomial.legendre.leggauss(24)
    y, v = 0.5 * (y + 1), 0.5 * v
    near, near_w = y**4, 4 * y**3 * v
    for k in range(n - 1):
        s = r[k] + h * x
        g = kernel(r[:, None], s) * s * (w * h)
        for i, u in ((k, near), (k + 1, 1 - near)):
            s = r[k] + h * u
            rule = kernel(r[i], s) * s * (near_w * h)
            matrix[i, k] += rule @ (1 - u)
            matrix[i, k + 1] += rule @ u
            g[i] = 0.0
        matrix[:, k] += g @ (1 - x)
        matrix[:, k + 1] += g @ x
    return matrix


def traction(gap):
    return -8 / 3 * ((1 + gap)**-3 - (1 + gap)**-9)


def slope(gap):
    return 8 * (1 + gap)**-4 - 24 * (1 + gap)**-10


def orientation(factors):
    """The sign of the determinant. Along a branch it is constant; it changes if a step ends on another part of the branch,
    from where the continuation would go back."""
    upper, pivots = factors
    return np.prod(np.sign(np.diag(upper))) * (-1)**np.count_nonzero(pivots != np.arange(len(pivots)))


class Sphere:
    def __init__(self, scene, nodes):
        radius, outer = scene["radius"], scene["outer_radius"]
        self.cut = radius if np.isinf(outer) else outer
        self.r = np.linspace(0.0, self.cut, int(nodes))
        k = 2 * np.pi / scene["wavelength"]
        self.shape = self.r**2 / (2 * radius) + scene["amplitude"] * (1 - np.cos(k * self.r))
        self.coupling = scene["tabor"]**1.5 / np.sqrt(radius)
        self.matrix = self.coupling * influence(self.r) if self.coupling else np.zeros((len(self.r),) * 2)
        h = self.r[1]
        self.weights = h * self.r                                   # int phi_j s ds
        self.weights[[0, -1]] = h * h / 6, h * (self.cut / 2 - h / 6)
        self.weights *= 2 / radius
        self.unbounded, self.radius = np.isinf(outer), radius

    def load(self, gap, approach):
        tail = 8 / 3 / (self.cut**2 / (2 * self.radius) - approach + 1)**2 if self.unbounded else 0.0
        return self.weights @ traction(gap) - tail

    def correct(self, gap, approach, tangent):
        """Newton's method on the hyperplane through (gap, approach) normal to the tangent. The product of two vectors
        counts all nodes together as much as the approach."""
        n, at = len(gap), np.append(gap, approach)
        gap = np.maximum(gap, -0.5)
        for iteration in range(12):
            jacobian = np.empty((n + 1, n + 1))
            jacobian[:n, :n] = np.eye(n) - self.matrix * slope(gap)
            jacobian[:n, n] = 1.0
            jacobian[n] = self.metric * tangent
            residual = np.append(gap + approach - self.shape - self.matrix @ traction(gap),
                                 self.metric * tangent @ (np.append(gap, approach) - at))
            factors = lu_factor(jacobian, check_finite=False)
            change = lu_solve(factors, -residual, check_finite=False)
            gap = gap + change[:n] / max(1.0, 2 * np.max(-change[:n] / (1 + gap)))
            approach += change[n]
            if np.max(np.abs(change)) < 1e-9:
                direction = lu_solve(factors, np.append(np.zeros(n), 1.0), check_finite=False)
                return gap, approach, direction / np.sqrt(self.metric @ direction**2), iteration, orientation(factors)
            if not np.isfinite(approach):
                break
        raise ArithmeticError("Newton's method did not converge")

    def branch(self, start, ended):
        """Equilibria from `start` on until ended(approach, load): arclength, approach, load, their derivatives by the
        arclength, and the gaps."""
        n = len(self.r)
        self.metric = np.append(np.full(n, 1 / n), 1.0)
        gap, approach, tangent, _, turn = self.correct(self.shape - start, start, np.append(np.zeros(n), 1.0))
        step, length, points = STEP, 0.0, []
        while True:
            load = self.load(gap, approach)
            # the tail depends on the approach alone, and hardly
            rate = self.weights @ (slope(gap) * tangent[:n])
            points.append((length, approach, load, tangent[n], rate, gap))
            if ended(approach, load) or len(points) > 20000:
                return points
            while True:
                try:
                    new = self.correct(gap + step * tangent[:n], approach + step * tangent[n], tangent)
                    if self.metric @ (new[2] * tangent) > STRAIGHT and new[4] == turn:
                        break
                except ArithmeticError:
                    pass
                step /= 2
                if step < SHORTEST:
                    raise ArithmeticError(f"step below {SHORTEST} at approach {approach:.6g}")
            gap, approach, tangent, iterations, _ = new
            length += step
            step = min(LONGEST * max(1.0, gap[0]), step * (1.5 if iterations < 4 else 1.0 if iterations < 6 else 0.6))


def turning(points, which):
    """Where the approach (which = 1) or the load (2) turns along the branch, on the Hermite cubics between the points:
    (is a maximum, approach, load, index of the point before, the part of the way to the next one)."""
    found = []
    for i, (p, q) in enumerate(zip(points, points[1:])):
        if p[which + 2] * q[which + 2] < 0:
            curve = CubicHermiteSpline([p[0], q[0]], [p[1:3], q[1:3]], [p[3:5], q[3:5]])
            at = brentq(lambda s: curve(s, 1)[which - 1], p[0], q[0])
            found.append((p[which + 2] > 0, *curve(at), i, (at - p[0]) / (q[0] - p[0])))
    return found


def contact_radius(sphere, gap):
    """The outermost radius at which the gap is that of the greatest tension, 3^(1/6) - 1."""
    inside = np.flatnonzero(gap < 3**(1 / 6) - 1)
    if len(inside) == 0 or inside[-1] + 1 == len(gap):
        return 0.0 if len(inside) == 0 else sphere.cut
    i = inside[-1]
    return sphere.r[i] + sphere.r[1] * (3**(1 / 6) - 1 - gap[i]) / (gap[i + 1] - gap[i])


def solve(scene, point):
    sphere = Sphere(scene, point["knob"].get("nodes", 501))
    preload, start = point["preload"], point["approach_start"]
    furthest = ask.number(preload["approach"])
    hardest = preload["load"]

    def ended(approach, load):
        return (furthest is not None and approach >= furthest) or (hardest is not None and load >= hardest)

    points = sphere.branch(-12.0 - 2 * scene["amplitude"] if start is None else start, ended)
    extrema, folds = turning(points, 2), turning(points, 1)
    minima = [e for e in extrema if not e[0]]
    if not minima:
        raise ArithmeticError("the load has no minimum up to the preload")
    _, approach, load, index, part = min(minima, key=lambda e: e[2])
    before, after = (contact_radius(sphere, points[i][5]) for i in (index, index + 1))
    return {
        "start": points[0][1], "end": points[-1][1],
        "pull_off": {"force": -load, "approach": approach, "contact_radius": before + part * (after - before)},
        "folds": [{"kind": "jump_in" if top else "jump_out", "approach": d, "load": w} for top, d, w, *_ in folds],
        "extrema": [{"kind": "maximum" if top else "minimum", "approach": d, "load": w} for top, d, w, *_ in extrema],
        "curve": {"approach": [p[1] for p in points], "load": [p[2] for p in points]},
    }


if __name__ == "__main__":
    ask.serve(solve)
