"""Contact radius of an equilibrium: the outermost radius at which the gap is that of the greatest
tension (where dP/dH = 0; H = 3^(1/6) - 1 for Lennard-Jones)."""

import numpy as np
from numpy.polynomial import chebyshev
from scipy.optimize import brentq

DEGREE = 24               # of the interpolant of the gap on a piece
RESOLVED = 1e-11          # the piece is halved unless its last coefficients over the largest are below this
MOST_HALVINGS = 40
ROUNDING = 1e-9           # largest imaginary part of a real root; also the overlap of pieces
BRACKET = 1e-6            # around a root of the interpolant, relative to the width of its piece
ROOT_TOLERANCE = 1e-15    # of the radius, relative

_POINTS = chebyshev.chebpts1(DEGREE + 1)
_TO_COEFFICIENTS = np.linalg.inv(chebyshev.chebvander(_POINTS, DEGREE))


def gap_between_nodes(problem, state):
    """The gap as a function of an array of radii. The elastic deflection is interpolated by the
    polynomials of the panels, and the undeformed gap is exact."""
    surface = state.surface
    elastic = state.gap + state.approach - problem.profile.gap(surface.u)
    return lambda u: surface.interpolate(elastic, u, 1) - state.approach + problem.profile.gap(u)


def _outermost_root(excess, low, high, halvings=0):
    """The largest zero of `excess` in [low, high], which lies within one panel; None if there is none.
    All real zeros of an interpolant are found at once, as eigenvalues."""
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    coefficients = _TO_COEFFICIENTS @ excess(middle + half * _POINTS)
    size = np.abs(coefficients)
    if coefficients[0] > 2.0 * size[1:].sum():
        return None                           # positive everywhere, whether resolved or not
    if size[-3:].max() > RESOLVED * size.max():
        if halvings == MOST_HALVINGS:
            raise ValueError(f"the gap is not resolved near u = {middle}")
        root = _outermost_root(excess, middle, high, halvings + 1)
        return _outermost_root(excess, low, middle, halvings + 1) if root is None else root
    roots = chebyshev.chebroots(coefficients)
    roots = roots[np.abs(roots.imag) < ROUNDING].real
    roots = roots[np.abs(roots) <= 1.0 + ROUNDING]
    if len(roots) == 0:
        return None
    root = middle + half * min(1.0, roots.max())
    bracket = max(low, root - BRACKET * half), min(high, root + BRACKET * half)
    ends = excess(np.array(bracket))
    if ends[0] * ends[1] < 0.0:               # otherwise the gap only touches the threshold, or the root is an end
        root = brentq(lambda u: excess(np.array([u]))[0], *bracket, xtol=ROOT_TOLERANCE * root,
                      rtol=1e-15)
    return root


def contact_radius(problem, state):
    """The contact radius in the unit of radii of the problem: 0 if the bodies are not in contact, and
    the radius of the surface if it is bounded and in contact up to its edge."""
    gap, peak_gap = gap_between_nodes(problem, state), problem.law.peak_gap
    edges = state.surface.edges
    outside = edges[-1] * np.linspace(1.0, 2.0, 64)
    if problem.outer is None and not gap(outside).min() > peak_gap:
        raise ValueError("the contact reaches the mapped panel")
    if problem.outer is not None and gap(edges[-1:])[0] <= peak_gap:
        return problem.outer

    def excess(u):
        return gap(u) - peak_gap

    for low, high in zip(edges[-2::-1], edges[:0:-1]):
        # a radius on the edge of two panels belongs to the outer one: keep within [low, high)
        root = _outermost_root(excess, low, np.nextafter(high, low))
        if root is not None:
            return root
    return 0.0
