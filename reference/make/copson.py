"""Elastic half-space under axisymmetric traction, in Copson's double Abel form.

For a traction p(s) on an elastic half-space the deflection is (E* = 1)

    g(t) = int_0^inf  p(sqrt(t^2 + x^2)) dx                         (stage 1)
    v(r) = (4/pi) int_0^{pi/2} g(r sin(phi)) dphi                   (stage 2)

which equals int G(r,s) p(s) s ds with the kernel of Eq 12, but contains
neither an elliptic integral nor a singular integrand.

Discretisation.  The radius [0, U) is divided into panels.  On each panel p and g
are polynomials in q = s^2 through Gauss-Legendre nodes in q.  Along the path
of stage 1 q = t^2 + x^2 is quadratic in x, so the Gauss-Legendre rule of stage
1 is exact for the interpolant; along stage 2 q = r^2 sin^2(phi) is entire in
phi.  As 2 s ds = dq, the Gauss weights in q are also the load weights.
The rest of the surface, [U, inf), is one mapped panel in z = y^(1/root), y = 1/s,
where p = y^decay * polynomial(z) and hence g = y^(decay - 1) * polynomial(z).
If the law decays with the power m of the gap, and the gap grows with the power N of
the radius, then decay = m N, and the polynomial has powers of y^N: root = 1 is for
integer N, root = 2 for half-integer N. Lennard-Jones on a sphere has decay 6 (Eq 11 at
large radii).
"""

import numpy as np
from numpy.polynomial.legendre import leggauss


def legendre_table(x, n):
    """P_0(x) ... P_{n-1}(x) along a new last axis."""
    table = np.empty(x.shape + (n,))
    table[..., 0] = 1.0
    if n > 1:
        table[..., 1] = x
    for k in range(2, n):
        table[..., k] = ((2 * k - 1) * x * table[..., k - 1]
                         - (k - 1) * table[..., k - 2]) / k
    return table


def legendre_transform(n):
    """Nodes, weights on [-1,1] and the matrix (degree x node) that turns nodal
    values into Legendre coefficients (exact for polynomials of degree < n)."""
    x, w = leggauss(n)
    scale = np.arange(n) + 0.5
    return x, w, scale[:, None] * legendre_table(x, n).T * w[None, :]


def _segments(lower, upper, x):
    """Maps the points x of a rule on [-1,1] to the segments [lower_i, upper_i]."""
    half = 0.5 * (upper - lower)
    return half[:, None] * (x[None, :] + 1.0) + lower[:, None], half


class Surface:
    """Panels, nodes, load weights and the deflection matrix.

    edges   increasing panel edges in s, edges[0] = 0
    order   nodes in each panel
    tail    nodes in the mapped panel [edges[-1], inf); 0 = bounded surface
            (p = 0 beyond edges[-1]; grade the edges towards it)
    extra   quadrature points above the minimum, to test the quadrature itself
    decay, root     of the mapped panel
    exempt  for each panel, whether it touches a kink of the profile. No polynomial resolves a kink, so such
            a panel is only as narrow as the grading makes it
    """

    def __init__(self, edges, order, tail, extra=0, decay=6.0, root=1, exempt=None):
        self.decay, self.root = decay, root
        self.edges = np.asarray(edges, float)
        self.order, self.tail, self.extra = order, tail, extra
        self.panels = len(self.edges) - 1
        self.exempt = np.zeros(self.panels, bool) if exempt is None else exempt
        x, w, self.to_legendre = legendre_transform(order)
        self.q_edges = self.edges**2
        low, high = self.q_edges[:-1], self.q_edges[1:]
        q, half = _segments(low, high, x)
        self.q = q.ravel()
        self.weights = (half[:, None] * w[None, :]).ravel()   # int p 2 s ds
        if tail:
            xt, wt, self.tail_to_legendre = legendre_transform(tail)
            self.cut = self.edges[-1]
            z = 0.5 * (xt + 1.0)                          # (cut y)^(1/root)
            y = z**root / self.cut
            self.tail_y = y
            self.q = np.append(self.q, y**-2)
            # 2 s ds = 2 y^-3 dy, dy = root z^(root - 1) dz/cut
            self.weights = np.append(self.weights, wt / self.cut * y**-3 * (root * z**(root - 1)))
        self.u = np.sqrt(self.q)
        self.size = len(self.q)
        self.deflection = (4.0 / np.pi) * (self._stage2() @ self._stage1())
        # value at s = 0: the first panel's interpolant at its left end
        self.centre = legendre_table(np.array([-1.0]), order)[0] @ self.to_legendre

    def columns(self, k):
        """Node indices of panel k (k = self.panels is the mapped panel)."""
        if k == self.panels:
            return slice(k * self.order, self.size)
        return slice(k * self.order, (k + 1) * self.order)

    def _panel_rows(self, k, q, weight):
        """sum_m weight[i,m] * (Lagrange basis of panel k at q[i,m])."""
        low, high = self.q_edges[k], self.q_edges[k + 1]
        xi = (2.0 * q - (low + high)) / (high - low)
        moments = np.einsum("im,iml->il", weight, legendre_table(xi, self.order))
        return moments @ self.to_legendre

    def _tail_rows(self, y, weight, power):
        """The same for y^power * polynomial(z) on the mapped panel."""
        xi = 2.0 * (y * self.cut)**(1.0 / self.root) - 1.0
        moments = np.einsum("im,iml->il", weight * (y * self.cut)**power,
                            legendre_table(xi, self.tail))
        return (moments @ self.tail_to_legendre) / (self.tail_y * self.cut)**power

    def _stage1(self):
        """g(t_i) = sum_j A_ij p_j at the nodes t_i."""
        a = np.zeros((self.size, self.size))
        x, w = leggauss(self.order + self.extra)      # exact: degree 2 order - 2
        for k in range(self.panels):
            rows = np.flatnonzero(self.q < self.q_edges[k + 1])
            qi = self.q[rows]
            start = np.sqrt(np.maximum(self.q_edges[k] - qi, 0.0))
            path, half = _segments(start, np.sqrt(self.q_edges[k + 1] - qi), x)
            a[rows, self.columns(k)] = self._panel_rows(
                k, qi[:, None] + path**2, half[:, None] * w[None, :])
        if self.tail:
            # x = t cot(t eta): s = t / sin(t eta) = 1/y; eta = zeta^root makes z smooth in zeta
            x, w = leggauss(2 * self.tail + self.extra)
            t = self.u
            stop = (np.arcsin(np.minimum(t / self.cut, 1.0)) / t)**(1.0 / self.root)
            zeta, half = _segments(np.zeros_like(t), stop, x)
            y = np.sin(t[:, None] * zeta**self.root) / t[:, None]
            weight = half[:, None] * w[None, :] * (self.root * zeta**(self.root - 1))
            # dx = -y^-2 d eta takes two of the powers of y
            a[:, self.columns(self.panels)] = self._tail_rows(y, weight, self.decay - 2) / self.tail_y**2
        return a

    def _stage2(self):
        """int_0^{pi/2} g(r_i sin phi) dphi = sum_j B_ij g_j."""
        b = np.zeros((self.size, self.size))
        # enough points for sin^2(phi)^(order-1) on a whole quarter turn
        x, w = leggauss(2 * self.order + 8 + self.extra)
        for k in range(self.panels):
            rows = np.flatnonzero(self.q > self.q_edges[k])
            low, high = self._angle(self.q_edges[k], rows), self._angle(self.q_edges[k + 1], rows)
            phi, half = _segments(low, high, x)
            b[rows, self.columns(k)] = self._panel_rows(
                k, self.q[rows, None] * np.sin(phi)**2, half[:, None] * w[None, :])
        if self.tail:
            x, w = leggauss(2 * self.tail + 8 + self.extra)
            start = self.cut
            while start < self.u.max():               # octaves: g ~ t^(1 - decay) is steep
                rows = np.flatnonzero(self.u > start)
                low, high = self._angle(start**2, rows), self._angle(4 * start**2, rows)
                phi, half = _segments(low, high, x)
                y = 1.0 / (self.u[rows, None] * np.sin(phi))
                b[rows, self.columns(self.panels)] += self._tail_rows(
                    y, half[:, None] * w[None, :], self.decay - 1)
                start *= 2.0
        return b

    def _angle(self, q_edge, rows):
        """asin(min(t/r, 1)) without cancellation for t near r."""
        q = self.q[rows]
        return np.arctan2(np.sqrt(np.minimum(q_edge, q)), np.sqrt(np.maximum(q - q_edge, 0.0)))

    def load(self, p):
        """2 int p s ds (the normalised load of Eq 15)."""
        return self.weights @ p

    def interpolate(self, f, u, decay=0):
        """Panel interpolant of nodal values f at radii u; beyond the last edge
        f * s^decay is interpolated in z."""
        u = np.asarray(u, float)
        out = np.empty_like(u)
        k = np.clip(np.searchsorted(self.edges, u, side="right") - 1, 0, self.panels)
        for m in np.unique(k):
            at = k == m
            values = f[self.columns(m)] if m < self.panels or self.tail else f[self.columns(m - 1)]
            if m == self.panels and self.tail:
                one = np.ones((at.sum(), 1))
                out[at] = self._tail_rows(1.0 / u[at][:, None], one, decay) @ values
            else:
                m = min(m, self.panels - 1)
                one = np.ones((at.sum(), 1))
                out[at] = self._panel_rows(m, u[at][:, None]**2, one) @ values
        return out

    def roughness(self, f):
        """For each finite panel the size of the last two Legendre coefficients of f
        relative to max|f|, as a measure of the unresolved part."""
        n = self.panels * self.order
        coefficients = f[:n].reshape(self.panels, self.order) @ self.to_legendre.T
        return np.where(self.exempt, 0.0, np.abs(coefficients[:, -2:]).max(axis=1) / np.abs(f).max())


def dyadic_edges(cut, unresolved, least_level, most_level):
    """Panel edges of [0, cut]. Panels are halved where unresolved(low, high) is true;
    every panel has between least_level and most_level halvings."""
    edges = [0.0]
    stack = [(0, 0)]                                   # (level, index)
    while stack:
        level, index = stack.pop()
        width = cut / 2**level
        low, high = index * width, (index + 1) * width
        if level < least_level or (level < most_level and unresolved(low, high)):
            stack += [(level + 1, 2 * index + 1), (level + 1, 2 * index)]
        else:
            edges.append(high)
    return np.array(edges)
