"""Equilibrium branch of an adhesive axisymmetric contact (Eqs 10-17).

The unknowns are the gap H(u) and the approach D, with

    F = H + D - f(u) - elastic * deflection[P(H)] = 0                  (Eq 16)
    W = 2 int P u du                                                   (Eq 15)

with the profile f, the law P and one elastic number. For the smooth sphere of the paper the unit of
radii is Gamma = sqrt(R mu epsilon), f = mu u^2/2, elastic = mu and P is mu times the law (Eq 9).

The branch is followed by arclength in the three numbers Y = (D, W, H(0)). They do
not depend on the mesh, so a state can be transferred to another mesh at any point.
The tangent (dD, dW, dH0)/ds has unit length; dD/ds = 0 is a fold (jump under
displacement control), dW/ds = 0 an extremum of the load.
"""

from dataclasses import dataclass

import numpy as np

from copson import Surface, dyadic_edges, legendre_transform
from laws import Mie
from profiles import Sphere

APPROACH, LOAD, CENTRE = 0, 1, 2        # components of Y

NEWTON_ROUNDS = 12
NEWTON_DONE = 1e-9      # last relative update; the remaining error is its square
EDGE_LEVEL = 8          # least number of halvings towards the edge of a bounded surface; the load at
                        # mu = 3, A = 1, L = 1.15, outer 5.8 is the same to 1e-14 with 4 and with 22
CLOSEST_GAP = 0.5       # one update may at most halve the distance to the singularity of the law
                        # (Lennard-Jones: 1 + H)


class NotConverged(Exception):
    """Newton's method failed. The caller shortens its step."""


@dataclass(frozen=True)
class Problem:
    """A contact problem: the law and the profile in the units of the solver, the elastic number, the radius `outer` of
    the surface (None = unbounded), the least start of the mapped panel of an unbounded surface, and the least number of
    halvings of the panels towards the edge `outer`."""
    law: object
    profile: object
    elastic: float
    outer: float = None
    core: float = 10.0
    edge_level: int = EDGE_LEVEL

    def traction(self, gap):
        return self.law.traction(gap)

    def slope(self, gap):
        """dP/dH."""
        return self.law.slope(gap)

    @property
    def decay(self):
        """The decay of the traction on an unbounded surface, and the root of the mapped panel (copson.py)."""
        decay = self.law.decay * self.profile.growth
        root = next((k for k in (1, 2) if (k * decay) % 1.0 == 0.0 and (k * self.profile.growth) % 1.0 == 0.0), None)
        if decay <= 2.0:
            raise ValueError(f"traction r^-{decay:g} far out: the load of an unbounded surface is not finite")
        if root is None:
            raise ValueError(f"traction r^-{decay:g}, gap r^{self.profile.growth:g} far out: the mapped panel takes "
                             "multiples of 1/2; give an outer radius")
        return decay, root


def smooth_sphere(tabor, outer=None):
    """A smooth sphere (A = 0, parabola mu u^2/2), by default on the unbounded half-space."""
    # the mapped panel starts well outside both the range of the attraction, sqrt(2/mu), and any contact area met
    # here (u < 3)
    return Problem(Mie(3.0, 9.0, tabor), Sphere(tabor), tabor, outer, max(6.0 * np.sqrt(2.0 / tabor), 10.0))


@dataclass(frozen=True)
class Level:
    """A refinement level: nodes of a panel, nodes of the mapped panel, tolerance
    on the unresolved traction, start of the mapped panel (relative), additional
    quadrature points, halvings of the panels towards a kink of the profile."""
    order: int
    tail: int
    tolerance: float
    cut: float = 1.0
    extra: int = 0
    kink: int = 12

    def cut_radius(self, problem):
        """Start of the mapped panel."""
        return self.cut * problem.core

    def warp(self, x):
        """Maps dyadic panel edges on [0, 1] to those of a bounded surface, so that
        the meshes of two levels have only the ends in common."""
        return x / (x + self.cut * (1.0 - x))


# The order of the mapped panel and its start differ, too, so that the comparison of levels tests every part.
TRACE = Level(order=14, tail=16, tolerance=1e-8)
FINE_TRACE = Level(order=16, tail=18, tolerance=1e-9)
POLISH = (Level(order=14, tail=18, tolerance=1e-10),
          Level(order=18, tail=22, tolerance=1e-12, cut=1.21),
          Level(order=22, tail=28, tolerance=1e-13, cut=1.37, extra=8))

LEAST_LEVEL = 3         # coarsest panels: 1/8 of the finite part
MOST_LEVEL = 22
REMESH_FACTOR = 100.0   # during a trace a new mesh is made at this multiple of the tolerance
MESH_ROUNDS = 8


@dataclass
class State:
    """A converged equilibrium with its unit tangent."""
    surface: Surface
    gap: np.ndarray
    approach: float
    load: float
    centre: float
    gap_rate: np.ndarray = None
    rate: np.ndarray = None             # d(D, W, H0)/ds

    @property
    def y(self):
        return np.array([self.approach, self.load, self.centre])


def make_surface(problem, level, unresolved, least=LEAST_LEVEL):
    """Adaptive panels with a mapped panel to infinity, or on a bounded surface
    panels graded towards its edge, where the traction jumps to zero. Both are graded towards the kinks of the
    profile."""
    end = level.cut_radius(problem) if problem.outer is None else problem.outer
    kinks = [r for r in problem.profile.kinks if r < end]
    ends = sorted({0.0, *kinks, end})
    depth = int(np.ceil(level.kink * problem.profile.grading))
    parts = []
    for first, last in zip(ends, ends[1:]):
        # the start of the mapped panel depends on the level already
        warp = level.warp if last < end or problem.outer is not None else lambda x: x

        def coarse(low, high):
            if low == 0.0 and first in kinks:
                return high > 0.5**depth
            if high == 1.0 and last in kinks:
                return low < 1.0 - 0.5**depth
            at_edge = high == 1.0 and last == problem.outer
            return unresolved(first + (last - first) * warp(low), first + (last - first) * warp(high)) or (
                at_edge and low < 1.0 - 0.5**problem.edge_level)

        edges = first + (last - first) * warp(dyadic_edges(1.0, coarse, least, MOST_LEVEL))
        edges[-1] = last
        parts.append(edges[1:] if parts else edges)
    edges = np.concatenate(parts)
    exempt = np.isin(edges[:-1], kinks) | np.isin(edges[1:], kinks)
    if problem.outer is not None:
        return Surface(edges, level.order, 0, level.extra, exempt=exempt)
    return Surface(edges, level.order, level.tail, level.extra, *problem.decay, exempt)


def correct(problem, surface, gap, approach, direction, target, previous=None):
    """Newton's method for F = 0 together with direction . Y = target.

    Returns the State. Its tangent has the sense of `previous` (a rate), or of
    `direction` if that is None."""
    undeformed = problem.profile.gap(surface.u)
    operator = problem.elastic * surface.deflection
    n = surface.size
    gap = gap.copy()
    matrix = np.empty((n + 1, n + 1))
    rhs = np.zeros((n + 1, 2))
    rhs[n, 1] = 1.0
    done = False
    for _ in range(NEWTON_ROUNDS):
        p, slope = problem.traction(gap), problem.slope(gap)
        y = np.array([approach, surface.load(p), surface.centre @ gap[:surface.order]])
        # rows are scaled by 1/(1+|H|), because the far gap is large and does not matter
        scale = 1.0 / (1.0 + np.abs(gap))
        matrix[:n, :n] = -operator * slope[None, :]
        matrix[:n, :n].flat[::n + 1] += 1.0
        matrix[:n, n] = 1.0
        matrix[:n] *= scale[:, None]
        matrix[n, :n] = direction[LOAD] * surface.weights * slope
        matrix[n, :surface.order] += direction[CENTRE] * surface.centre
        matrix[n, n] = direction[APPROACH]
        rhs[:n, 0] = -(gap + approach - undeformed - operator @ p) * scale
        rhs[n, 0] = target - direction @ y
        solution = np.linalg.solve(matrix, rhs)
        if done:
            break
        step = solution[:, 0]
        if not np.isfinite(step).all():
            raise NotConverged
        shrink = np.max(-step[:n] / problem.law.room(gap))
        damping = min(1.0, CLOSEST_GAP / shrink) if shrink > 0 else 1.0
        gap += damping * step[:n]
        approach += damping * step[n]
        size = max(np.max(np.abs(step[:n]) * scale), abs(step[n]))
        done = damping == 1.0 and size < NEWTON_DONE
    else:
        raise NotConverged
    rate = solution[:, 1]
    y_rate = np.array([rate[n], surface.weights @ (slope * rate[:n]),
                       surface.centre @ rate[:surface.order]])
    sense = y_rate @ (direction if previous is None else previous)
    norm = np.copysign(np.linalg.norm(y_rate), sense)
    return State(surface, gap, approach, y[LOAD], y[CENTRE], rate[:n] / norm, y_rate / norm)


def advance(problem, state, distance):
    """The equilibrium at `distance` from a state, measured along its tangent."""
    return correct(problem, state.surface, state.gap + distance * state.gap_rate,
                   state.approach + distance * state.rate[APPROACH],
                   state.rate, state.rate @ state.y + distance)


def unresolved(problem, state):
    """For each panel the unresolved part of the traction and of its rate of change."""
    surface = state.surface
    return np.maximum(surface.roughness(problem.traction(state.gap)),
                      surface.roughness(problem.slope(state.gap) * state.gap_rate))


def remesh(problem, state, level, direction=None, target=None):
    """Transfers `state` to a mesh of `level` that is adapted to it, and solves again with
    direction . Y = target (by default the rate and Y of the state). This is repeated
    until the mesh needs no further refinement."""
    if direction is None:
        direction, target = state.rate, state.rate @ state.y
    probe, _, to_legendre = legendre_transform(level.order)
    for _ in range(MESH_ROUNDS):
        old = state.surface
        p = problem.traction(state.gap)
        p_rate = problem.slope(state.gap) * state.gap_rate
        sizes = np.abs(p).max(), np.abs(p_rate).max()
        old_width = np.append(np.diff(old.edges), np.inf)
        refine = np.append(unresolved(problem, state) > level.tolerance, False)

        def rough(low, high):
            # the old interpolant has no information on scales below its own panels:
            # cut those at most once, and only if they are unresolved
            inside = np.arange(np.searchsorted(old.edges, low * (1 + 1e-12), "right") - 1,
                               np.searchsorted(old.edges, high * (1 - 1e-12), "left"))
            inside = inside[inside <= old.panels]
            if len(inside) == 0 or high - low <= 0.51 * old_width[inside].min():
                return False
            if len(inside) == 1 and high - low <= 1.01 * old_width[inside[0]]:
                return bool(refine[inside[0]])
            u = np.sqrt(low**2 + 0.5 * (probe + 1.0) * (high**2 - low**2))
            return any(np.abs(to_legendre[-2:] @ old.interpolate(f, u, old.decay)).max()
                       > level.tolerance * size for f, size in zip((p, p_rate), sizes))

        surface = make_surface(problem, level, rough)
        same = (len(surface.edges) == len(old.edges) and surface.order == old.order
                and surface.tail == old.tail and np.allclose(surface.edges, old.edges))
        if same:
            return state
        # the elastic part of the gap is smooth everywhere: interpolate that
        elastic = state.gap + state.approach - problem.profile.gap(old.u)
        gap = (old.interpolate(elastic, surface.u, 1) - state.approach
               + problem.profile.gap(surface.u))
        state = correct(problem, surface, gap, state.approach, direction, target, state.rate)
    return state


def start(problem, approach, level):
    """The nearly undeformed state at a far approach, which is held fixed."""
    surface = make_surface(problem, level, lambda low, high: False, least=5)
    state = correct(problem, surface, problem.profile.gap(surface.u) - approach, approach,
                    np.array([1.0, 0.0, 0.0]), approach)
    return remesh(problem, state, level)
