"""Special points of a branch and points along it, converged on several levels, with the
differences between the levels."""

from dataclasses import dataclass

import numpy as np

from branch import APPROACH, FINE_TRACE, LOAD, POLISH, TRACE, NotConverged, advance, correct, remesh
from contact import contact_radius
from landmarks import converge, find_landmarks, landmark_kinds, polish, pull_off, trace
from tables import bound, number

SAFETY = 3.0              # stored uncertainty / observed difference between levels
CURVE_POINTS = 180
CURVE_CHECK = 10          # every CURVE_CHECK-th point is also solved on the third level

BOUND_IN_WORDS = (f"bound: {SAFETY:g} times the largest difference between refinement levels, "
                  "not below 1e-10")


@dataclass(frozen=True)
class Row:
    """A converged special point, with contact_radius in units of Gamma = epsilon sqrt(R mu).
    `spread`: differences between levels (D, W, contact radius)."""
    kind: str
    approach: float
    load: float
    contact_radius: float
    spread: np.ndarray


def solve_landmarks(problem, ends, levels=POLISH, check=True):
    """Converged special points in order along the branch. `ends`: arguments of trace.
    With `check` they are searched again on a second trace with another mesh and other steps."""
    marks = find_landmarks(problem, trace(problem, TRACE, **ends))
    if check:
        finer = find_landmarks(problem, trace(problem, FINE_TRACE, refine=2.0, **ends))
        if landmark_kinds(finer) != landmark_kinds(marks):
            raise NotConverged(f"elastic number {problem.elastic}: the finer trace has other landmarks")
        marks = finer
    return [converge_mark(problem, mark, levels) for mark in marks]


def converge_mark(problem, mark, levels):
    def values(level):
        state = polish(problem, mark, level).state
        return state.approach, state.load, contact_radius(problem, state)

    value, spread = converge(values, levels)
    return Row(mark.kind, *value, spread)


def curve_states(problem, states):
    """About CURVE_POINTS states from the first to the last. They are evenly spaced in a
    monitor function, half arclength and half change of direction in the (D, W) plane,
    so that bends have enough points."""
    y = np.array([s.y[:2] for s in states])
    slope = np.array([s.rate[:2] for s in states])
    turn = np.abs(np.diff(np.unwrap(np.arctan2(slope[:, 1], slope[:, 0]))))
    length = np.linalg.norm(np.diff(y, axis=0), axis=1)
    monitor = np.append(0.0, np.cumsum(length / length.sum() + turn / turn.sum()))
    for m in np.linspace(0.0, monitor[-1], CURVE_POINTS):
        i = min(np.searchsorted(monitor, m, "right") - 1, len(states) - 2)
        part = (m - monitor[i]) / (monitor[i + 1] - monitor[i])
        gone = part * (states[i].rate @ (states[i + 1].y - states[i].y))
        yield advance(problem, states[i], gone)


def solve_curve(problem, first, component, end, levels=POLISH):
    """Rows (approach, load, spread, checked on the third level) of a curve from
    approach `first` to where `component` (APPROACH or LOAD) first reaches `end`.
    Each point is the crossing of the curve with a line normal to it, the same
    line on every level: the spread is the distance normal to the curve."""
    limit = {APPROACH: "last_approach", LOAD: "last_load"}[component]
    states = trace(problem, TRACE, first, **{"last_load": np.inf, limit: end})
    last = states[-1]                                   # a little beyond the end
    states[-1] = correct(problem, last.surface, last.gap, last.approach,
                         np.eye(3)[component], end, last.rate)
    points = list(curve_states(problem, states))
    rows = []
    for i, state in enumerate(points):
        direction = state.rate * [1.0, 1.0, 0.0]
        direction /= np.linalg.norm(direction)
        target = direction @ state.y
        if i == 0:
            direction, target = np.eye(3)[APPROACH], first
        elif i == len(points) - 1:
            direction, target = np.eye(3)[component], end
        checked = i % CURVE_CHECK == 0
        value, spread = converge(
            lambda level: remesh(problem, state, level, direction, target).y[:2],
            levels if checked else levels[:2])
        rows.append((*value, np.linalg.norm(spread), checked))
    return rows


def worst(curves):
    """The largest spread of the points of all curves on two levels, and on three."""
    every = [row for rows in curves for row in rows]
    return max(r[2] for r in every if not r[3]), max(r[2] for r in every if r[3])


def landmark_cells(rows, width):
    """Index, kind, approach, load, contact radius and their uncertainties, as in the tables. `width`:
    the value of Gamma in the unit of the contact radius."""
    return [(str(i + 1), r.kind, number(r.approach), number(r.load), number(r.contact_radius * width),
             bound(SAFETY * r.spread[0]), bound(SAFETY * r.spread[1]),
             bound(SAFETY * r.spread[2] * width)) for i, r in enumerate(rows)]


def pull_off_cells(rows, width):
    """Force, approach, contact radius and their uncertainties."""
    r = pull_off(rows)
    return (number(-r.load), number(r.approach), number(r.contact_radius * width),
            bound(SAFETY * r.spread[1]), bound(SAFETY * r.spread[0]),
            bound(SAFETY * r.spread[2] * width))


def show(rows, width, unit):
    """Prints special points. `width`: as in landmark_cells."""
    for r in rows:
        print(f"{r.kind:9s} approach {r.approach: .13f} load {r.load: .13f} "
              f"contact radius {r.contact_radius * width:.12f} {unit} "
              f"differences {r.spread[0]:.1e} {r.spread[1]:.1e} {r.spread[2] * width:.1e}")


def _compare(where, value, stored, uncertainty):
    if not abs(value - float(stored)) <= float(uncertainty):
        raise ValueError(f"{where}: recomputed {number(value)}, stored {stored}, "
                         f"uncertainty {uncertainty}")


def compare(where, rows, landmarks, best, width, radius):
    """Raises an exception if recomputed special points are outside the stored uncertainty.
    Given: the rows of the table of special points, the row of the table of pull-off;
    `width`, as in landmark_cells; `radius`, the name of the column of contact radii."""
    if [r.kind for r in rows] != [s["kind"] for s in landmarks]:
        raise ValueError(f"{where}: other kinds of landmarks")
    for r, s in zip(rows, landmarks):
        at = f"{where} index {s['index']}"
        _compare(at, r.approach, s["approach"], s["approach_uncertainty"])
        _compare(at, r.load, s["load"], s["load_uncertainty"])
        _compare(at, r.contact_radius * width, s[radius], s[f"{radius}_uncertainty"])
    r = pull_off(rows)
    _compare(f"{where} pull-off", -r.load, best["force"], best["force_uncertainty"])
    _compare(f"{where} pull-off", r.approach, best["approach"], best["approach_uncertainty"])
    _compare(f"{where} pull-off", r.contact_radius * width, best[radius],
             best[f"{radius}_uncertainty"])
