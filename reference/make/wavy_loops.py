#!/usr/bin/env python3
"""Loading and unloading of wavy spheres at given approach: jumps, pull-off measured, energy lost.

The equations of wavy_sphere.py, but no branch is followed past a fold: from far out a stable
equilibrium is followed up to where it ends, the surfaces are then let relax in time at that
approach, and so on from where they come to rest, up to the preload and back.

    wavy_loops.py --list                          the scenes of the tables
    wavy_loops.py --scene 4 3 10 100 100 4        one of them (outer radius, preload last)
    wavy_loops.py --sample                        recompute a loop on one level, compare
    wavy_loops.py --write [DIR]                   regenerate the tables (about ten minutes)
"""

import sys
from dataclasses import dataclass, replace

import numpy as np

import wavy_sphere
from branch import (APPROACH, CLOSEST_GAP, TRACE, NotConverged, correct, make_surface, remesh,
                    start)
from command_line import STORED, notes, options, run
from converged import BOUND_IN_WORDS, SAFETY
from landmarks import Landmark, find_landmarks, polish, walk
from tables import STORED_FLOOR, bound, number, read_table, write_table

FAR = -15.0               # approach at which loading begins and unloading ends
ALONG = np.array([1.0, 0.0, 0.0])   # at given approach
BEYOND = 1e-3             # past the fold, so that no equilibrium is left to rest at there
# Relaxation: the gap obeys (operator) dH/dt = -F, by implicit Euler. Only where it comes to rest counts.
FIRST_STEP, LAST_STEP = 1e-2, 1e6   # in time; the last one is Newton's method
GROWTH = 1.6              # of the step after a success; it is halved after a failure
FARTHEST = 0.2            # of 1 + H in one step: how far the path of the relaxation is followed
RELAX_ROUNDS = 12         # of Newton in one step
RELAX_DONE = 1e-6         # last relative update of one step
MOST_STEPS = 3000
RELAX_WIDTH = 1.6         # of the panels relaxed on, in eps: the contact's edge sweeps over all

KEYS = "tabor amplitude wavelength radius outer_radius preload".split()
LOOPS, JUMPS = "wavy_loops.csv", "wavy_jumps.csv"
SCENES = [("4", "0.4", "10", "100", "100", "4"), ("4", "3", "10", "100", "100", "4")]
SAMPLE = SCENES[:1]
DATE = "2026-11-21"


@dataclass(frozen=True)
class Leap:
    """A jump on the mesh of the walk: the fold it leaves, and where it comes to rest."""
    loading: bool
    fold: Landmark
    rest: object


def energy(problem, state):
    """U/(pi w R eps), of the interaction and elastic; its rate along equilibria is the load."""
    surface, x = state.surface, 1.0 / (1.0 + state.gap)
    p = problem.traction(state.gap)
    attraction = (8.0 / 3.0) * problem.tabor * (x**8 / 8.0 - x**2 / 2.0)
    return surface.load(attraction + 0.5 * p * problem.tabor * (surface.deflection @ p))


def turned(state, sense):
    """The state with its tangent towards larger (sense 1) or smaller approach."""
    if state.rate[APPROACH] * sense >= 0:
        return state
    return replace(state, rate=-state.rate, gap_rate=-state.gap_rate)


def piece(problem, state, sense, end):
    """The equilibria from a stable one towards larger or smaller approach, up to the fold where they
    end, or `end`: the extrema of the load passed, the fold (or None), the last state."""
    states = [state]
    for following in walk(problem, state, TRACE):
        states.append(following)
        if following.rate[APPROACH] * sense < 0 or (following.approach - end) * sense > 0:
            break
    marks = find_landmarks(problem, states)
    at = next((i for i, mark in enumerate(marks) if mark.component == APPROACH), len(marks))
    return marks[:at], marks[at] if at < len(marks) else None, states[-1]


def step_in_time(problem, surface, shape, gap, approach, step):
    """One step of implicit Euler, or None."""
    operator = problem.tabor * surface.deflection
    before, scale = gap, 1.0 / (1.0 + np.abs(gap))
    gap = gap.copy()
    for _ in range(RELAX_ROUNDS):
        p, slope = problem.traction(gap), problem.slope(gap)
        matrix = operator * (1.0 / step - slope)[None, :]
        matrix.flat[::surface.size + 1] += 1.0
        residual = operator @ ((gap - before) / step - p) + gap + approach - shape
        update = np.linalg.solve(matrix * scale[:, None], -residual * scale)
        if not np.isfinite(update).all() or np.max(-update / (1.0 + gap)) > CLOSEST_GAP:
            return None
        gap += update
        if np.max(np.abs(update) * scale) < RELAX_DONE:
            return gap
    return None


def relax(problem, fold, loading, width):
    """The equilibrium at the approach of a fold that the surfaces come to rest at."""
    approach = fold.state.approach + (BEYOND if loading else -BEYOND)
    old = fold.state.surface
    surface = make_surface(problem, TRACE, lambda low, high: high - low > width)
    shape = problem.shape(surface.u)
    elastic = fold.state.gap + fold.state.approach - problem.shape(old.u)
    gap, step = old.interpolate(elastic, surface.u, 1) - approach + shape, FIRST_STEP
    for _ in range(MOST_STEPS):
        following = step_in_time(problem, surface, shape, gap, approach, step)
        if following is None or np.max(np.abs(following - gap) / (1.0 + np.abs(gap))) > FARTHEST:
            step *= 0.5
            continue
        if step > LAST_STEP:
            break
        gap, step = following, step * GROWTH
    else:
        raise NotConverged(f"no rest after the fold at approach {fold.state.approach}")
    target = fold.state.approach
    rest = correct(problem, surface, following + approach - target, target, ALONG, target)
    return remesh(problem, rest, TRACE, ALONG, target)


def loop(problem, preload, width):
    """Leaps of loading and unloading, and the minima of the load passed in unloading."""
    leaps, minima, state = [], [], start(problem, FAR, TRACE)
    for sense, end in ((1, preload), (-1, FAR)):
        while True:
            passed, fold, last = piece(problem, turned(state, sense), sense, end)
            minima += [mark for mark in passed if sense < 0 and mark.kind == "minimum"]
            if fold is None:
                break
            state = relax(problem, fold, sense > 0, width)
            leaps.append(Leap(sense > 0, fold, state))
        if sense > 0:
            state = correct(problem, last.surface, last.gap, last.approach, ALONG, preload)
    return leaps, minima


@dataclass(frozen=True)
class Solved:
    """A loop: of each leap its phase, and approach, load before, load after, energy lost (values and
    spread between levels); of the whole the same of force, approach and energy lost."""
    key: tuple
    phases: list
    leaps: np.ndarray
    leap_spread: np.ndarray
    whole: np.ndarray
    spread: np.ndarray


def on_level(problem, leaps, pull, level):
    """Leaps and whole on one level."""
    rows = []
    for leap in leaps:
        fold = polish(problem, leap.fold, level).state
        rest = remesh(problem, leap.rest, level, ALONG, fold.approach)
        rows.append((fold.approach, fold.load, rest.load, energy(problem, fold) - energy(problem, rest)))
    deepest = polish(problem, pull, level).state
    return np.array(rows), np.array([-deepest.load, deepest.approach, sum(row[3] for row in rows)])


def solve(key, levels=wavy_sphere.POLISH):
    problem = wavy_sphere.Scene(*key[:5], 0.0, 0.0).problem()
    width = RELAX_WIDTH / np.sqrt(float(key[3]) * float(key[0]))
    leaps, minima = loop(problem, float(key[5]), width)
    pull = min(minima, key=lambda mark: mark.state.load)
    if any(leap.fold.state.load < pull.state.load for leap in leaps if not leap.loading):
        raise NotConverged(f"{key}: the tension is greatest at a jump, not at a minimum")
    found = [on_level(problem, leaps, pull, level) for level in levels]
    rows, wholes = np.array([f[0] for f in found]), np.array([f[1] for f in found])
    return Solved(tuple(key), ["loading" if leap.loading else "unloading" for leap in leaps],
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
    """Recompute the sample on one level and compare with the stored tables."""
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
        agrees = abs(float(value) - float(stored[name])) <= float(doubt) if doubt else (
            name.endswith("_uncertainty") or value == stored[name])
        if not agrees:
            raise ValueError(f"{where}: {name} recomputed {value}, stored {stored[name]}, "
                             f"uncertainty {doubt}")


def act(arguments):
    if arguments.list:
        for key in SCENES:
            print(" ".join(key))
    elif arguments.scene:
        show(solve(arguments.scene))
    elif arguments.sample:
        sample(STORED)
        print("sample agrees with the stored tables")
    else:
        write_all(arguments.write)


def main():
    parser, group = options(__doc__)
    group.add_argument("--list", action="store_true", help="print the scenes of the tables")
    group.add_argument("--scene", nargs=6, help="print a loop",
                       metavar=("TABOR", "AMPLITUDE", "WAVELENGTH", "RADIUS", "OUTER", "PRELOAD"))
    return run(act, parser.parse_args(), NotConverged)


if __name__ == "__main__":
    sys.exit(main())
