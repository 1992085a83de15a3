#!/usr/bin/python3
"""Tests the error estimates of the solver: solves random scenes with a loose and a tight tolerance, and compares.

    campaign.py --count 300 --seed 1          solve and compare, on all cores
    campaign.py --scenes 17,40-44             only these of the drawn scenes
    campaign.py --general                     scenes of any law, profile, waves and coupling
    campaign.py --reference                   the scenes of the reference tables, against these tables

Prints how often the stated errors hold and how much too large they are, and each violation with the commands that
repeat it. Solutions are kept, so that an interrupted campaign can be continued. Exit code: 0 no violation, 1 a
violation, 2 bad usage, 3 nothing could be compared, 4 a file cannot be written, 130 interrupted."""

import collections
import sys

import compare
import draw
import options
import reference
import solve
import table

def arguments(args):
    parser = options.parser_of(__doc__, "estimates.jsonl", 300, (1e-4, 1e-7))
    parser.add_argument("--reference", action="store_true", help="the scenes of the reference tables, against these")
    parser.add_argument("--general", action="store_true", help="scenes of any law, profile, waves and coupling")
    options.add_ranges(parser, {"tabor": (0.01, 10.0), "radius": (30.0, 1000.0), "wavelength": (0.4, 6.0),
                                "amplitude": (0.003, 0.5), "outer": (0.25, 1.0)},
                       {"smooth": 0.2, "cut": 0.5, "at-radius": 0.5, "any-law": 0.5})
    wanted = parser.parse_args(args)
    if wanted.tight >= wanted.loose and not wanted.reference:
        parser.error(f"--tight {wanted.tight:g}: expected less than --loose {wanted.loose:g}")
    return wanted


class Task:
    """A scene, and the solutions that are compared."""

    def __init__(self, name, scene, truth=None):
        self.name, self.scene, self.truth = name, scene, truth
        self.loose, self.tight = None, truth

    def solve(self, journal, wanted):
        self.loose = journal.solution(self.scene, wanted.loose)
        if not self.truth:
            self.tight = journal.solution(self.scene, wanted.tight)

    @property
    def is_comparable(self):
        return all(one["status"] == "ok" and one.get("pull_off") for one in (self.loose, self.tight))


def tasks_of(wanted):
    if wanted.reference:
        return [Task(f"table {i}", scene, truth) for i, (scene, truth) in enumerate(reference.documents())]
    def drawn(k):
        return draw.general_scene(wanted.seed, k) if wanted.general else draw.scene(wanted.seed, k, vars(wanted))

    return [Task(f"scene {k}", drawn(k))
            for k in (wanted.scenes if wanted.scenes is not None else range(wanted.count))]


def statuses(tasks):
    """How many solves ended with each status, if one failed."""
    count = collections.Counter()
    for task in tasks:
        for side, solution in (("loose", task.loose), ("tight", task.tight)):
            if solution["status"] != "ok":
                count[f"{side} {solution['status']}"] += 1
            elif not solution.get("pull_off"):
                count[f"{side} without a pull-off"] += 1
    return ", ".join(f"{words} {n}" for words, n in sorted(count.items()))


def ends(tasks):
    """How many traces ended for each cause, if the program states it."""
    count = collections.Counter((task.loose.get("ended") or {}).get("why", "?") for task in tasks)
    return "" if set(count) == {"?"} else ", ".join(f"{why} {n}" for why, n in count.most_common())


def tell_violation(task, comparison, wanted):
    print(f"violated: {task.name}")
    for text in comparison.violations:
        print(f"  {text}")
    print(f"  {solve.command(task.scene, wanted.loose)}")
    if not task.truth:
        print(f"  {solve.command(task.scene, wanted.tight)}")


def report(tasks, wanted):
    """Prints the table and the violations, and returns the exit code."""
    crashed = [task for task in tasks if "crashed" in (task.loose["status"], task.tight["status"])]
    compared = [(task, compare.compare(task.loose, task.tight)) for task in tasks if task.is_comparable]
    against = "the reference tables" if wanted.reference else f"{wanted.tight:g}"
    drawn = "" if wanted.reference else f" by seed {wanted.seed}"
    print(f"{len(tasks)} scenes{drawn}, {wanted.loose:g} against {against}: {len(compared)} compared")
    for text in (statuses(tasks), ends(tasks)):
        if text:
            print(f"ended: {text}")
    if compared:
        print("\n".join(table.lines([comparison for _, comparison in compared])))
    violated = [(task, comparison) for task, comparison in compared if comparison.violations]
    for task, comparison in violated:
        tell_violation(task, comparison, wanted)
    for task in crashed:
        worse = wanted.loose if task.loose["status"] == "crashed" else wanted.tight
        one = task.loose if worse == wanted.loose else task.tight
        solve.tell_crashed(task.name, one, solve.command(task.scene, worse))
    return solve.exit_code(len(violated), len(compared), crashed)


def main(args):
    wanted = arguments(args)
    return solve.campaign("campaign.py", "estimates.jsonl", tasks_of(wanted), wanted, report)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
