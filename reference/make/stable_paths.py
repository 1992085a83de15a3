"""Follows stable equilibria at given approach, or at given load, to the point where they end, and
computes the jump from there by a relaxation of the surfaces in time.

Relaxation. A damping resists the change of the gap, so that the elastic surface carries the traction
q = P(H) - c dH/dt with a local weight c > 0, and H + D - f = elastic * deflection[q]. At given approach
D is constant. At given load the integral of q is the load, and D follows from it; through a spring of stiffness k
the base D + W/k is given. The rate of each of
D and -H(u) increases with all others (the flow is cooperative), for every c. So a perturbation of an
equilibrium to one side leads to the next equilibrium in this order, whatever c is.
"""

from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import brentq

from branch import (APPROACH, CLOSEST_GAP, LOAD, TRACE, Level, NotConverged, correct, make_surface,
                    remesh)
from landmarks import Landmark, between, find_landmarks, polish, walk

FAR = -15.0               # approach at which loading begins and unloading ends
APART = -60.0             # at given load: below this approach the surfaces are separated
BEYOND = 1e-3             # distance beyond a fold, in approach or load, at which there is no equilibrium near it
# Steps of the implicit Euler method. Only the state of rest matters.
FIRST_STEP, LAST_STEP = 1e-2, 1e6   # in time; the last one is Newton's method
GROWTH = 1.6              # of the step after a success; it is halved after a failure
FARTHEST = 0.2            # largest change of 1 + H in one step, relative: the relaxation must follow its path
RELAX_ROUNDS = 12         # Newton iterations in one step
RELAX_DONE = 1e-6         # last relative update of one step
MOST_STEPS = 3000
RELAX_LEVEL = Level(order=8, tail=12, tolerance=1e-8)
# Panels of the relaxation; gaps in eps. The contact edge passes over all panels whose undeformed gap is below
# WIDE_GAP. Beyond, their width grows with the gap, limited to a part of a wave where the gap is below FAR_GAP.
RELAX_WIDTH, WIDE_GAP, FAR_GAP, PART_OF_WAVE = 1.6, 12.0, 100.0, 0.25
PROBES = np.linspace(0.0, 1.0, 9)
DAMPED = 8.0              # in Gamma: at larger radii the damping decays like the traction
ALONG = np.eye(3)         # ALONG[APPROACH], ALONG[LOAD]: directions in Y with which approach or load is held


@dataclass(frozen=True)
class Leap:
    """A jump on the mesh of the walk: the fold at which it begins, and the state of rest (None: the surfaces part)."""
    loading: bool
    fold: Landmark
    rest: object


@dataclass(frozen=True)
class Piece:
    """Stable equilibria in order from one of them towards larger or smaller approach (or load): the
    extrema of the load on the way, the fold where they end (None: the requested end comes first), and
    the states, of which the last one is the fold or the end."""
    passed: list
    fold: Landmark
    states: list


def energy(problem, state):
    """The energy U/(pi w R eps) of interaction and elasticity. Its derivative with respect to the approach
    is the load."""
    surface = state.surface
    p = problem.traction(state.gap)
    return surface.load(problem.law.energy(state.gap) + 0.5 * p * problem.elastic * (surface.deflection @ p))


def turned(state, sense, component=APPROACH):
    """The state with its tangent towards larger (sense 1) or smaller approach, or load."""
    if state.rate[component] * sense >= 0:
        return state
    return replace(state, rate=-state.rate, gap_rate=-state.gap_rate)


def piece(problem, state, sense, end, component=APPROACH):
    """The equilibria from a stable one towards larger or smaller approach (or load), until the stable
    states end or `end` is reached. In load control an extremum of the load is the end of stable states."""
    states = [turned(state, sense, component)]
    for following in walk(problem, states[0], TRACE):
        states.append(following)
        if following.rate[component] * sense < 0 or (following.y[component] - end) * sense > 0:
            break
    marks = find_landmarks(problem, states)
    at = next((i for i, mark in enumerate(marks) if mark.component == component), len(marks))
    fold = marks[at] if at < len(marks) else None
    states[-1] = fold.state if fold else states[-1]
    if (states[-1].y[component] - end) * sense > 0:
        go, length = between(problem, *states[-2:])
        states[-1] = go(brentq(lambda d: go(d).y[component] - end, 0.0, length))
        marks = [mark for mark in marks[:at] if (mark.state.y[component] - end) * sense < 0]
        return Piece(marks, None, states)
    return Piece(marks[:at], fold, states)


def step_in_time(problem, surface, undeformed, held, before, approach, step):
    """The gap and the approach after one step of the implicit Euler method; None if Newton's method fails.
    `held`: the parts of the approach and of the load in what is held, and its value."""
    of_approach, of_load, value = held
    n, scale = surface.size, 1.0 / (1.0 + np.abs(before))
    operator = problem.elastic * surface.deflection
    damping = (1.0 + surface.q / DAMPED**2)**-3 / step
    gap = before.copy()
    matrix, residual = np.empty((n + 1, n + 1)), np.empty(n + 1)
    for _ in range(RELAX_ROUNDS):
        elastic = problem.traction(gap) - damping * (gap - before)
        slope = problem.slope(gap) - damping
        matrix[:n, :n] = -operator * slope[None, :]
        matrix[:n, :n].flat[::n + 1] += 1.0
        matrix[:n, n] = 1.0
        matrix[:n] *= scale[:, None]
        residual[:n] = (gap + approach - undeformed - operator @ elastic) * scale
        matrix[n, :n], matrix[n, n] = of_load * surface.weights * slope, of_approach
        residual[n] = of_approach * approach + of_load * surface.load(elastic) - value
        update = np.linalg.solve(matrix, -residual)
        if not np.isfinite(update).all() or np.max(-update[:n] / problem.law.room(gap)) > CLOSEST_GAP:
            return None
        gap += update[:n]
        approach += update[n]
        if np.max(np.abs(update[:n]) * scale) < RELAX_DONE:
            return gap, approach
    return None


def relaxation_surface(scene, approach, level):
    """Panels that are narrow wherever the contact edge may be."""
    problem, length = scene.problem(), float(scene.wavelength) / scene.width

    def wide(low, high):
        gap = max(0.0, problem.profile.gap(low + PROBES * (high - low)).min() - approach)
        limit = RELAX_WIDTH / scene.width * max(1.0, gap / WIDE_GAP)
        return high - low > (min(limit, PART_OF_WAVE * length) if gap < FAR_GAP else limit)

    return make_surface(problem, level, wide)


def come_to_rest(problem, surface, held, gap, approach, step=FIRST_STEP):
    """The gap and the approach at rest; None if the surfaces separate. Given: the first step in time."""
    undeformed = problem.profile.gap(surface.u)
    for _ in range(MOST_STEPS):
        found = step_in_time(problem, surface, undeformed, held, gap, approach, step)
        if found is None or np.max(np.abs(found[0] - gap) / (1.0 + np.abs(gap))) > FARTHEST:
            step *= 0.5
            continue
        gap, approach = found
        if approach < APART:
            return None
        if step > LAST_STEP:
            return found
        step *= GROWTH
    raise NotConverged(f"no rest where {held[0]} approach + {held[1]} load is {held[2]}")


def relax(scene, left, component, value, target):
    """Relaxes the surfaces from a state with the approach, or the load, held at `value`. Returns the
    equilibrium at `target` near the state of rest; None if the surfaces separate."""
    problem, surface = scene.problem(), left.surface
    gap, approach = left.gap, left.approach
    for level in RELAX_LEVEL, TRACE:        # the second level starts from the state of rest on the first
        finer = relaxation_surface(scene, left.approach, level)
        elastic = surface.interpolate(gap + approach - problem.profile.gap(surface.u), finer.u, 1)
        surface, approach = finer, value if component == APPROACH else approach
        found = come_to_rest(problem, surface, (*ALONG[component][:2], value),
                             elastic - approach + problem.profile.gap(surface.u), approach)
        if found is None:
            return None
        gap, approach = found
    if component == APPROACH:
        gap, approach = gap + value - target, target
    rest = correct(problem, surface, gap, approach, ALONG[component], target)
    return remesh(problem, rest, TRACE, ALONG[component], target)


def leap(scene, fold, loading, component=APPROACH):
    """The jump from a fold that is exceeded by BEYOND."""
    value = fold.state.y[component]
    past = value + (BEYOND if loading else -BEYOND)
    return Leap(loading, fold, relax(scene, fold.state, component, past, value))


def leap_on_level(problem, jump, level):
    """The approach, the load before and after, and the energy lost of a jump at given approach."""
    fold = polish(problem, jump.fold, level).state
    rest = remesh(problem, jump.rest, level, ALONG[APPROACH], fold.approach)
    return fold.approach, fold.load, rest.load, energy(problem, fold) - energy(problem, rest)
