#!/usr/bin/env python3
"""Feng's problem: adhesion of a smooth sphere, Eqs 10-17 with A = 0, unbounded.

An oracle for the C solver that shares neither code nor method with it: the
elastic surface in Copson's form on spectral panels (copson.py), adaptive
meshes and an arclength in (approach, load, central gap) (branch.py), folds and
extrema by root finding and converged on three meshes (landmarks.py).

    smooth_sphere.py --self-test       the operator and the solver against exact results
    smooth_sphere.py --tabor 2         landmarks of one Tabor parameter
    smooth_sphere.py --sample          recompute a sample, compare with the stored tables
    smooth_sphere.py --write [DIR]     regenerate all tables (about 15 minutes)
"""

import argparse
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from branch import (APPROACH, FINE_TRACE, LOAD, POLISH, TRACE, NotConverged, advance,
                    correct, remesh, smooth_sphere)
from landmarks import converge, find_landmarks, landmark_kinds, polish, pull_off, trace
from tables import bound, number, read_table, write_table
import self_test

TABORS = ("0.01 0.015 0.02 0.03 0.05 0.07 0.1 0.15 0.2 0.3 0.4 0.5 0.6 0.7 0.8 1 1.25 1.5 "
          "1.75 2 2.5 3 3.5 4 5 10").split()
SAMPLE = ("0.3", "1", "3")
CURVES = {"0.01": -8.0, "1": -12.0, "2": -12.0, "3": -12.0}     # tabor: first approach
CURVE_END = 3.0           # load of the last point of a curve
CURVE_POINTS = 180
CURVE_CHECK = 10          # every so many points the third level is solved as well
FAR = -12.0               # approach from which landmarks are looked for
FIRM = 1.0                # load at which the search for landmarks ends
SAFETY = 3.0              # stored uncertainty / observed difference between levels
DATE = "2026-11-21"

PULL_OFF, LANDMARKS, CURVE = "feng_pull_off.csv", "feng_landmarks.csv", "feng_curves.csv"


@dataclass(frozen=True)
class Row:
    """A converged landmark; `spread` = differences between levels (D, W)."""
    kind: str
    approach: float
    load: float
    spread: np.ndarray


def solve_landmarks(tabor, levels=POLISH, check=True):
    """Converged landmarks of one Tabor parameter, in order along the branch."""
    problem = smooth_sphere(float(tabor))
    marks = find_landmarks(problem, trace(problem, TRACE, FAR, FIRM))
    if check:
        finer = find_landmarks(problem, trace(problem, FINE_TRACE, FAR, FIRM, refine=2.0))
        if landmark_kinds(finer) != landmark_kinds(marks):
            raise NotConverged(f"tabor {tabor}: the finer trace has other landmarks")
        marks = finer
    rows = []
    for mark in marks:
        value, spread = converge(lambda level: polish(problem, mark, level).state.y[:2], levels)
        rows.append(Row(mark.kind, value[APPROACH], value[LOAD], spread))
    return rows


def curve_states(problem, states):
    """About CURVE_POINTS states from the first to load CURVE_END, spread evenly
    over a monitor of which half is arclength and half turning in the (D, W)
    plane, so that bends are well covered."""
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


def solve_curve(tabor, first):
    """Rows (approach, load, spread, checked on the third level) of a curve.
    Each point is the crossing of the curve with a line normal to it, the same
    line on every level: the spread is the distance normal to the curve."""
    problem = smooth_sphere(float(tabor))
    states = trace(problem, TRACE, first, CURVE_END)
    last = states[-1]                                   # a little beyond CURVE_END
    states[-1] = correct(problem, last.surface, last.gap, last.approach,
                         np.eye(3)[LOAD], CURVE_END, last.rate)
    points = list(curve_states(problem, states))
    rows = []
    for i, state in enumerate(points):
        direction = state.rate * [1.0, 1.0, 0.0]
        direction /= np.linalg.norm(direction)
        target = direction @ state.y
        if i == 0:
            direction, target = np.eye(3)[APPROACH], first
        elif i == len(points) - 1:
            direction, target = np.eye(3)[LOAD], CURVE_END
        checked = i % CURVE_CHECK == 0
        value, spread = converge(
            lambda level: remesh(problem, state, level, direction, target).y[:2],
            POLISH if checked else POLISH[:2])
        rows.append((*value, np.linalg.norm(spread), checked))
    return rows


def header(what, uncertainty, convergence):
    return {
        "what": what,
        "source": "A. Papangelo, M. Ciavarella, Lubricants 8(9), 90 (2020), "
                  "doi 10.3390/lubricants8090090, Eqs 10-17 with A = 0 on the unbounded "
                  "half-space, after Feng's problem. These are NOT Feng's plotted points: "
                  "the equations were solved anew.",
        "kind": "oracle",
        "method": "Copson (double Abel) form of the elastic operator on adaptive spectral "
                  "panels with a mapped panel to infinity; Newton; arclength in "
                  "(approach, load, central gap); shares no code or method with src/",
        "units": "approach in units of epsilon, > 0 pressed together; load = W/(pi w R), "
                 "> 0 compressive; force = -load; tabor = (R w^2/(E*^2 epsilon^3))^(1/3)",
        "uncertainty": uncertainty,
        "convergence": convergence,
        "generator": "reference/make/smooth_sphere.py",
        "command": "python3 reference/make/smooth_sphere.py --write",
        "date": DATE,
    }


def levels_in_words(count):
    return "; ".join(f"level {i + 1}: {l.order} nodes a panel, {l.tail} in the mapped panel, "
                     f"traction resolved to {l.tolerance:g}, mapped panel from "
                     f"{l.cut:g} max(6 sqrt(2/tabor), 10) Gamma, "
                     f"{l.extra} extra quadrature points"
                     for i, l in enumerate(POLISH[:count]))


BOUND_IN_WORDS = (f"bound: {SAFETY:g} times the largest difference between refinement levels, "
                  "not below 1e-10")


def write_landmarks(folder, solved):
    spread = np.array([r.spread for rows in solved.values() for r in rows]).max(axis=0)
    evidence = (f"every value solved on three levels ({levels_in_words(3)}); largest difference "
                f"from the third level over all rows: approach {spread[0]:.1e}, "
                f"load {spread[1]:.1e}; the same landmarks were found on two traces of "
                "different mesh and step")
    table, best = [], []
    for tabor, rows in solved.items():
        for i, r in enumerate(rows):
            table.append((tabor, str(i + 1), r.kind, number(r.approach), number(r.load),
                          bound(SAFETY * r.spread[0]), bound(SAFETY * r.spread[1])))
        r = pull_off(rows)
        best.append((tabor, number(-r.load), number(r.approach),
                     bound(SAFETY * r.spread[1]), bound(SAFETY * r.spread[0])))
    write_table(folder / LANDMARKS, header(
        f"folds in approach and extrema of load along the branch from approach {FAR:g} to "
        f"load {FIRM:g}, in order; smooth sphere. jump_in: local maximum of approach, jump_out: "
        "local minimum of approach, minimum and maximum: of the load along the branch",
        BOUND_IN_WORDS, evidence),
        "tabor index kind approach load approach_uncertainty load_uncertainty".split(), table)
    write_table(folder / PULL_OFF, header(
        "pull-off (global minimum of the load along the whole branch, stable or not), "
        "smooth sphere", BOUND_IN_WORDS, evidence),
        "tabor force approach force_uncertainty approach_uncertainty".split(), best)


def write_curves(folder, solved):
    table = []
    for tabor, rows in solved.items():
        for i, (approach, load, spread, _) in enumerate(rows):
            table.append((tabor, str(i + 1), number(approach), number(load),
                          bound(SAFETY * spread)))
    every = [row for rows in solved.values() for row in rows]
    two = max(row[2] for row in every if not row[3])
    three = max(row[2] for row in every if row[3])
    evidence = (f"every point solved on two levels, every {CURVE_CHECK}th on three "
                f"({levels_in_words(3)}); largest difference normal to the curve: two levels "
                f"{two:.1e}, three levels {three:.1e}")
    write_table(folder / CURVE, header(
        f"load against approach, points in order along the branch to load {CURVE_END:g}, "
        "smooth sphere",
        BOUND_IN_WORDS + "; of the distance of a point from the curve", evidence),
        "tabor index approach load uncertainty".split(), table)


def write_all(folder):
    folder.mkdir(parents=True, exist_ok=True)
    begin = time.time()

    def note(text):
        print(f"{time.time() - begin:7.0f} s  {text}", file=sys.stderr, flush=True)

    solved = {}
    for tabor in TABORS:
        solved[tabor] = solve_landmarks(tabor)
        note(f"tabor {tabor}: {len(solved[tabor])} landmarks, largest difference "
             f"{max(r.spread.max() for r in solved[tabor]):.1e}")
    write_landmarks(folder, solved)
    curves = {}
    for tabor, first in CURVES.items():
        curves[tabor] = solve_curve(tabor, first)
        note(f"tabor {tabor}: curve of {len(curves[tabor])} points, largest difference "
             f"{max(r[2] for r in curves[tabor]):.1e}")
    write_curves(folder, curves)


def compare(where, value, stored, uncertainty, name):
    """Raise if a recomputed value is outside the stored uncertainty."""
    if not abs(value - float(stored)) <= float(uncertainty):
        raise ValueError(f"{name}, {where}: recomputed {number(value)}, stored {stored}, "
                         f"uncertainty {uncertainty}")


def sample(folder):
    """Recompute the sample on one level and compare with the stored tables."""
    landmarks = read_table(folder / LANDMARKS)[1]
    best = {row["tabor"]: row for row in read_table(folder / PULL_OFF)[1]}
    read_table(folder / CURVE)
    for tabor in SAMPLE:
        stored = [row for row in landmarks if row["tabor"] == tabor]
        rows = solve_landmarks(tabor, POLISH[1:2], check=False)
        if [r.kind for r in rows] != [s["kind"] for s in stored]:
            raise ValueError(f"{LANDMARKS}, tabor {tabor}: other kinds of landmarks")
        for r, s in zip(rows, stored):
            where = f"tabor {tabor} index {s['index']}"
            compare(where, r.approach, s["approach"], s["approach_uncertainty"], LANDMARKS)
            compare(where, r.load, s["load"], s["load_uncertainty"], LANDMARKS)
        r, s = pull_off(rows), best[tabor]
        compare(f"tabor {tabor}", -r.load, s["force"], s["force_uncertainty"], PULL_OFF)
        compare(f"tabor {tabor}", r.approach, s["approach"], s["approach_uncertainty"], PULL_OFF)


def main():
    stored = Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    group = parser.add_mutually_exclusive_group(required=True)
    group.add_argument("--self-test", action="store_true", help="test against exact results")
    group.add_argument("--sample", action="store_true", help="recompute a sample and compare")
    group.add_argument("--tabor", metavar="X", help="print the landmarks of one parameter")
    group.add_argument("--write", metavar="DIR", nargs="?", type=Path, const=stored,
                       help="regenerate the tables (in DIR)")
    arguments = parser.parse_args()
    try:
        if arguments.self_test:
            self_test.run()
        elif arguments.sample:
            sample(stored)
            print("sample agrees with the stored tables")
        elif arguments.tabor:
            for r in solve_landmarks(arguments.tabor, check=False):
                print(f"{r.kind:9s} approach {r.approach: .13f} load {r.load: .13f} "
                      f"differences {r.spread[0]:.1e} {r.spread[1]:.1e}")
        else:
            write_all(arguments.write)
    except (ValueError, OSError, NotConverged) as problem:
        print(f"smooth_sphere.py: {problem}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
