"""Follows a branch, and finds the special points on it: folds and extrema of the load."""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq, minimize_scalar, newton

from branch import (APPROACH, LOAD, POLISH, REMESH_FACTOR, TRACE, NotConverged, advance,
                    correct, remesh, start, unresolved)

# Step control of the trace: the tangent in (D, W, H0) turns by about TURN per step.
TURN = 0.12
LONGEST_STEP = 0.25
SHORTEST_STEP = 1e-7
GROWTH = 1.25             # largest factor of the step after a success
MOST_STEPS = 5000

LOCATE_TOLERANCE = 1e-9   # of a special point on the mesh of the trace, from which polishing starts
POLISH_PASSES = 2         # the point may move a little, so the mesh is adapted to it again
FIRST_SECANT = 1e-5, 1e-7  # second point of the secant method, in arclength; the second value is used
                          # if the branch turns back sharply within the first
SECANT_ROUNDS = 12
SECANT_DONE = 1e-12       # last change in arclength


@dataclass(frozen=True)
class Landmark:
    component: int          # APPROACH: fold, LOAD: extremum of the load
    sense: int              # +1: the rate of the component changes from < 0 to > 0 (a minimum)
    state: object

    @property
    def kind(self):
        return {(APPROACH, -1): "jump_in", (APPROACH, 1): "jump_out",
                (LOAD, 1): "minimum", (LOAD, -1): "maximum"}[self.component, self.sense]


def walk(problem, state, level=TRACE, refine=1.0):
    """The states along the branch after `state`, in the direction of its tangent.
    refine > 1 shortens the steps."""
    turn, longest, step = TURN / refine, LONGEST_STEP / refine, 0.1
    for _ in range(MOST_STEPS):
        if unresolved(problem, state).max() > REMESH_FACTOR * level.tolerance:
            state = remesh(problem, state, level)
        try:
            following = advance(problem, state, step)
            angle = np.arccos(min(1.0, following.rate @ state.rate))
        except NotConverged:
            angle = np.inf
        if angle > 2.0 * turn:
            step *= 0.5
            if step < SHORTEST_STEP:
                raise NotConverged(f"elastic number {problem.elastic}: trace stuck at Y = {state.y}")
            continue
        state = following
        yield state
        step = min(longest, step * min(GROWTH, turn / max(angle, 1e-3)))
    raise NotConverged(f"elastic number {problem.elastic}: too many steps")


def trace(problem, level=TRACE, first_approach=-12.0, last_load=1.0, refine=1.0,
          last_approach=np.inf):
    """The states along the branch from `first_approach` until the load exceeds last_load or
    the approach exceeds last_approach. `refine`: as in walk."""
    states = [start(problem, first_approach, level)]
    for state in walk(problem, states[0], level, refine):
        states.append(state)
        if state.load > last_load or state.approach > last_approach:
            break
    return states


def between(problem, *states):
    """A function distance -> state, and the distance to the last of `states`. Distances are along
    the tangent of the first of them, and the nearest one is the initial guess."""
    direction = states[0].rate
    places = np.array([direction @ (s.y - states[0].y) for s in states])

    def go(distance):
        i = np.argmin(np.abs(places - distance))
        near, step = states[i], (distance - places[i]) / (direction @ states[i].rate)
        return correct(problem, near.surface, near.gap + step * near.gap_rate,
                       near.approach + step * near.rate[APPROACH],
                       direction, direction @ states[0].y + distance, near.rate)

    return go, places[-1]


def insert_near_misses(problem, states):
    """Adds states where |dD/ds| or |dW/ds| has a minimum between points without a change of sign,
    so that two special points close together are not missed."""
    out = list(states)
    for component in (APPROACH, LOAD):
        i = 1
        while i < len(out) - 1:
            f = [s.rate[component] for s in out[i - 1:i + 2]]
            if f[0] * f[1] > 0 and f[1] * f[2] > 0 and abs(f[1]) < min(abs(f[0]), abs(f[2])):
                sign = np.sign(f[1])
                go, length = between(problem, *out[i - 1:i + 2])
                found = minimize_scalar(lambda d: sign * go(d).rate[component],
                                        bounds=(0.0, length), method="bounded",
                                        options={"xatol": 1e-6 * length})
                if found.fun < 0:
                    new = go(found.x)
                    at = i if out[i - 1].rate @ (new.y - out[i].y) < 0 else i + 1
                    out.insert(at, new)
                    i += 1
            i += 1
    return out


def find_landmarks(problem, states):
    """All folds and extrema of the load along a trace, in order."""
    states = insert_near_misses(problem, states)
    marks = []
    for a, b in zip(states, states[1:]):
        here = []
        for component in (APPROACH, LOAD):
            if a.rate[component] * b.rate[component] < 0:
                go, length = between(problem, a, b)
                d = brentq(lambda d: go(d).rate[component], 0.0, length, xtol=LOCATE_TOLERANCE)
                here.append((d, Landmark(component, int(np.sign(b.rate[component])), go(d))))
        marks += [mark for _, mark in sorted(here, key=lambda pair: pair[0])]
    return marks


def polish(problem, mark, level):
    """The special point, converged on a mesh of `level`."""
    state, f = mark.state, mark.component
    for _ in range(POLISH_PASSES):
        state = remesh(problem, state, level)
        state = advance(problem, state, root_of_rate(problem, state, f))
    return Landmark(f, mark.sense, state)


def root_of_rate(problem, state, component):
    """The distance from a state to the special point near it."""
    for first in FIRST_SECANT:
        try:
            return newton(lambda d: advance(problem, state, d).rate[component], 0.0, x1=first,
                          tol=SECANT_DONE, maxiter=SECANT_ROUNDS, disp=False)
        except NotConverged:
            continue
    raise NotConverged(f"no landmark close to Y = {state.y}")


def converge(solve, levels=POLISH):
    """Solves on every level. Returns the values of the finest level and the
    largest difference of the other levels from it."""
    values = np.array([solve(level) for level in levels])
    return values[-1], np.abs(values - values[-1]).max(axis=0)


def landmark_kinds(marks):
    return [mark.kind for mark in marks]


def pull_off(rows):
    """The row of the global minimum of the load. Rows have the attributes kind and load."""
    return min((r for r in rows if r.kind == "minimum"), key=lambda r: r.load)
