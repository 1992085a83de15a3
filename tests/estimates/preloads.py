#!/usr/bin/env python3
"""What the choice of a preload changes: random scenes, each pressed to several loads and to any.

    python3 tests/estimates/preloads.py --count 1000 --seed 1 build/src/cli/pulloff

Prints for each rule how many scenes would be pulled off with more after a harder preload, of how many it is known that
none gives more, and the work; and of all solves, how often the deepest minimum of the load is not what a test at given
approach measures. Solutions are kept in a journal, so that an interrupted campaign goes on."""

import argparse
import statistics
import sys
from concurrent.futures import ThreadPoolExecutor

import draw
from solve import Journal

RANGES = {"tabor": (0.05, 5), "radius": (20, 300), "wavelength": (0.4, 6), "amplitude": (1e-3, 0.5), "outer": (0.25, 1),
          "smooth": 0, "cut": 0.5, "at_radius": 1}
LOADS = (0, 0.5, 1, 1.5, 2, 3, 5)
ANY = {"preload": "inf"}
TOLERANCE = 1e-4
MORE = 0.02        # by which a pull-off is said to be more


def scenes(seed, count):
    return [draw.scene(seed, index, RANGES) for index in range(count)]


def is_unmeasured(solution):
    """Whether no preload so far gives the deepest minimum."""
    return solution["pull_off"]["preload"]["approach"] is None


def points(solution):
    return solution["work"]["points"]


def row(name, found, beside):
    """One rule: its solutions, and those at any preload."""
    both = [(one, other) for one, other in zip(found, beside) if one["status"] == other["status"] == "ok"]
    forces = [(one["pull_off"]["force"], other["pull_off_any"]["force"]) for one, other in both]
    ratios = [points(one) / max(1, points(other)) for one, other in both]
    return (f"{name:8}{len(both):8}{sum(f < (1 - MORE) * most for f, most in forces):8}"
            f"{sum(f < 0.5 * most for f, most in forces):8}"
            f"{sum(one['pull_off_any']['complete'] for one, _ in both):10}"
            f"{sum(is_unmeasured(one) for one, _ in both):12}"
            f"{statistics.median(points(one) for one, _ in both):10.0f}{sum(points(one) for one, _ in both):10}"
            f"{statistics.median(ratios):8.2f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--time-limit", type=float, default=20)
    parser.add_argument("--journal", default="build/preloads.jsonl")
    asked = parser.parse_args()
    journal = Journal(asked.journal, asked.program, asked.time_limit)
    drawn = scenes(asked.seed, asked.count)
    rules = {**{f"W = {load:g}": {"preload-load": load} for load in LOADS}, "any": ANY}
    solutions = {}
    with ThreadPoolExecutor(asked.jobs) as pool:
        for name, flags in rules.items():
            solutions[name] = list(pool.map(lambda scene, flags=flags: journal.solution({**scene, **flags}, TOLERANCE),
                                            drawn))
            print(f"{name}: {len(drawn)} scenes", file=sys.stderr)
    journal.close()
    print(f"{'pressed':8}{'solved':>8}{'> 2 %':>8}{'> twice':>8}{'complete':>10}{'unmeasured':>12}{'points':>10}"
          f"{'sum':>10}{'of any':>8}")
    for name, found in solutions.items():
        print(row(name, found, solutions["any"]))


if __name__ == "__main__":
    main()
