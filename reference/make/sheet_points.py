"""Special points of the adhesion sheet that no table has, by Copson panels: where the branch of a smooth sphere begins to
be S-shaped, and the jumps through a spring.

Each function takes the parameters of a problem (texts) and levels of refinement, and returns {quantity: (value, bound)}; the
bound is three times the change by the last level, infinite with one level.
"""

import numpy as np
from numpy.polynomial import Chebyshev
from scipy.optimize import newton

from branch import APPROACH, CENTRE, LOAD, TRACE, Level, advance, correct, remesh, smooth_sphere
from converged import SAFETY
from landmarks import between, trace
from tables import STORED_FLOOR

LEVELS = (Level(order=14, tail=18, tolerance=1e-10), Level(order=18, tail=22, tolerance=1e-12, cut=1.21, extra=4))
NEAR_S = 0.6971            # Tabor parameter of a trace without folds, just before the branch becomes S-shaped
SPAN, NODES = 0.03, 13     # of the polynomial of dD/dH(0) in H(0)


def by_levels(names, solve, levels):
    """{quantity: (value, bound)} from a function level -> values."""
    values = np.array([solve(level) for level in levels or LEVELS])
    spread = SAFETY * np.abs(values - values[-1]).max(axis=0) if len(values) > 1 else np.full(len(names), np.inf)
    return dict(zip(names, zip(values[-1], np.maximum(spread, STORED_FLOOR * 0.01))))


# ------------------------------------------------------------------------------------- the S begins

def s_begins(_, levels=None):
    """dD/dH(0) has a double zero along the branch: its minimum over H(0) is zero."""
    states = trace(smooth_sphere(NEAR_S), TRACE)
    near = min((s for s in states if s.rate[APPROACH] / s.rate[CENTRE] < 0.0),
               key=lambda s: abs(s.rate[APPROACH] / s.rate[CENTRE]))
    return by_levels(("tabor", "approach", "load"), lambda level: s_begins_on(near, level), levels)


def s_begins_on(near, level):
    direction = np.eye(3)[CENTRE]
    state = remesh(smooth_sphere(NEAR_S), near, level, direction, near.centre)
    centre = state.centre
    found = None

    def flattest(tabor):
        """The greatest dD/dH(0), which is negative before the S begins; sets `found` to D and W there."""
        nonlocal state, centre, found
        problem = smooth_sphere(tabor)
        nodes = centre + SPAN * np.cos(np.pi * (np.arange(NODES) + 0.5) / NODES)
        values = []
        for node in nodes:
            state = correct(problem, state.surface, state.gap, state.approach, direction, node)
            values.append((state.rate[APPROACH] / state.rate[CENTRE], state.approach, state.load))
        slope, approach, load = (Chebyshev.fit(nodes, y, NODES - 1, [centre - SPAN, centre + SPAN])
                                 for y in np.array(values).T)
        centre = min((x.real for x in slope.deriv().roots() if abs(x.imag) < 1e-9), key=lambda x: abs(x - centre))
        found = approach(centre), load(centre)
        return slope(centre)

    tabor = newton(flattest, NEAR_S, x1=NEAR_S + 2e-4, tol=1e-13, rtol=0.0, maxiter=12)
    flattest(tabor)
    return tabor, *found


# --------------------------------------------------------------------------- jumps through a spring

def spring(p, levels=None):
    """Extrema of the base D + W/k of a spring of stiffness k along the branch."""
    width = np.sqrt(float(p["R"]) * float(p["tabor"]))
    problem, stiffness = smooth_sphere(float(p["tabor"]), float(p["outer_radius"]) / width), float(p["stiffness"])

    def rate(state):
        return state.rate[APPROACH] + state.rate[LOAD] / stiffness

    states = trace(problem, TRACE)
    marks = [between(problem, a, b) for a, b in zip(states, states[1:]) if rate(a) * rate(b) < 0.0]
    marks = [go(0.5 * length) for go, length in marks]

    def base(mark, level):
        state = remesh(problem, mark, level)
        for _ in range(2):
            state = advance(problem, state, newton(lambda d: rate(advance(problem, state, d)), 0.0, x1=1e-4, tol=1e-12))
            state = remesh(problem, state, level)
        return state.approach + state.load / stiffness

    return by_levels(("jump_in_base", "jump_out_base"), lambda level: [base(mark, level) for mark in marks], levels)
