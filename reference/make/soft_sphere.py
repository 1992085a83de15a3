#!/usr/bin/env python3
"""Pull-off of smooth spheres with large Tabor parameters, by continuation in the parameter.

The equations and panels are those of smooth_sphere.py. A trace from bodies far apart would pass through a spiral of many
folds, so equilibria are prescribed here by the contact radius a, the radius at which the gap is that of the greatest
tension, and followed from mu = FIRST. Near a the gap depends on (u - a) mu^2 alone, elsewhere the tractions hardly change:
both give the guess for the next mu. The pull-off is the minimum of a polynomial in a through some equilibria.

    soft_sphere.py 1000                 load, approach and contact radius over Gamma at pull-off, on each level
"""

import sys
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import Polynomial

import branch
from branch import CLOSEST_GAP, NEWTON_DONE, TRACE, Level, NotConverged, make_surface, smooth_sphere
from contact import contact_radius
from landmarks import find_landmarks, trace

FIRST, RATIO = 3.0, 1.6   # first Tabor parameter; ratio of neighbours, at most
JKR = np.cbrt(9.0 * np.pi / 8.0)  # contact radius over Gamma at pull-off in the limit of large mu
SPAN, NODES = 0.02, 6     # of the polynomials in the contact radius
FINEST = 44               # halvings of the panels: the edge is mu^-2 wide in units of Gamma
INNER = 0.3               # distance from the edge, in units of Gamma at the smaller mu, within which the gap scales with mu^2
PART, WIDTHS = 0.4, 1.0   # panels are at most this part of their distance from the edge, or these widths of the edge, long
ROUNDS = 40               # of Newton's method
COARSE = Level(order=12, tail=16, tolerance=0.0)
LEVELS = Level(order=14, tail=18, tolerance=0.0), Level(order=17, tail=22, tolerance=0.0, cut=1.15, extra=6)


@dataclass
class Contact:
    """An equilibrium with a given contact radius."""
    surface: object
    gap: np.ndarray
    approach: float
    load: float
    radius: float


def graded(problem, level, radius, tabor):
    """Panels graded towards the edge of the contact."""
    least, part = WIDTHS * tabor**-2 / level.cut, PART / level.cut

    def wide(low, high):
        return high - low > max(least, part * max(0.0, low - radius, radius - high))

    return make_surface(problem, level, wide)


def guess(old, profile, radius, ratio, surface):
    """The gap at a Tabor parameter that is greater by a ratio, with another contact radius."""
    away = surface.u - radius
    inner = np.abs(away) * ratio**2 < INNER
    at = np.where(inner, old.radius + away * ratio**2, surface.u)
    elastic = old.gap + old.approach - profile.gap(old.surface.u)
    gap = old.surface.interpolate(elastic, at, 1) - old.approach + profile.gap(at)
    return np.where(inner, gap, np.where(gap > 0, gap * ratio, gap / ratio))


def solve(problem, surface, gap, approach, radius):
    """Newton's method for Eq 16 with H(radius) = that of the greatest tension."""
    undeformed, operator, n = problem.profile.gap(surface.u), problem.elastic * surface.deflection, surface.size
    k = int(np.searchsorted(surface.edges, radius, "right")) - 1
    row = np.zeros(n)
    row[surface.columns(k)] = surface._panel_rows(k, np.array([[radius**2]]), np.ones((1, 1)))[0]
    gap = gap.copy()
    matrix, rhs = np.empty((n + 1, n + 1)), np.zeros(n + 1)
    done = False
    for _ in range(ROUNDS):
        p, slope = problem.traction(gap), problem.slope(gap)
        scale = 1.0 / (1.0 + np.abs(gap))
        matrix[:n, :n] = -operator * slope
        matrix[:n, :n].flat[::n + 1] += 1.0
        matrix[:n, n] = 1.0
        matrix[:n] *= scale[:, None]
        matrix[n, :n], matrix[n, n] = row, 0.0
        rhs[:n] = -(gap + approach - undeformed - operator @ p) * scale
        rhs[n] = problem.law.peak_gap - row @ gap
        step = np.linalg.solve(matrix, rhs)
        if done:
            return Contact(surface, gap, approach, surface.load(p), radius)
        shrink = np.max(-step[:n] / problem.law.room(gap))
        damping = min(1.0, CLOSEST_GAP / shrink) if shrink > 0 else 1.0
        gap += damping * step[:n]
        approach += damping * step[n]
        done = damping == 1.0 and np.max(np.abs(step[:n]) * scale) < NEWTON_DONE
    raise NotConverged(f"contact radius {radius}: Newton's method failed")


def first_state():
    """The pull-off at mu = FIRST on a trace."""
    problem = smooth_sphere(FIRST)
    marks = find_landmarks(problem, trace(problem, TRACE, -12.0, 1.0))
    state = min((m for m in marks if m.kind == "minimum"), key=lambda m: m.state.load).state
    return Contact(state.surface, state.gap, state.approach, state.load, contact_radius(problem, state))


def at_radius(tabor, radius, level, old, before):
    """The equilibrium with a contact radius, from one at the Tabor parameter `before`."""
    problem, ratio = smooth_sphere(tabor), tabor / before
    surface = graded(problem, level, radius, tabor)
    gap = guess(old, smooth_sphere(before).profile, radius, ratio, surface)
    return solve(problem, surface, gap, old.approach * ratio, radius)


def follow(last, note=lambda line: None):
    """The equilibrium with the contact radius of JKR at the Tabor parameter `last`."""
    branch.MOST_LEVEL = FINEST
    steps = int(np.ceil(np.log(last / FIRST) / np.log(RATIO)))
    tabors = FIRST * (last / FIRST)**(np.arange(steps + 1) / max(steps, 1))
    state = first_state()
    for before, tabor in zip(tabors, tabors[1:]):
        state = at_radius(tabor, JKR, COARSE, state, before)
        note(f"tabor {tabor:.6g}: {state.surface.size} nodes, load {state.load:.10f}, approach {state.approach:.6f}")
    return state


def lowest(tabor, state, level):
    """Load, approach and contact radius where the load is lowest: of the polynomials in the contact radius through states
    at Chebyshev nodes. Returns the last state, too."""
    away = SPAN * np.cos(np.pi * (np.arange(NODES) + 0.5) / NODES)
    loads, approaches = [], []
    for distance in away:
        state = at_radius(tabor, JKR + distance, level, state, tabor)
        loads.append(state.load)
        approaches.append(state.approach)
    load, approach = (Polynomial.fit(away, values, NODES - 1, [-SPAN, SPAN]) for values in (loads, approaches))
    at = next(x.real for x in load.deriv().roots() if abs(x.imag) < 1e-9 and abs(x) < SPAN)
    return (load(at), approach(at), JKR + at), state


def main():
    tabor = float(sys.argv[1])
    state = follow(tabor, lambda line: print(line, flush=True))
    for level in LEVELS:
        (load, approach, radius), state = lowest(tabor, state, level)
        print(f"{state.surface.size} nodes: load {load:.13f} approach {approach:.9f} radius {radius:.9f}", flush=True)


if __name__ == "__main__":
    main()
