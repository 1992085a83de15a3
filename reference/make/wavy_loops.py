#!/usr/bin/env python3
"""Loading and unloading of wavy spheres at given approach: jumps, pull-off measured, energy lost.

The equations are those of wavy_sphere.py, but no branch is followed through a fold. Stable equilibria
are followed from far out to the fold at which they end. There the surfaces relax in time at constant
approach, and the path continues from the state of rest, up to the preload and back.

    wavy_loops.py --list                          the scenes of the tables
    wavy_loops.py --scene 4 3 10 100 100 4        one of them (outer radius, preload last)
    wavy_loops.py --sample                        recompute a loop on one level, compare
    wavy_loops.py --write [DIR]                   regenerate the tables (about ten minutes)
"""

import sys
from dataclasses import dataclass

import numpy as np

import wavy_sphere
from branch import TRACE, NotConverged, start
from command_line import act_on_scenes, notes, options, run
from converged import BOUND_IN_WORDS, SAFETY
from landmarks import polish
from stable_paths import FAR, leap, leap_on_level, piece
from tables import STORED_FLOOR, bound, number, read_table, write_table

KEYS = "tabor amplitude wavelength radius outer_radius preload".split()
LOOPS, JUMPS = "wavy_loops.csv", "wavy_jumps.csv"
SCENES = [("4", "0.4", "10", "100", "100", "4"), ("4", "3", "10", "100", "100", "4")]
SAMPLE = SCENES[:1]
DATE = "2026-11-21"


def loop(scene, preload):
    """The jumps of loading and unloading, and the minima of the load on the way of unloading."""
    problem = scene.problem()
    leaps, minima, state = [], [], start(problem, FAR, TRACE)
    for sense, end in ((1, preload), (-1, FAR)):
        while True:
            here = piece(problem, state, sense, end)
            minima += [mark for mark in here.passed if sense < 0 and mark.kind == "minimum"]
            if here.fold is None:
                break
            leaps.append(leap(scene, here.fold, sense > 0))
            state = leaps[-1].rest
        state = here.states[-1]
    return leaps, minima


@dataclass(frozen=True)
class Solved:
    """A loop. For each jump: phase, approach, load before, load after, energy lost (values and spread
    between levels). For the whole loop: force, approach and energy lost, in the same way."""
    key: tuple
    phases: list
    leaps: np.ndarray
    leap_spread: np.ndarray
    whole: np.ndarray
    spread: np.ndarray


def on_level(problem, leaps, pull, level):
    """The values of the jumps and of the whole loop on one level."""
    rows = [leap_on_level(problem, jump, level) for jump in leaps]
    deepest = polish(problem, pull, level).state
    return np.array(rows), np.array([-deepest.load, deepest.approach, sum(row[3] for row in rows)])


def solve(key, levels=wavy_sphere.POLISH):
    scene = wavy_sphere.Scene(*key[:5], 0.0, 0.0)
    problem = scene.problem()
    leaps, minima = loop(scene, float(key[5]))
    pull = min(minima, key=lambda mark: mark.state.load)
    if any(jump.fold.state.load < pull.state.load for jump in leaps if not jump.loading):
        raise NotConverged(f"{key}: the tension is greatest at a jump, not at a minimum")
    found = [on_level(problem, leaps, pull, level) for level in levels]
    rows, wholes = np.array([f[0] for f in found]), np.array([f[1] for f in found])
    return Solved(tuple(key), ["loading" if jump.loading else "unloading" for jump in leaps],
                  rows[-1], np.abs(rows - rows[-1]).max(axis=0),
                  wholes[-1], np.abs(wholes - wholes[-1]).max(axis=0))


def header(what, spread):
    made = wavy_sphere.header(
        what + ". Surfaces pressed together from far out to the approach `preload` and pulled "
        "apart again, at given approach and slowly; where an equilibrium ends they come to rest at "
        "another, with less energy", BOUND_IN_WORDS,
        f"every value solved on three levels ({wavy_sphere.levels_in_words()}); differences from "
        "the third are at most: " + ", ".join(f"{name} {max(value, STORED_FLOOR / SAFETY):.1e}"
                                             for name, value in spread))
    made["method"] = (
        "Copson (double Abel) form of the elastic operator on adaptive spectral panels, to the cut; "
        "Newton; stable equilibria followed by arclength to where they end, and from there relaxation "
        "in time against a local damping at that approach; energies of the states themselves, not "
        "integrals along a branch; shares no code or method with src/")
    made["units"] += ("; preload: approach; energy_lost: drop of the potential energy, in units of "
                      "pi w R epsilon")
    made.update(generator="reference/make/wavy_loops.py",
                command="python3 reference/make/wavy_loops.py --write", date=DATE)
    return made


def cells(values, spread):
    return [number(v) for v in values], [bound(SAFETY * s) for s in spread]


def leap_columns():
    names = "approach load_before load_after energy_lost".split()
    return KEYS + ["index", "phase"] + names + [name + "_uncertainty" for name in names]


def leap_rows(one):
    for k, (phase, values, spread) in enumerate(zip(one.phases, one.leaps, one.leap_spread)):
        stored, doubt = cells(values, spread)
        yield [*one.key, str(k + 1), phase, *stored, *doubt]


def loop_columns():
    names = "force approach energy_lost".split()
    return KEYS + names + [name + "_uncertainty" for name in names]


def loop_row(one):
    stored, doubt = cells(one.whole, one.spread)
    return [*one.key, *stored, *doubt]


def write_all(folder):
    folder.mkdir(parents=True, exist_ok=True)
    note, solved = notes(), []
    for key in SCENES:
        solved.append(solve(key))
        note(f"{' '.join(key)}: {len(solved[-1].phases)} jumps")
    names = "approach", "load before", "load after", "energy lost"
    spread = np.max([one.leap_spread.max(axis=0) for one in solved], axis=0)
    write_table(folder / JUMPS, header(
        "jumps of loading and unloading at given approach, in their order, wavy sphere: the "
        "approach, the load before and after, the energy lost", zip(names, spread)), leap_columns(),
        [row for one in solved for row in leap_rows(one)])
    spread = np.max([one.spread for one in solved], axis=0)
    write_table(folder / LOOPS, header(
        "loading and unloading at given approach, wavy sphere: the greatest tension met in unloading "
        "(force) and its approach, the energy lost in all jumps",
        zip(("force", "approach", "energy lost"), spread)), loop_columns(), [loop_row(one) for one in solved])


def show(one):
    for row in [leap_columns(), *leap_rows(one), loop_columns(), loop_row(one)]:
        print(" ".join(row[len(KEYS):]))


def sample(folder):
    """Recomputes the sample on one level and compares it with the stored tables."""
    jumps, loops = (read_table(folder / name)[1] for name in (JUMPS, LOOPS))
    for key in SAMPLE:
        one = solve(key, wavy_sphere.POLISH[1:2])
        for rows, columns, stored in ((list(leap_rows(one)), leap_columns(), jumps),
                                      ([loop_row(one)], loop_columns(), loops)):
            stored = [row for row in stored if tuple(row[k] for k in KEYS) == key]
            if len(rows) != len(stored):
                raise ValueError(f"{' '.join(key)}: {len(rows)} rows, stored {len(stored)}")
            for values, row in zip(rows, stored):
                compare(" ".join(key), dict(zip(columns, values)), row)


def compare(where, values, stored):
    for name, value in values.items():
        doubt = stored.get(name + "_uncertainty")
        agrees = name.endswith("_uncertainty") or value == stored[name] or (
            doubt and abs(float(value) - float(stored[name])) <= float(doubt))
        if not agrees:
            raise ValueError(f"{where}: {name} recomputed {value}, stored {stored[name]}, "
                             f"uncertainty {doubt}")


def act(arguments):
    act_on_scenes(arguments, SCENES, lambda key: show(solve(key)), sample, write_all)


def main():
    parser, group = options(__doc__)
    group.add_argument("--list", action="store_true", help="print the scenes of the tables")
    group.add_argument("--scene", nargs=6, help="print a loop",
                       metavar=("TABOR", "AMPLITUDE", "WAVELENGTH", "RADIUS", "OUTER", "PRELOAD"))
    return run(act, parser.parse_args(), NotConverged)


if __name__ == "__main__":
    sys.exit(main())
