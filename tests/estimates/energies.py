#!/usr/bin/python3
"""Tests the stated errors of energies: those of special points, of the points of a curve and of a loop, the energies lost
in jumps, and the work. Random scenes are solved with a loose and a tight tolerance, and compared.

    energies.py --count 60 --seed 1           solve and compare, on all cores
    energies.py --general --count 60          scenes of any law, profile, waves and coupling
    energies.py --steep --count 60            general scenes whose profiles and laws are steep
    energies.py --tables --count 60           general scenes whose profile is a table with kinks or undulations
    energies.py --springs --count 60          such scenes (general ones if no kind is given), each through a spring

Forces, folds and extrema are compared, too, as by campaign.py. Prints how often the stated errors hold and how much too
large they are, each violation with the commands that repeat it, and the solves without a result by their status.
Solutions are kept, so that an interrupted campaign can be continued. Exit code: 0 no violation, 1 a violation, 2 bad
usage, 3 nothing could be compared, 4 a file cannot be written, 130 interrupted."""

import math
import os
import sys

import compare
import draw
import options
import solve
import steps
import table

ORDER = ("fold energy", "extremum energy", "curve energy", "loop energy", "lost in a jump", "lost in a loop", "work",
         *table.ORDER)
STARTS = 8           # parts of a segment in which the nearest place is looked for
CANDIDATES = 3       # segments of a curve on which it is looked for
MOST = 300           # points of a curve that are compared, evenly chosen
MISS = 1e-8          # least distance of a curve from its cubics that the program asks for
STIFFNESS = (1e-6, 1e4)          # of the springs, in units of pi w R/epsilon
TESTS = (*(control.name for control in steps.CONTROLS), "spring")
GOLDEN = (math.sqrt(5.0) - 1.0) / 2.0


def arguments(args):
    parser = options.parser_of(__doc__, "energies.jsonl", 60, (1e-4, 1e-7))
    parser.add_argument("--general", action="store_true", help="scenes of any law, profile, waves and coupling")
    parser.add_argument("--steep", action="store_true", help="general scenes with steep profiles and laws")
    parser.add_argument("--tables", action="store_true", help="general scenes whose profile is a table with kinks or undulations")
    parser.add_argument("--springs", action="store_true", help="scenes of these kinds, or general ones, through a spring of any stiffness")
    options.add_ranges(parser, {"tabor": (0.05, 5.0), "radius": (30.0, 200.0), "wavelength": (1.0, 6.0),
                                "amplitude": (0.003, 0.5), "outer": (0.25, 1.0)},
                       {"smooth": 0.1, "cut": 0.5, "at-radius": 0.5, "any-law": 0.4})
    return parser.parse_args(args)


class Segment:
    """The cubics of approach and load between two points of a curve, and the energy by the integral of the load."""

    def __init__(self, a, b):
        length = b["position"] - a["position"]
        self.energy = a["energy"]
        self.cubics = [self.coefficients(a[name], length * a[rate], b[name], length * b[rate])
                       for name, rate in (("approach", "approach_rate"), ("load", "load_rate"))]

    @staticmethod
    def coefficients(f0, d0, f1, d1):
        return (f0, d0, 3.0 * (f1 - f0) - 2.0 * d0 - d1, 2.0 * (f0 - f1) + d0 + d1)

    def at(self, t):
        """(approach, load) at a fraction of the segment."""
        return [sum(c * t**k for k, c in enumerate(cubic)) for cubic in self.cubics]

    def energy_at(self, t):
        approach, load = self.cubics
        return self.energy + sum(c * k * d * t**(j + k) / (j + k) for j, c in enumerate(load)
                                 for k, d in enumerate(approach) if k)

    def distance(self, point, t):
        """Of a state from a place of the segment, in the plane of approach and load."""
        approach, load = self.at(t)
        return math.hypot(approach - point["approach"], load - point["load"])

    def start(self, point):
        """(distance, place) of the nearest of some chords, which a steep segment leaves by far less than their length."""
        places = [self.at(k / STARTS) for k in range(STARTS + 1)]
        return min(self.chord(k, point, *places[k:k + 2]) for k in range(STARTS))

    @staticmethod
    def chord(k, point, begin, end):
        along = [b - a for a, b in zip(begin, end)]
        square = sum(d * d for d in along)
        offset = (point["approach"] - begin[0]) * along[0] + (point["load"] - begin[1]) * along[1]
        t = min(1.0, max(0.0, offset / square)) if square else 0.0
        distance = math.hypot(begin[0] + t * along[0] - point["approach"], begin[1] + t * along[1] - point["load"])
        return distance, (k + t) / STARTS

    def nearest(self, point):
        """The distance of a state, and where on the segment."""
        _, best = self.start(point)
        low, high = max(best - 1.0 / STARTS, 0.0), min(best + 1.0 / STARTS, 1.0)
        while high - low > 1e-9:
            first, second = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
            if self.distance(point, first) < self.distance(point, second):
                high = second
            else:
                low = first
        return self.distance(point, low), low

    @property
    def length(self):
        (begin, _), (end, _) = self.at(0.0), self.at(1.0)
        return abs(end - begin)


def energy_off(point, curve):
    """The difference of the energy of a state from that of a curve at the same approach, and the error of the latter by
    interpolation. Near the nearest place of the curve the energy changes by load times approach."""
    reach = 0.5 + 0.02 * point["position"]
    near = [i for i, other in enumerate(curve[:-1]) if abs(other["position"] - point["position"]) < reach] or range(len(curve) - 1)
    segments = [Segment(curve[i], curve[i + 1]) for i in near]
    found = []
    for segment in sorted(segments, key=lambda one: one.start(point))[:CANDIDATES]:
        distance, t = segment.nearest(point)
        moved = point["approach"] - segment.at(t)[0]
        found.append((distance, abs(point["energy"] - segment.energy_at(t) - point["load"] * moved),
                      MISS * (1.0 + segment.length)))
    return min(found)[1:]


class Task:
    """A scene, and the two solutions that are compared."""

    def __init__(self, name, scene):
        # through a spring the traces begin where they need to, each at its own position
        self.name, self.scene = name, dict(scene, want="hysteresis" if "stiffness" in scene else "hysteresis,curve")
        self.solutions, self.findings = [], []
        self.broken = []     # violations that are no stated error: losses below 0, special points of one solution alone

    def solve(self, journal, wanted):
        self.solutions = [journal.solution(self.scene, tolerance) for tolerance in (wanted.loose, wanted.tight)]
        if all(one["status"] == "ok" and one.get("hysteresis") for one in self.solutions):
            loose, tight = self.solutions
            self.add_special_points(loose, tight)
            self.add_forces(loose, tight)
            if tight.get("curve"):
                self.add_curve(loose, tight)
            for name in TESTS:
                loops = [one["hysteresis"].get(name) for one in self.solutions]
                if all(loops):
                    self.add_loop(name, *loops)

    def add(self, quantity, where, stated, difference, own):
        if stated > 0.0:
            self.findings.append(compare.Finding(quantity, where, stated, difference, own + compare.ROUNDING))

    def add_forces(self, loose, tight):
        """Forces, folds and extrema, where a pull-off was found."""
        if all(one.get("pull_off") for one in (loose, tight)):
            found = compare.compare(loose, tight)
            self.findings += found.findings
            self.broken += [f"{words} {text}" for words, texts in (("missing", found.missing), ("added", found.added))
                              for text in texts]

    def add_special_points(self, loose, tight):
        for name, pairs in zip(("fold", "extremum"), compare.common(loose, tight)):
            for ours, theirs in pairs:
                if ours and theirs:
                    own = compare.value(theirs, "energy_error_estimate")
                    self.add(f"{name} energy", f" ({compare.text_of(ours)})", compare.value(ours, "energy_error_estimate"),
                             abs(ours["energy"] - theirs["energy"]), 0.0 if math.isnan(own) else own)

    def add_curve(self, loose, tight):
        """The points that both traces cover; the greatest difference counts."""
        low, high = (max(one["curve"][0]["approach"] for one in (loose, tight)), min(one["end"] for one in (loose, tight)))
        own = max(compare.value(point, "energy_error_estimate") for point in tight["curve"])
        for point in loose["curve"][::-(-len(loose["curve"]) // MOST)]:
            if low <= point["approach"] <= high:
                off, miss = energy_off(point, tight["curve"])
                self.add("curve energy", f" (at approach {point['approach']:.7g})",
                         compare.value(point, "energy_error_estimate"), off, own + miss)

    def add_loop(self, name, ours, theirs):
        for jump in ours["jumps"]:
            if compare.value(jump, "energy_lost") < -compare.value(jump, "energy_lost_error_estimate"):
                self.broken.append(f"{jump['energy_lost']:.3g} lost in jump {jump['label']} ({name}), a gain beyond the "
                                     f"stated {jump['energy_lost_error_estimate']:.3g}")
        if len(ours["jumps"]) != len(theirs["jumps"]) or not ours["jumps"]:
            return
        pairs = [("lost in a loop", "energy_lost", ours, theirs), ("work", "work", ours, theirs)]
        pairs += [("lost in a jump", "energy_lost", *jumps) for jumps in zip(ours["jumps"], theirs["jumps"])]
        for quantity, key, one, other in pairs:
            error = f"{key}_error_estimate"
            if None not in (one[key], other[key]):
                self.add(quantity, f" ({name})", compare.value(one, error), abs(one[key] - other[key]),
                         compare.value(other, error))
        if not self.solutions[1].get("curve"):
            return
        states = [jump[end] for jump in ours["jumps"] for end in ("before", "after")] + [ours["preload"]]
        off, miss = max(energy_off(state, self.solutions[1]["curve"]) for state in states if state["approach"] is not None)
        self.add("loop energy", f" ({name})", compare.value(ours, "energy_error_estimate"), off,
                 miss + compare.value(theirs, "energy_error_estimate"))

    @property
    def crashed(self):
        return [one for one in self.solutions if one["status"] == "crashed"]

    @property
    def violations(self):
        return self.broken + [f"{f.quantity}: stated {f.stated:.3g}, off by {f.difference:.3g}{f.where}"
                                for f in self.findings if f.verdict == "violated"]


def through_a_spring(scene, seed, k):
    """A general scene with a spring."""
    return dict(scene, stiffness=draw.between(STIFFNESS, draw.uniform(seed, k, "stiffness")))


def drawn(wanted, k):
    """Scene k of the kind that is wanted."""
    if wanted.tables:
        scene = draw.table_scene(wanted.seed, k, os.path.join(wanted.build, "tables"))
    elif wanted.steep:
        scene = draw.steep_scene(wanted.seed, k)
    elif wanted.general or wanted.springs:
        scene = draw.general_scene(wanted.seed, k)
    else:
        scene = draw.scene(wanted.seed, k, vars(wanted))
    return through_a_spring(scene, wanted.seed, k) if wanted.springs else scene


def tasks_of(wanted):
    return [Task(f"scene {k}", drawn(wanted, k))
            for k in (wanted.scenes if wanted.scenes is not None else range(wanted.count))]


def tell_unsolved(tasks, wanted):
    """How many solves ended without a result, for each reason, and one command that repeats it."""
    reasons = {}
    for task in tasks:
        for tolerance, one in zip((wanted.loose, wanted.tight), task.solutions):
            if one["status"] not in ("ok", "crashed"):
                reasons.setdefault(f"{one['status']} at {tolerance:g}", []).append((task, tolerance))
    for reason, found in sorted(reasons.items()):
        print("\n  ".join([f"unsolved: {reason}: {len(found)}", *(solve.command(task.scene, tolerance)
                                                                  for task, tolerance in found)]))


def report(tasks, wanted):
    """Prints the table and the violations, and returns the exit code."""
    compared = [task for task in tasks if task.findings]
    print(f"{len(tasks)} scenes by seed {wanted.seed}, {wanted.loose:g} against {wanted.tight:g}: {len(compared)} compared")
    print("\n".join(table.grid([finding for task in tasks for finding in task.findings], ORDER)))
    violated = [task for task in tasks if task.violations]
    for task in violated:
        print("\n  ".join([f"violated: {task.name}", *task.violations, solve.command(task.scene, wanted.loose)]))
    tell_unsolved(tasks, wanted)
    crashed = [task for task in tasks if task.crashed]
    for task in crashed:
        solve.tell_crashed(task.name, task.crashed[0], solve.command(task.scene, wanted.loose))
    return solve.exit_code(len(violated), len(compared), crashed)


def main(args):
    wanted = arguments(args)
    return solve.campaign("energies.py", "energies.jsonl", tasks_of(wanted), wanted, report)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
