#!/usr/bin/env python3
"""Loading and unloading through a spring by relaxation in time alone: no branch is followed.

The base of the spring, at approach + load/stiffness, is moved in small steps. After each the surface comes to rest
against a local damping (stable_paths.py), the approach with it. Where the state of rest leaps, the position of the base is
halved in between until the leap is located. The equations are those of wavy_sphere.py.

    spring_loops.py --list                              the loops of the table
    spring_loops.py --scene 3 1 20 100 60 0.3 0.1       the jumps of one of them (outer radius, stiffness, preload: a load)
    spring_loops.py --sample                            recompute a loop, compare with the stored table
    spring_loops.py --write [DIR]                       regenerate the table (half an hour)
"""

import sys
from dataclasses import dataclass

import numpy as np

import wavy_sphere
from branch import Level, NotConverged, start
from command_line import act_on_scenes, notes, options, run
from stable_paths import FAR, come_to_rest, relaxation_surface
from tables import number, read_table, write_table

KEYS = "tabor amplitude wavelength radius outer_radius stiffness preload_load".split()
JUMPS = "spring_jumps.csv"
SCENES = [("2", "0", "20", "100", "40", "0.3", "0.1"), ("2", "0", "20", "100", "40", "0.05", "0.1"),
          ("3", "1", "20", "100", "60", "0.3", "0.1"), ("3", "1", "20", "100", "60", "2", "0.1")]
SAMPLE = SCENES[:1]
DATE = "2026-11-24"
STEPS = 150               # of the base from the beginning to the preload
NEAREST = 8.0             # approach up to which the panels resolve the contact edge
LEAP = 6.0                # a step in which the approach or the load moves so much more than before has a leap in it
LEAST = 2e-3              # ... and at least so much
FIRST_STEP = 1.0          # in time; it is halved where the surface moves fast
LOCATED = 1e-8            # halvings of the base end at this distance
LEVEL = Level(order=6, tail=8, tolerance=1e-8)
NAMES = "base load_before load_after energy_lost".split()
OF_PANELS = {"0": 4e-6, "1": 5e-5}  # error of a load by the amplitude: three times its change to panels of order 8; others: unknown
OF_FOLD = 1e-3            # of the load just before a leap: it differs by the root of LOCATED from that at the fold


def uncertainty(key):
    """Of the numbers of a row. An error of the load moves the base, and the energy of the spring, by its part of 1/k."""
    soft, of_panels = 1.0 + 1.0 / float(key[5]), OF_PANELS.get(key[1], np.inf)
    return dict(zip(NAMES, (of_panels * soft, OF_FOLD, 20.0 * of_panels, 5.0 * of_panels * soft)))


@dataclass(frozen=True)
class Rest:
    """A state of rest: the position of the base, the gap, the approach, the load."""
    base: float
    gap: np.ndarray
    approach: float
    load: float


class Pull:
    """A surface that is moved through a spring."""

    def __init__(self, key):
        scene = wavy_sphere.Scene(*key[:5], 0.0, 0.0)
        self.problem, self.stiffness = scene.problem(), float(key[5])
        far = start(self.problem, FAR, LEVEL)
        self.surface = relaxation_surface(scene, NEAREST, LEVEL)
        self.undeformed = self.problem.profile.gap(self.surface.u)
        elastic = far.surface.interpolate(far.gap + FAR - self.problem.profile.gap(far.surface.u), self.surface.u, 1)
        self.far = self.settle(Rest(0.0, elastic - FAR + self.undeformed, FAR, far.load),
                                       FAR + far.load / self.stiffness)

    def settle(self, rest, base):
        """The state of rest that follows `rest` when the base is moved to a position."""
        found = come_to_rest(self.problem, self.surface, (1.0, 1.0 / self.stiffness, base), rest.gap, rest.approach,
                             FIRST_STEP)
        if found is None:
            raise NotConverged("the surfaces separate")
        gap, approach = found
        return Rest(base, gap, approach, self.surface.load(self.problem.traction(gap)))

    def energy(self, rest):
        """Of surface and spring, in pi w R epsilon."""
        p = self.problem.traction(rest.gap)
        of_surface = self.surface.load(self.problem.law.energy(rest.gap)
                                       + 0.5 * p * self.problem.elastic * (self.surface.deflection @ p))
        return of_surface + 0.5 * rest.load**2 / self.stiffness

    def locate(self, before, after):
        """The states of rest on both sides of a leap between two positions of the base."""
        while abs(after.base - before.base) > LOCATED:
            middle = self.settle(before, 0.5 * (before.base + after.base))
            nearer = abs(middle.approach - before.approach) < abs(middle.approach - after.approach)
            before, after = (middle, after) if nearer else (before, middle)
        return before, after

    def move(self, rest, bases, until=np.inf):
        """Moves the base. Returns the jumps, pairs of states, and the last state, at the first load above `until`."""
        jumps, usual = [], np.inf
        for base in bases:
            following = self.settle(rest, base)
            moved = abs(following.approach - rest.approach) + abs(following.load - rest.load)
            if moved > max(LEAP * usual, LEAST):
                jumps.append(self.locate(rest, following))
                usual = np.inf
            else:
                usual = moved
            rest = following
            if rest.load > until:
                break
        return jumps, rest


def loop(key):
    """The jumps of loading and of unloading: phase, and the numbers of a row."""
    pull, preload = Pull(key), float(key[6])
    begin, soft = pull.far.base, 1.0 / pull.stiffness
    step = (20.0 + soft) / STEPS
    found, rest = pull.move(pull.far, begin + step * np.arange(1, 4 * STEPS), preload)
    left = pull.move(rest, np.arange(rest.base - step, begin - 2.0 * soft, -step))[0]
    for phase, jumps in ("loading", found), ("unloading", left):
        for before, after in jumps:
            yield phase, (before.base, before.load, after.load, pull.energy(before) - pull.energy(after))


def columns():
    return [*KEYS, "index", "phase", *NAMES, *(name + "_uncertainty" for name in NAMES)]


def rows(key):
    doubt = [f"{value:.1e}" for value in uncertainty(key).values()]
    for k, (phase, values) in enumerate(loop(key)):
        yield [*key, str(k + 1), phase, *map(number, values), *doubt]


def write_all(folder):
    folder.mkdir(parents=True, exist_ok=True)
    note, table = notes(), []
    for key in SCENES:
        table += rows(key)
        note(f"{' '.join(key)}: {sum(row[:len(KEYS)] == list(key) for row in table)} jumps")
    header = wavy_sphere.header(
        "jumps of loading and unloading through a spring, in their order, wavy sphere: the position of the base, the load "
        "before and after, the energy lost by surface and spring",
        "estimate: three times the change from panels of order 6 to 8; the distance of a state from the fold at which it is located, the order of the panels",
        "the base is halved to 1e-8; loads on panels of order 6 and 8 differ by 1.3e-6 on the smooth sphere, "
        "by 1.8e-5 on the wavy one")
    header["method"] = (
        "Copson (double Abel) form of the elastic operator on fixed spectral panels, to the cut; relaxation in time "
        "against a local damping while the base is moved slowly; no branch is followed, a jump is where the state of rest "
        "leaps; shares no code or method with src/")
    header["units"] += ("; stiffness: pi w R/epsilon; base: approach + load/stiffness, epsilon; preload_load: loading is "
                        "reversed at this load; energy_lost: pi w R epsilon")
    header.update(generator="reference/make/spring_loops.py", command="python3 reference/make/spring_loops.py --write", date=DATE)
    write_table(folder / JUMPS, header, columns(), table)


def show(key):
    for row in [columns(), *rows(tuple(key))]:
        print(" ".join(row[len(KEYS):]))


def sample(folder):
    """Recomputes the sample and compares it with the stored table."""
    stored = read_table(folder / JUMPS)[1]
    for key in SAMPLE:
        theirs = [row for row in stored if tuple(row[k] for k in KEYS) == key]
        ours = [dict(zip(columns(), row)) for row in rows(key)]
        if [row["phase"] for row in ours] != [row["phase"] for row in theirs]:
            raise ValueError(f"{' '.join(key)}: {len(ours)} jumps, stored {len(theirs)}")
        for a, b in zip(ours, theirs):
            for name, doubt in uncertainty(key).items():
                if abs(float(a[name]) - float(b[name])) > doubt:
                    raise ValueError(f"{' '.join(key)}: {name} recomputed {a[name]}, stored {b[name]}, uncertainty {doubt}")


def act(arguments):
    act_on_scenes(arguments, SCENES, show, sample, write_all)


def main():
    parser, group = options(__doc__)
    group.add_argument("--list", action="store_true", help="print the loops of the table")
    group.add_argument("--scene", nargs=7, help="print the jumps of a loop",
                       metavar=("TABOR", "AMPLITUDE", "WAVELENGTH", "RADIUS", "OUTER", "STIFFNESS", "LOAD"))
    return run(act, parser.parse_args(), NotConverged)


if __name__ == "__main__":
    sys.exit(main())
