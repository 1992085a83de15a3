#!/usr/bin/env python3
"""Feng's problem: adhesion of a smooth sphere, Eqs 10-17 with A = 0, unbounded.

Reference data for the C solver from a program that shares neither code nor method with it:
the elastic surface is in Copson's form on spectral panels (copson.py), meshes are adaptive,
the arclength is in (approach, load, central gap) (branch.py), and folds and extrema are
found by root finding and converged on three meshes (landmarks.py).

    smooth_sphere.py --self-test       the operator and the solver against exact results
    smooth_sphere.py --tabor 2         special points of one Tabor parameter
    smooth_sphere.py --sample          recompute a sample, compare with the stored tables
    smooth_sphere.py --write [DIR]     regenerate all tables (about 15 minutes)
"""

import sys

import numpy as np

from branch import LOAD, POLISH, NotConverged, smooth_sphere
from command_line import STORED, notes, options, run
from converged import (BOUND_IN_WORDS, CURVE_CHECK, SAFETY, compare, landmark_cells, pull_off_cells,
                       show, solve_curve, solve_landmarks, worst)
from tables import bound, number, read_table, write_table
import self_test

TABORS = ("0.01 0.015 0.02 0.03 0.05 0.07 0.1 0.15 0.2 0.3 0.4 0.5 0.6 0.7 0.8 1 1.25 1.5 "
          "1.75 2 2.5 3 3.5 4 5 10").split()
SAMPLE = ("1",)
CURVES = {"0.01": -8.0, "1": -12.0, "2": -12.0, "3": -12.0, "5": -12.0}     # tabor: first approach
CURVE_END = 3.0           # load of the last point of a curve
FAR = -12.0               # approach from which special points are searched for
FIRM = 1.0                # load at which the search for special points ends
ENDS = {"first_approach": FAR, "last_load": FIRM}
DATE = "2026-11-21"
RADIUS_DATE = "2026-11-22"  # date of the tables with contact radii

PULL_OFF, LANDMARKS, CURVE = "feng_pull_off.csv", "feng_landmarks.csv", "feng_curves.csv"
# Approach and load do not depend on R. The contact radius is proportional to sqrt(R), so it is stored
# in units of sqrt(R epsilon).
RADIUS = "contact_radius_over_root_radius"
RADIUS_UNITS = (f"; {RADIUS}: the outermost radius where the gap is that of the greatest tension, "
                "H = 3^(1/6) - 1, in units of sqrt(R epsilon); 0 when there is none")


def solve_tabor(tabor, levels=POLISH, check=True):
    """Converged special points of one Tabor parameter, in order along the branch."""
    return solve_landmarks(smooth_sphere(float(tabor)), ENDS, levels, check)


def width(tabor):
    """Gamma/sqrt(R epsilon)."""
    return np.sqrt(float(tabor))


def header(what, uncertainty, convergence, units="", date=DATE):
    return {
        "what": what,
        "source": "A. Papangelo, M. Ciavarella, Lubricants 8(9), 90 (2020), "
                  "doi 10.3390/lubricants8090090, Eqs 10-17 with A = 0 on the unbounded "
                  "half-space, after Feng's problem. These are NOT Feng's plotted points: "
                  "the equations were solved anew.",
        "kind": "oracle",
        "amplitude": "0",           # scene keys: the rows are for these scenes only
        "outer_radius": "inf",
        "method": "Copson (double Abel) form of the elastic operator on adaptive spectral "
                  "panels with a mapped panel to infinity; Newton; arclength in "
                  "(approach, load, central gap); shares no code or method with src/",
        "units": "approach in units of epsilon, > 0 pressed together; load = W/(pi w R), "
                 "> 0 compressive; force = -load; tabor = (R w^2/(E*^2 epsilon^3))^(1/3)"
                 + units,
        "uncertainty": uncertainty,
        "convergence": convergence,
        "generator": "reference/make/smooth_sphere.py",
        "command": "python3 reference/make/smooth_sphere.py --write",
        "date": date,
    }


def levels_in_words(count):
    return "; ".join(f"level {i + 1}: {l.order} nodes a panel, {l.tail} in the mapped panel, "
                     f"traction resolved to {l.tolerance:g}, mapped panel from "
                     f"{l.cut:g} max(6 sqrt(2/tabor), 10) Gamma, "
                     f"{l.extra} extra quadrature points"
                     for i, l in enumerate(POLISH[:count]))


def write_landmarks(folder, solved):
    spread = np.array([r.spread for rows in solved.values() for r in rows]).max(axis=0)
    evidence = (f"every value solved on three levels ({levels_in_words(3)}); largest difference "
                f"from the third level over all rows: approach {spread[0]:.1e}, "
                f"load {spread[1]:.1e}, contact radius over Gamma {spread[2]:.1e}; the same "
                "landmarks were found on two traces of different mesh and step")
    table = [(tabor, *cells) for tabor, rows in solved.items()
             for cells in landmark_cells(rows, width(tabor))]
    best = [(tabor, *pull_off_cells(rows, width(tabor))) for tabor, rows in solved.items()]
    write_table(folder / LANDMARKS, header(
        f"folds in approach and extrema of load along the branch from approach {FAR:g} to "
        f"load {FIRM:g}, in order; smooth sphere. jump_in: local maximum of approach, jump_out: "
        "local minimum of approach, minimum and maximum: of the load along the branch",
        BOUND_IN_WORDS, evidence, RADIUS_UNITS, RADIUS_DATE),
        f"tabor index kind approach load {RADIUS} approach_uncertainty load_uncertainty "
        f"{RADIUS}_uncertainty".split(), table)
    write_table(folder / PULL_OFF, header(
        "pull-off (global minimum of the load along the whole branch, stable or not), "
        "smooth sphere", BOUND_IN_WORDS, evidence, RADIUS_UNITS, RADIUS_DATE),
        f"tabor force approach {RADIUS} force_uncertainty approach_uncertainty "
        f"{RADIUS}_uncertainty".split(), best)


def write_curves(folder, solved):
    table = []
    for tabor, rows in solved.items():
        for i, (approach, load, spread, _) in enumerate(rows):
            table.append((tabor, str(i + 1), number(approach), number(load),
                          bound(SAFETY * spread)))
    two, three = worst(solved.values())
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
    note = notes()
    solved = {}
    for tabor in TABORS:
        solved[tabor] = solve_tabor(tabor)
        note(f"tabor {tabor}: {len(solved[tabor])} landmarks, largest difference "
             f"{max(r.spread.max() for r in solved[tabor]):.1e}")
    write_landmarks(folder, solved)
    curves = {}
    for tabor, first in CURVES.items():
        curves[tabor] = solve_curve(smooth_sphere(float(tabor)), first, LOAD, CURVE_END)
        note(f"tabor {tabor}: curve of {len(curves[tabor])} points, largest difference "
             f"{max(r[2] for r in curves[tabor]):.1e}")
    write_curves(folder, curves)


def sample(folder):
    """Recomputes the sample on one level and compares it with the stored tables."""
    landmarks = read_table(folder / LANDMARKS)[1]
    best = {row["tabor"]: row for row in read_table(folder / PULL_OFF)[1]}
    read_table(folder / CURVE)
    for tabor in SAMPLE:
        compare(f"{LANDMARKS}, tabor {tabor}", solve_tabor(tabor, POLISH[1:2], check=False),
                [row for row in landmarks if row["tabor"] == tabor], best[tabor], width(tabor),
                RADIUS)


def act(arguments):
    if arguments.self_test:
        self_test.run()
    elif arguments.sample:
        sample(STORED)
        print("sample agrees with the stored tables")
    elif arguments.tabor:
        show(solve_tabor(arguments.tabor, check=False), width(arguments.tabor), "sqrt(R eps)")
    else:
        write_all(arguments.write)


def main():
    parser, group = options(__doc__)
    group.add_argument("--self-test", action="store_true", help="test against exact results")
    group.add_argument("--tabor", metavar="X", help="print the landmarks of one parameter")
    return run(act, parser.parse_args(), NotConverged)


if __name__ == "__main__":
    sys.exit(main())
