"""Exact results that the elastic operator and the solver must give."""

from math import pi, sin

import numpy as np
from scipy.integrate import quad
from scipy.optimize import minimize_scalar
from scipy.special import ellipkm1, ive

from branch import POLISH, TRACE, State, smooth_sphere
from contact import contact_radius
from copson import Surface, dyadic_edges
from landmarks import find_landmarks, polish, trace
import wavy_sphere

OPERATOR_TOLERANCE = 1e-13    # a few hundred rounding errors
RIGID_TOLERANCE = 1e-8        # larger than mu^1.5 = 1e-9, the order of the elastic correction
RIGID_TABOR = 1e-6
KERNEL_TOLERANCE = 1e-11       # limited by the adaptive quadrature
QUAD = {"epsabs": 1e-12, "epsrel": 1e-12, "limit": 400}
CUT_SCENE = wavy_sphere.Scene("1", "1", "20", "100", "31.7", 0.5, 0.5)
UNIFORM, CUT = 4, 8.0         # 2^4 equal panels up to s = 8
NEAR, SCAN = 1e-9, 400001     # distance of the gap of a crest from the threshold of contact; points of a scan


def check(name, error, tolerance):
    print(f"{name:62s} {error:.1e}  (allowed {tolerance:.0e})")
    if not error <= tolerance:
        raise ValueError(f"self-test: {name}: error {error:.1e}")


def _unbounded():
    return Surface(dyadic_edges(CUT, lambda low, high: False, UNIFORM, UNIFORM), 16, 24)


def gaussian():
    """p = exp(-s^2) -> sqrt(pi) exp(-r^2/2) I0(r^2/2)."""
    s = _unbounded()
    p = np.exp(-s.q)
    exact = np.sqrt(pi) * ive(0, 0.5 * s.q)
    check("Gaussian: deflection, relative, all radii",
           np.abs(s.deflection @ p / exact - 1).max(), OPERATOR_TOLERANCE)
    check("Gaussian: load 1", abs(s.load(p) - 1), OPERATOR_TOLERANCE)


def power():
    """p = (1+s^2)^-3, the decay of the far traction: g = (3 pi/16)(1+t^2)^(-5/2)."""
    s = _unbounded()
    p = (1.0 + s.q)**-3

    def exact(r):
        f = lambda phi: 0.75 * (1.0 + (r * sin(phi))**2)**-2.5
        marks = [0.0] + [m / r for m in (1.0, 4.0, 16.0, 64.0) if m < r] + [pi / 2]
        return sum(quad(f, a, b, epsabs=0, epsrel=1e-13, limit=200)[0]
                   for a, b in zip(marks, marks[1:]))

    far = np.array([exact(r) for r in s.u])
    check("(1+s^2)^-3: deflection, relative, to the last far node",
           np.abs(s.deflection @ p / far - 1).max(), OPERATOR_TOLERANCE)
    check("(1+s^2)^-3: load 1/2", abs(s.load(p) - 0.5), OPERATOR_TOLERANCE)


def hertz():
    """p = sqrt(1-s^2) on the bounded surface s < 1 -> (pi/4)(2-r^2)."""
    edges = np.append(1.0 - 0.5**np.arange(30), 1.0)      # graded to the edge
    s = Surface(edges, 16, 0)
    p = np.sqrt(1.0 - s.q)
    check("Hertz: deflection, r < 1",
           np.abs(s.deflection @ p - pi / 4 * (2 - s.q)).max(), OPERATOR_TOLERANCE)
    check("Hertz: load 2/3", abs(s.load(p) - 2 / 3), OPERATOR_TOLERANCE)


def reciprocity():
    """Betti: the work of one traction on the deflection of another is mutual."""
    s = _unbounded()
    one, two = np.exp(-s.q), (1.0 + s.q)**-3 * np.cos(s.q / (1.0 + s.q))
    a, b = s.load(one * (s.deflection @ two)), s.load(two * (s.deflection @ one))
    check("reciprocity, relative", abs(a / b - 1), OPERATOR_TOLERANCE)


def bradley():
    """Rigid limit, Eq 23: pull-off 2 at approach 0."""
    problem = smooth_sphere(RIGID_TABOR)
    marks = find_landmarks(problem, trace(problem, TRACE, -4.0, 1.0))
    state = polish(problem, marks[-1], POLISH[1]).state
    x = 1.0 - state.approach
    radius = np.sqrt(2.0 * (problem.law.peak_gap + state.approach) / RIGID_TABOR)
    check("rigid limit: contact radius, relative", abs(contact_radius(problem, state) / radius - 1),
           RIGID_TOLERANCE)
    check("rigid limit: one landmark only", len(marks) - 1, 0)
    check("rigid limit: pull-off 2", abs(state.load + 2.0), RIGID_TOLERANCE)
    check("rigid limit: load of Eq 23 at the same approach",
           abs(state.load + 2 * (4 * x**6 - 1) / (3 * x**8)), RIGID_TOLERANCE)


def contact():
    """The contact radius of undeformed waves on coarse panels, compared with the crossings of a fine scan.
    Each crest in turn is beyond the threshold of contact by NEAR, below it by NEAR, or far beyond it."""
    problem = wavy_sphere.Scene("1", "5", "12", "100", "inf", 0.0, 0.0).problem()
    surface, scan = _unbounded(), np.linspace(0.0, CUT, SCAN)
    shape = problem.profile.gap(scan)
    crests = np.flatnonzero((shape[1:-1] < shape[:-2]) & (shape[1:-1] < shape[2:])) + 1
    worst = 0.0
    for crest in crests:
        lowest = minimize_scalar(problem.profile.gap, bounds=scan[[crest - 1, crest + 1]], method="bounded",
                                 options={"xatol": 1e-12}).fun
        for depth in (NEAR, -NEAR, 0.3):
            approach = lowest + depth - problem.law.peak_gap
            state = State(surface, problem.profile.gap(surface.u) - approach, approach, 0.0, 0.0)
            inside = np.flatnonzero(shape - approach <= problem.law.peak_gap)
            if depth == NEAR:                     # narrower than the step of the scan: its half-width is neglected
                inside = np.array([crest])
            edge = scan[inside[-1]] if len(inside) else 0.0
            worst = max(worst, abs(contact_radius(problem, state) - edge))
    check(f"contact radius of undeformed waves, {len(crests)} crests", worst,
           2.0 * (CUT / SCAN + np.sqrt(NEAR)))


def equation_16(problem, state, radii):
    """Largest error of Eq 16 at radii between the nodes, with the elliptic
    kernel of Eq 12 (the one use of it) integrated by an adaptive rule."""
    s = state.surface
    elastic = state.gap + state.approach - problem.profile.gap(s.u)

    def gap(v):
        v = np.array([v])
        return s.interpolate(elastic, v, 1) - state.approach + problem.profile.gap(v)

    def integrand(v, u):
        ratio = min(u, v) / max(u, v)
        green = 4.0 / (pi * max(u, v)) * ellipkm1((1.0 - ratio) * (1.0 + ratio))
        return green * problem.traction(gap(v))[0] * v

    worst = 0.0
    for u in radii:
        # v = u -+ z^3 weakens the logarithmic singularity at v = u
        reach = 1.5 if problem.outer is None else (problem.outer - u)**(1 / 3)
        whole = quad(lambda z: 3 * z**2 * integrand(u - z**3, u), 0.0, u**(1 / 3), **QUAD)[0]
        whole += quad(lambda z: 3 * z**2 * integrand(u + z**3, u), 0.0, reach, **QUAD)[0]
        if problem.outer is None:
            whole += quad(lambda z: integrand(1.0 / z, u) / z**2, 0.0, 1.0 / (u + reach**3),
                          **QUAD)[0]
        here = gap(u)[0] + state.approach - problem.profile.gap(u)
        worst = max(worst, abs(here - problem.elastic * whole))
    return worst


def kernel():
    """Pull-off at mu = 1, unbounded."""
    problem = smooth_sphere(1.0)
    mark = find_landmarks(problem, trace(problem))[-1]
    state = polish(problem, mark, POLISH[1]).state
    check("Eq 16 with the kernel of Eq 12 at the pull-off of mu = 1",
           equation_16(problem, state, (0.377, 1.213, 2.719)), KERNEL_TOLERANCE)


def cut():
    """Pull-off of a wavy sphere on a bounded surface so small that its size matters."""
    problem = CUT_SCENE.problem()
    states = trace(problem, TRACE, -8.0, np.inf, last_approach=CUT_SCENE.complete_to)
    marks = [mark for mark in find_landmarks(problem, states) if mark.kind == "minimum"]
    state = polish(problem, marks[-1], wavy_sphere.POLISH[1]).state
    check("wavy and cut: Eq 16 with the kernel of Eq 12 at the pull-off",
           equation_16(problem, state, (0.377, 2.719, 0.99 * problem.outer)), KERNEL_TOLERANCE)


def run():
    for test in (gaussian, power, hertz, reciprocity, bradley, contact, kernel, cut):
        test()
