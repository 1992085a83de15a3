#!/usr/bin/env python3
"""Wavy spheres with Lennard-Jones adhesion, Eqs 10-17: pull-off, special points, curves.

The equations of smooth_sphere.py with the undeformed gap mu u^2/2 + A (1 - cos(2 pi u/L)),
L = lambda/sqrt(R mu), on a surface that ends at r = R as in the paper, or on an unbounded one.

    wavy_sphere.py --list                    the scenes of the tables, numbered
    wavy_sphere.py --scene 3 1 20 100 100    special points of one of them (outer radius last)
    wavy_sphere.py --sample                  recompute a sample, compare with the stored tables
    wavy_sphere.py --write [DIR]             regenerate the tables (about half an hour)
"""

import sys
from dataclasses import dataclass

import numpy as np

from branch import APPROACH, FINE_TRACE, LOAD, TRACE, Level, NotConverged, Problem
from command_line import act_on_scenes, notes, options, run
from converged import (BOUND_IN_WORDS, CURVE_CHECK, SAFETY, compare, converge_mark, landmark_cells,
                       pull_off_cells, show, solve_curve, worst)
from landmarks import find_landmarks, landmark_kinds, pull_off, trace
from laws import Mie
from profiles import Sphere, Wave, Waved
from tables import bound, number, read_table, write_table

FAR = -15.0               # approach from which special points are searched for
CURVE_FAR = -8.0          # approach of the first point of a curve
CORE = 40.0               # start of the mapped panel of an unbounded surface. It does not resolve the
                          # waves, which contribute less than 1e-9 of the load there
DATE = "2026-11-21"
RADIUS_DATE = "2026-11-22"  # date of the tables with contact radii
RADIUS_UNITS = ("; contact_radius: the outermost radius where the gap is that of the greatest "
                "tension, H = 3^(1/6) - 1, in epsilon; 0 when there is none")

# Less than 1e-12 of the largest traction cannot be resolved. The difference of a gap of up to 50 eps and an
# approach of 20 has a rounding error of 1e-14, and at compressed crests the traction is 100 times steeper.
POLISH = (Level(order=14, tail=18, tolerance=1e-10),
          Level(order=18, tail=22, tolerance=1e-11, cut=1.21),
          Level(order=22, tail=28, tolerance=1e-12, cut=1.37, extra=8))


@dataclass(frozen=True)
class Scene:
    """One wavy sphere (texts, as in the tables), the approach up to which its special
    points are converged, and the end of the branch, which is followed further to make
    sure that no minimum of the load is deeper."""
    tabor: str
    amplitude: str
    wavelength: str
    radius: str
    outer_radius: str
    complete_to: float
    traced_to: float

    @property
    def key(self):
        return self.tabor, self.amplitude, self.wavelength, self.radius, self.outer_radius

    @property
    def width(self):
        """Gamma/epsilon."""
        return np.sqrt(float(self.radius) * float(self.tabor))

    def problem(self):
        mu, amplitude, wavelength, _, outer = map(float, self.key)
        width = self.width
        k = 2.0 * np.pi * width / wavelength

        profile = Waved(Sphere(mu), (Wave(amplitude, k),))
        return Problem(Mie(3.0, 9.0, mu), profile, mu, None if np.isinf(outer) else outer / width,
                       max(6.0 * np.sqrt(2.0 / mu), CORE))


SCENES = [
    Scene("3", "0", "20", "100", "100", 12.0, 20.0),
    Scene("0.15", "1", "20", "100", "100", 4.0, 12.0),
    Scene("0.67", "1", "20", "100", "100", 12.0, 20.0),
    Scene("1", "1", "20", "100", "100", 12.0, 20.0),
    Scene("2.385", "0.37", "13.7", "61.3", "61.3", 12.0, 16.0),
    Scene("3", "1", "20", "100", "100", 12.0, 20.0),
    Scene("3", "1", "20", "100", "inf", 20.0, 30.0),
    Scene("4", "0.4", "10", "100", "100", 13.0, 18.0),
    Scene("5", "10", "20", "100", "100", 12.0, 22.0),
]
CURVES = [("3", "1", "20", "100", "100")]
SAMPLE = [("1", "1", "20", "100", "100")]

KEYS = "tabor amplitude wavelength radius outer_radius".split()
PULL_OFF, LANDMARKS, CURVE = "wavy_pull_off.csv", "wavy_landmarks.csv", "wavy_curves.csv"


def scene_of(key):
    for scene in SCENES:
        if scene.key == tuple(key):
            return scene
    raise ValueError(f"no scene {' '.join(key)}: see --list")


@dataclass(frozen=True)
class Solved:
    """The special points of a scene up to complete_to, and the least load beyond."""
    scene: Scene
    rows: list
    beyond: float = np.nan


def first_passage(states, approach):
    """The states up to the first one beyond an approach."""
    return states[:1 + next(i for i, s in enumerate(states) if s.approach > approach)]


def solve(scene, levels=POLISH, check=True):
    """Solves a scene. With `check` the special points are searched again on a second trace
    with another mesh and other steps, and the branch is followed further (check_beyond)."""
    problem = scene.problem()
    ends = {"first_approach": FAR, "last_load": np.inf}
    states = trace(problem, TRACE, last_approach=scene.traced_to if check else scene.complete_to,
                   **ends)
    near = first_passage(states, scene.complete_to)
    marks = find_landmarks(problem, near)
    if not check:
        return Solved(scene, [converge_mark(problem, mark, levels) for mark in marks])
    finer = find_landmarks(problem, trace(problem, FINE_TRACE, refine=2.0,
                                          last_approach=scene.complete_to, **ends))
    if landmark_kinds(finer) != landmark_kinds(marks):
        raise NotConverged(f"{scene.key}: the finer trace has other landmarks")
    rows = [converge_mark(problem, mark, levels) for mark in finer]
    beyond = check_beyond(scene, states[len(near) - 1:], pull_off(rows).load)
    return Solved(scene, rows, beyond)


def check_beyond(scene, states, deepest):
    """The least load beyond complete_to, which must not be below `deepest`.
    The next extremum of the load must be at a larger approach than complete_to. (The
    next fold always is.) From this a comparison knows where the list ends."""
    least = min(s.load for s in states)
    turn = next((b for a, b in zip(states, states[1:]) if a.rate[LOAD] * b.rate[LOAD] < 0), None)
    if not least > deepest or (turn and turn.approach < scene.complete_to):
        raise NotConverged(f"{scene.key}: complete_to {scene.complete_to} is no place to end")
    return least


def header(what, uncertainty, convergence, units="", date=DATE):
    return {
        "what": what,
        "source": "A. Papangelo, M. Ciavarella, Lubricants 8(9), 90 (2020), "
                  "doi 10.3390/lubricants8090090, Eqs 10-17, solved anew",
        "kind": "oracle",
        "method": "Copson (double Abel) form of the elastic operator on adaptive spectral "
                  "panels, to the cut or with a mapped panel to infinity; Newton; arclength in "
                  "(approach, load, central gap); shares no code or method with src/",
        "units": "approach, amplitude, wavelength, radius and outer_radius (inf: unbounded) in "
                 "units of epsilon, approach > 0 pressed together; load = W/(pi w R), > 0 compressive; "
                 "force = -load; tabor = (R w^2/(E*^2 epsilon^3))^(1/3)" + units,
        "uncertainty": uncertainty,
        "convergence": convergence,
        "generator": "reference/make/wavy_sphere.py",
        "command": "python3 reference/make/wavy_sphere.py --write",
        "date": date,
    }


def levels_in_words():
    return "; ".join(f"level {i + 1}: {l.order} nodes a panel, {l.tail} in the mapped panel, "
                     f"traction resolved to {l.tolerance:g}, edges moved or mapped panel from "
                     f"{CORE:g} Gamma put off by a factor {l.cut:g}, {l.extra} extra quadrature "
                     "points" for i, l in enumerate(POLISH))


def write_landmarks(folder, solved):
    spread = np.array([r.spread for one in solved for r in one.rows]).max(axis=0)
    evidence = (f"every value solved on three levels ({levels_in_words()}); largest difference "
                f"from the third level over all rows: approach {spread[0]:.1e}, "
                f"load {spread[1]:.1e}, contact radius over Gamma {spread[2]:.1e}; the same "
                "landmarks were found on two traces of different mesh and step")
    table = [(*one.scene.key, number(one.scene.complete_to), *cells)
             for one in solved for cells in landmark_cells(one.rows, one.scene.width)]
    best = [(*one.scene.key, *pull_off_cells(one.rows, one.scene.width),
             number(one.scene.complete_to), number(one.scene.traced_to), f"{one.beyond:.4f}")
            for one in solved]
    write_table(folder / LANDMARKS, header(
        f"folds in approach and extrema of load along the branch, in order, from approach {FAR:g} "
        "to where the approach first exceeds complete_to; wavy sphere. jump_in: local maximum of "
        "approach, jump_out: local minimum of approach, minimum and maximum: of the load along the "
        "branch", BOUND_IN_WORDS, evidence, RADIUS_UNITS, RADIUS_DATE),
        KEYS + ("complete_to index kind approach load contact_radius approach_uncertainty "
                "load_uncertainty contact_radius_uncertainty").split(), table)
    write_table(folder / PULL_OFF, header(
        "pull-off (global minimum of the load along the branch, stable or not), wavy sphere. "
        "Beyond where the approach first exceeds complete_to the branch was followed to where it first "
        "exceeds traced_to; the load there was never below least_load_beyond",
        BOUND_IN_WORDS, evidence, RADIUS_UNITS, RADIUS_DATE),
        KEYS + ("force approach contact_radius force_uncertainty approach_uncertainty "
                "contact_radius_uncertainty complete_to traced_to least_load_beyond").split(), best)


def write_curves(folder, solved):
    table = [(*scene.key, str(i + 1), number(approach), number(load), bound(SAFETY * spread))
             for scene, rows in solved
             for i, (approach, load, spread, _) in enumerate(rows)]
    two, three = worst(rows for _, rows in solved)
    evidence = (f"every point solved on two levels, every {CURVE_CHECK}th on three "
                f"({levels_in_words()}); largest difference normal to the curve: two levels "
                f"{two:.1e}, three levels {three:.1e}")
    write_table(folder / CURVE, header(
        f"load against approach, points in order along the branch from approach {CURVE_FAR:g} to "
        "where it first reaches complete_to of the landmarks, wavy sphere",
        BOUND_IN_WORDS + "; of the distance of a point from the curve", evidence),
        KEYS + "index approach load uncertainty".split(), table)


def write_all(folder):
    folder.mkdir(parents=True, exist_ok=True)
    note = notes()
    solved = []
    for scene in SCENES:
        solved.append(solve(scene))
        rows = solved[-1].rows
        note(f"{' '.join(scene.key)}: {len(rows)} landmarks, pull-off {-pull_off(rows).load:.12f}, "
             f"largest difference {max(r.spread.max() for r in rows):.1e}, "
             f"least load beyond {solved[-1].beyond:.3f}")
    write_landmarks(folder, solved)
    curves = []
    for key in CURVES:
        scene = scene_of(key)
        rows = solve_curve(scene.problem(), CURVE_FAR, APPROACH, scene.complete_to, POLISH)
        curves.append((scene, rows))
        note(f"{' '.join(key)}: curve of {len(rows)} points, largest difference "
             f"{max(r[2] for r in rows):.1e}")
    write_curves(folder, curves)


def sample(folder):
    """Recomputes the sample on one level and compares it with the stored tables."""
    landmarks = read_table(folder / LANDMARKS)[1]
    best = {tuple(row[k] for k in KEYS): row for row in read_table(folder / PULL_OFF)[1]}
    read_table(folder / CURVE)
    for key in SAMPLE:
        compare(f"{LANDMARKS}, {' '.join(key)}",
                solve(scene_of(key), POLISH[1:2], check=False).rows,
                [row for row in landmarks if tuple(row[k] for k in KEYS) == key], best[key],
                scene_of(key).width, "contact_radius")


def show_scene(solved):
    scene = solved.scene
    show(solved.rows, scene.width, "eps")
    print(f"complete to approach {scene.complete_to:g}; least load from there to approach "
          f"{scene.traced_to:g}: {solved.beyond:.4f}")


def act(arguments):
    act_on_scenes(arguments, [scene.key for scene in SCENES], lambda key: show_scene(solve(scene_of(key))),
                  sample, write_all)


def main():
    parser, group = options(__doc__)
    group.add_argument("--list", action="store_true", help="print the scenes of the tables")
    group.add_argument("--scene", metavar=("TABOR", "AMPLITUDE", "WAVELENGTH", "RADIUS", "OUTER"),
                       nargs=5, help="print the landmarks of a scene of the tables")
    return run(act, parser.parse_args(), NotConverged)


if __name__ == "__main__":
    sys.exit(main())
