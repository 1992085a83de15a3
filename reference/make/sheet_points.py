"""Special points of the adhesion sheet that no table has, by Copson panels: where the branch of a smooth sphere begins to
be S-shaped, the jumps through a spring, the pull-off of very soft spheres, and an isolated branch.

Each function takes the parameters of a problem (texts) and levels of refinement, and returns {quantity: (value, bound)}; the
bound is three times the change by the last level, infinite with one level.
"""

import numpy as np
from numpy.polynomial import Chebyshev
from scipy.optimize import newton

import soft_sphere
import wavy_sphere
from branch import APPROACH, CENTRE, LOAD, TRACE, Level, NotConverged, advance, correct, remesh, smooth_sphere, start
from converged import SAFETY
from landmarks import between, find_landmarks, polish, trace, walk
from stable_paths import turned
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


# ------------------------------------------------------------------------------- very soft spheres

def soft(p, levels=None):
    """Pull-off, by continuation in the Tabor parameter."""
    tabor, width = float(p["tabor"]), np.sqrt(float(p["R"]) * float(p["tabor"]))
    state, values = soft_sphere.follow(tabor), []
    for level in levels or soft_sphere.LEVELS:
        (load, approach, radius), state = soft_sphere.lowest(tabor, state, level)
        values.append((-load, approach, radius * width))
    spread = SAFETY * np.abs(np.subtract(*values))
    return dict(zip(("pull_off_force", "pull_off_approach", "pull_off_radius"), zip(values[-1], spread)))


# ----------------------------------------------------------------------------- an isolated branch

AT, BEFORE, STEPS = -2.4, 2.25, 13     # the approach that is held; amplitude of the connected branch; steps of the amplitude
FOLD = 8                   # the stretch of stable equilibria begins at this fold of the connected branch
WAVY_LEVELS = wavy_sphere.POLISH[:2]


def wavy(p, amplitude):
    return wavy_sphere.Scene(p["tabor"], repr(amplitude), p["wavelength"], p["R"], p["outer_radius"], 0.0, 0.0).problem()


def isolated(p, levels=None):
    """The folds that end a stretch of stable equilibria which the branch from far apart does not contain. At the amplitude
    BEFORE it does; from there the amplitude is changed at a given approach."""
    amplitudes = np.linspace(BEFORE, float(p["A"]), STEPS + 1)
    problem, held = wavy(p, BEFORE), np.eye(3)[APPROACH]
    state = on_stretch(problem)
    state = correct(problem, state.surface, state.gap, AT, held, AT)
    for amplitude in amplitudes[1:]:
        following = wavy(p, float(amplitude))
        gap = state.gap + following.profile.gap(state.surface.u) - problem.profile.gap(state.surface.u)
        problem = following
        state = remesh(problem, correct(problem, state.surface, gap, AT, held, AT), TRACE, held, AT)
    marks = [first_fold(problem, turned(state, sense)) for sense in (1, -1)]

    def folds(level):
        states = [polish(problem, mark, level).state for mark in marks]
        return [x for state in states for x in (state.approach, state.load)]

    return by_levels("jump_in_approach jump_in_load jump_out_approach jump_out_load".split(), folds, levels or WAVY_LEVELS)


def on_stretch(problem):
    """The state nearest to the approach AT beyond the fold FOLD of the branch from far apart."""
    before, folds = start(problem, wavy_sphere.FAR, TRACE), 0
    for state in walk(problem, before, TRACE):
        folds += state.rate[APPROACH] * before.rate[APPROACH] < 0.0
        before = state
        if folds == FOLD and state.approach > AT - 0.05:
            return state
    raise NotConverged("no stretch of stable equilibria")


def first_fold(problem, state):
    """The fold at which the equilibria in the direction of the tangent end."""
    states = [state]
    for following in walk(problem, state, TRACE):
        states.append(following)
        if following.rate[APPROACH] * state.rate[APPROACH] < 0.0:
            break
    return next(mark for mark in find_landmarks(problem, states) if mark.component == APPROACH)
