#!/usr/bin/env python3
"""The pull-off of wavy spheres as a function of the preload: the steps of the staircase.

Loading follows the stable equilibria from far out and jumps where they end (stable_paths.py). A test
that is reversed within one piece of loading unloads through the lower states of that piece, and jumps
from its lower end. All tests of a piece have these jumps in common, so each piece is unloaded once. A
test measures the greatest tension on its way, including that at the reversal.

    wavy_staircase.py --list                            the scenes of the tables
    wavy_staircase.py --scene 3 10.15 50 50 inf 30      steps up to a preload, at given approach
    wavy_staircase.py --scene 3 10.15 50 50 inf 10 --load   up to a load, in load control
    wavy_staircase.py --sample                          recompute a staircase on one level, compare
    wavy_staircase.py --write [DIR]                     regenerate the tables (about an hour)
"""

import sys
from dataclasses import dataclass, field

import numpy as np
from scipy.optimize import brentq

import wavy_sphere
from branch import APPROACH, LOAD, TRACE, NotConverged, remesh, start
from command_line import act_on_scenes, notes, options, run
from converged import BOUND_IN_WORDS, SAFETY
from landmarks import between, polish
from stable_paths import ALONG, FAR, leap, leap_on_level, piece, relax
from tables import STORED_FLOOR, bound, number, read_table, write_table
from wavy_loops import compare

SAME = 1e-6               # folds whose approaches and loads differ by less are the same
CLEAR = 2.0               # least gap of separated surfaces

KEYS = "tabor amplitude wavelength radius outer_radius complete_to".split()
SCENES = {
    APPROACH: [("3", "10.15", "50", "50", "inf", "30"), ("2.911", "7.784", "35.18", "56.7", "inf", "30"),
               ("4", "0.4", "10", "100", "100", "12"), ("4", "3", "10", "100", "100", "6"),
               ("1", "1", "20", "100", "100", "12"), ("2.385", "0.37", "13.7", "61.3", "61.3", "6"),
               ("3", "1", "20", "100", "inf", "15")],
    LOAD: [("3", "10.15", "50", "50", "inf", "5"), ("2.911", "7.784", "35.18", "56.7", "inf", "10"),
           ("1", "1", "20", "100", "100", "10"), ("3", "1", "20", "100", "inf", "3")],
}
SAMPLE = {LOAD: [("1", "1", "20", "100", "100", "10")]}
DATE = "2026-11-22"


# Places on a path, on the mesh of the walk. at(problem, level) gives the state on another level.
@dataclass(frozen=True)
class Special:
    """A fold or an extremum of the load."""
    mark: object

    @property
    def state(self):
        return self.mark.state

    def at(self, problem, level):
        return polish(problem, self.mark, level).state


@dataclass(frozen=True)
class Landing:
    """The state of rest after a jump."""
    jump: object
    component: int

    @property
    def state(self):
        return self.jump.rest

    def at(self, problem, level):
        left = polish(problem, self.jump.fold, level).state
        return remesh(problem, self.jump.rest, level, ALONG[self.component], left.y[self.component])


@dataclass(frozen=True)
class Apart:
    """The beginning of loading in load control: far apart, without load."""
    approach: float = -np.inf
    load: float = 0.0

    def at(self, problem, level):
        return self


@dataclass(frozen=True)
class Level:
    """A state with the same load as another place."""
    state: object
    other: object

    def at(self, problem, level):
        return remesh(problem, self.state, level, ALONG[LOAD], self.other.at(problem, level).load)


@dataclass
class Step:
    """A measured pull-off: the place of the greatest tension, the preload up to which it is measured (None:
    not reached), and its cycles: the preload at which each begins, and the jumps of a test reversed there."""
    pull: object
    cycles: list
    until: object = None

    @property
    def begin(self):
        return self.cycles[0][0]


@dataclass
class Way:
    """The unloading from a place: its jumps, and the places where the tension may be greatest."""
    jumps: list = field(default_factory=list)
    places: list = field(default_factory=list)


class Climb:
    """The loading of a scene up to `end`, and the unloading from each piece of it."""

    def __init__(self, scene, component, end):
        self.scene, self.problem = scene, scene.problem()
        self.component, self.end = component, end
        self.up = []                    # jumps of loading
        self.ways = []                  # (fold, Way) of unloading, so that each jump is computed once

    def down(self, state):
        """The unloading from a stable state."""
        apart = FAR if self.component == APPROACH else -np.inf
        here = piece(self.problem, state, -1, apart, self.component)
        places = [Special(mark) for mark in here.passed if mark.kind == "minimum"]
        if here.fold is None:
            if here.states[-1].gap.min() < CLEAR:
                raise NotConverged(f"{self.scene.key}: not apart at approach {FAR}")
            return Way([], places)
        if self.component == LOAD:
            places.append(Special(here.fold))
        beyond = self.down_from(here.fold)
        return Way(beyond.jumps, places + beyond.places)

    def down_from(self, fold):
        """The unloading from a fold at which stable states end."""
        for known, way in self.ways:
            if same(known.state, fold.state):
                return way
        jump = leap(self.scene, fold, False, self.component)
        beyond = Way()
        if jump.rest is not None:
            beyond = self.down(jump.rest)
            beyond.places.insert(0, Landing(jump, self.component))
        way = Way([jump] + beyond.jumps, beyond.places)
        self.ways.append((fold, way))
        return way

    def pieces(self):
        """The pieces of loading in order: the place where each begins, its states, and the unloading from
        the first state."""
        begin, way = None, Way()
        state = start(self.problem, FAR, TRACE)
        if self.component == LOAD:
            state = relax(self.scene, state, LOAD, 0.0, 0.0)
            begin, way = Apart(), self.down(state)
        while True:
            here = piece(self.problem, state, 1, self.end, self.component)
            yield begin, here, way
            if here.fold is None:
                return
            self.up.append(leap(self.scene, here.fold, True, self.component))
            begin, state = Special(here.fold), self.up[-1].rest
            way = self.down(state)


def same(one, other):
    """Whether two states have the same approach and load."""
    return np.abs(one.y - other.y)[:2].max() < SAME


def crossing(problem, states, place):
    """The first point along the states at which the load falls below that at a place."""
    load = place.state.load
    for a, b in zip(states, states[1:]):
        if a.load >= load > b.load:
            go, length = between(problem, a, b)
            return Level(go(brentq(lambda d: go(d).load - load, 0.0, length)), place)
    raise NotConverged(f"the load does not fall below {load}")


def staircase(scene, component, end):
    """The steps in order of their preload. At the beginning of a piece of loading a step may begin because of
    its unloading. Other steps begin where loading passes a minimum of the load that is the least so far."""
    climb, steps, current = Climb(scene, component, end), [], None
    for begin, here, way in climb.pieces():
        jumps, first = climb.up + way.jumps, here.states[0]
        best = min(way.places, key=lambda place: place.state.load, default=None)
        if best and best.state.load > first.load:
            best = None                 # the tension at the reversal is greater
        if current and not (best and same(current.pull.state, best.state)):
            current.until, current = begin, None
        if best and not current:
            current = Step(best, [])
            steps.append(current)
        if current:
            current.cycles.append((begin, jumps))
        below = first.approach
        for mark in here.passed + [None]:
            last = mark.state if mark else here.states[-1]
            if current and last.load < current.pull.state.load:
                part = [s for s in here.states if below <= s.approach < last.approach]
                current.until, current = crossing(climb.problem, part + [last], current.pull), None
            if not current and mark and mark.kind == "minimum":
                current = Step(Special(mark), [(Special(mark), jumps)])
                steps.append(current)
            below = last.approach
    return steps


@dataclass(frozen=True)
class Solved:
    """The steps or the cycles of a scene: names of the columns after the keys, labels of each row, values and
    their spread between levels."""
    names: tuple
    labels: list
    values: np.ndarray
    spread: np.ndarray

    def columns(self):
        return [*self.names, *(name + "_uncertainty" for name in self.names)]

    def rows(self):
        for label, values, spread in zip(self.labels, self.values, self.spread):
            yield [*label, *map(number, values), *(bound(SAFETY * s) for s in spread)]


def on_level(problem, steps, component, level):
    """The rows of steps and, at given approach, the rows of cycles."""
    known = {}

    def once(key, solve_it):
        if id(key) not in known:
            known[id(key)] = solve_it(key)
        return known[id(key)]

    def at(place):
        return once(place, lambda one: one.at(problem, level))

    def lost(jumps):
        return sum(once(jump, lambda one: leap_on_level(problem, one, level)[-1]) for jump in jumps)

    rows, cycles = [], []
    for step in steps:
        begin, pull = at(step.begin), at(step.pull)
        until = (at(step.until).approach, at(step.until).load) if step.until else (np.inf, np.inf)
        rows.append([begin.approach, begin.load, *until, -pull.load, pull.approach])
        if component == APPROACH:
            cycles += [[at(place).approach, at(place).load, lost(jumps)] for place, jumps in step.cycles]
            rows[-1].append(lost(step.cycles[0][1]))
    return np.array(rows), np.array(cycles)


def differences(found):
    """The values on the last level, and the differences of the others from them."""
    finite = [np.where(np.isfinite(values), values, 0.0) for values in found]
    return found[-1], np.max([np.abs(values - finite[-1]) for values in finite], axis=0)


def solve(key, component, levels=wavy_sphere.POLISH):
    """The table of the steps of a scene and, at given approach, that of its cycles."""
    scene = wavy_sphere.Scene(*key[:5], 0.0, 0.0)
    steps = staircase(scene, component, float(key[5]))
    found = [on_level(scene.problem(), steps, component, level) for level in levels]
    ends = "from_approach from_load until_approach until_load force approach".split()
    if component == LOAD:
        return [Solved(ends, numbered(len(steps)), *differences([rows for rows, _ in found]))]
    labels = [[str(i + 1), str(k + 1)] for i, step in enumerate(steps) for k in range(len(step.cycles))]
    return [Solved(ends + ["energy_lost"], numbered(len(steps)), *differences([rows for rows, _ in found])),
            Solved("from_approach from_load energy_lost".split(), labels,
                   *differences([cycles for _, cycles in found]))]


def numbered(count):
    return [[str(i + 1)] for i in range(count)]


PRESSED = ("Surfaces pressed together slowly from far out, at given approach, and pulled apart again; where an "
           "equilibrium ends they come to rest at another, with less energy")
TABLES = {
    APPROACH: [
        ("wavy_staircases.csv", ["index"],
         "the pull-off (greatest tension of the whole unloading, the reversal included) that a test at given approach "
         "measures, by the greatest approach of its loading. " + PRESSED + ". A step begins at from_approach, "
         "from_load (the state before a jump of loading, or a minimum of the load that loading passes) and holds up "
         "to until_approach, until_load (inf: beyond complete_to). Between there and the next step the tension at "
         "reversal is the greatest. energy_lost: in all jumps of the test that reverses just beyond from_approach. "
         "complete_to: the approach up to which loading was followed"),
        ("wavy_cycles.csv", ["step", "index"],
         "the energy lost in all jumps of a test at given approach, by the greatest approach of its loading. "
         + PRESSED + ". A cycle begins at from_approach, from_load; the next one has other jumps. step: the row of "
         "wavy_staircases.csv, whose pull-off the cycle has; complete_to: as there")],
    LOAD: [
        ("wavy_staircases_load.csv", ["index"],
         "the pull-off that a test at given load measures, by the greatest load of its loading. Surfaces that come "
         "together under no load, are pressed slowly and pulled until they part; where an equilibrium ends they come "
         "to rest at another under the same load. A step begins at from_load, from_approach (the state before a jump "
         "of loading; at load 0 apart, -inf) and holds up to until_load, until_approach (inf: beyond complete_to). "
         "complete_to: the load up to which loading was followed")],
}


def header(component, what, solved):
    largest = np.concatenate([one.spread for one in solved]).max(axis=0)
    made = wavy_sphere.header(
        what, BOUND_IN_WORDS,
        f"every value solved on three levels ({wavy_sphere.levels_in_words()}); differences from the third are at "
        "most: " + ", ".join(f"{name} {max(value, STORED_FLOOR / SAFETY):.1e}"
                             for name, value in zip(solved[0].names, largest)))
    made["method"] = (
        "Copson (double Abel) form of the elastic operator on adaptive spectral panels, to the cut or with a mapped "
        "panel to infinity; Newton; stable equilibria followed by arclength to where they end, and from there "
        "relaxation in time against a local damping at that "
        + ("approach; energies of the states themselves, not integrals along a branch" if component == APPROACH
           else "load, the approach being an unknown of the relaxation") + "; shares no code or method with src/")
    if component == APPROACH:
        made["units"] += "; energy_lost: drop of the potential energy, in units of pi w R epsilon"
    made.update(generator="reference/make/wavy_staircase.py",
                command="python3 reference/make/wavy_staircase.py --write", date=DATE)
    return made


def write_tables(folder, component, solved):
    """Writes the tables. `solved`: the result of solve() for each scene."""
    for place, (name, labels, what) in enumerate(TABLES[component]):
        here = [(key, tables[place]) for key, tables in solved]
        write_table(folder / name, header(component, what, [one for _, one in here]),
                    KEYS + labels + here[0][1].columns(), [[*key, *row] for key, one in here for row in one.rows()])


def write_all(folder):
    folder.mkdir(parents=True, exist_ok=True)
    note = notes()
    for component, keys in SCENES.items():
        solved = []
        for key in keys:
            solved.append((key, solve(key, component)))
            note(f"{' '.join(key)}: {len(solved[-1][1][0].values)} steps")
        write_tables(folder, component, solved)


def show(component, tables):
    for (_, labels, _), one in zip(TABLES[component], tables):
        for row in [labels + one.columns(), *one.rows()]:
            print(" ".join(row))


def sample(folder):
    """Recomputes the sample on one level and compares it with the stored tables."""
    for component, keys in SAMPLE.items():
        for key in keys:
            for (name, labels, _), one in zip(TABLES[component], solve(key, component, wavy_sphere.POLISH[1:2])):
                stored = [row for row in read_table(folder / name)[1] if tuple(row[k] for k in KEYS) == key]
                rows = list(one.rows())
                if len(rows) != len(stored):
                    raise ValueError(f"{name}, {' '.join(key)}: {len(rows)} rows, stored {len(stored)}")
                for values, row in zip(rows, stored):
                    compare(f"{name}, {' '.join(key)}", dict(zip(labels + one.columns(), values)), row)


def act(arguments):
    component = LOAD if arguments.load else APPROACH
    act_on_scenes(arguments, SCENES[component], lambda key: show(component, solve(key, component)), sample,
                  write_all)


def main():
    parser, group = options(__doc__)
    group.add_argument("--list", action="store_true", help="print the scenes of the tables")
    group.add_argument("--scene", nargs=6, help="print the steps of a scene up to an approach",
                       metavar=("TABOR", "AMPLITUDE", "WAVELENGTH", "RADIUS", "OUTER", "END"))
    parser.add_argument("--load", action="store_true", help="--list, --scene: in load control; END is a load")
    return run(act, parser.parse_args(), NotConverged)


if __name__ == "__main__":
    sys.exit(main())
