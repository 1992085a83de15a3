#!/usr/bin/python3
"""Whether the errors that the solver states hold: solves scenes drawn at random loosely and tightly, and compares.

    campaign.py --count 300 --seed 1          solve and compare, on all cores
    campaign.py --scenes 17,40-44             only these of the drawn scenes
    campaign.py --reference                   the scenes of the reference tables, against these tables

Prints how often the stated errors hold and how much too large they are, and each violation with the commands that
repeat it. What is solved is kept, and an interrupted campaign goes on. Exit code: 0 no violation, 1 a violation,
2 bad usage, 3 nothing could be compared, 4 a file cannot be written, 130 interrupted."""

import argparse
import collections
import concurrent.futures
import os
import sys
import time

import compare
import draw
import reference
import solve
import table

# Of the reference tables some are of 1e-10: looser is what they can judge.
BETWEEN = "LOW:HIGH"


def span(text):
    try:
        low, high = map(float, text.split(":"))
    except ValueError as error:
        raise argparse.ArgumentTypeError(f"{text} is no range: expected {BETWEEN}, two numbers") from error
    if not 0 < low <= high < float("inf"):
        raise argparse.ArgumentTypeError(f"{text} is no range: expected {BETWEEN} with 0 < LOW <= HIGH")
    return low, high


def share(text):
    if not 0 <= float(text) <= 1:
        raise argparse.ArgumentTypeError(f"{text} is no share: expected a number from 0 to 1")
    return float(text)


def tolerance(text):
    if not 1e-10 <= float(text) <= 1e-2:
        raise argparse.ArgumentTypeError(f"{text} is no tolerance: expected a number from 1e-10 to 1e-2")
    return float(text)


def numbers(text):
    """Numbers of scenes: "3,7-9"."""
    found = []
    for part in text.split(","):
        first, _, last = part.partition("-")
        if not first.isdigit() or not (last or first).isdigit():
            raise argparse.ArgumentTypeError(f"{text} are no scenes: expected numbers and ranges, as 3,7-9")
        found.extend(range(int(first), int(last or first) + 1))
    return found


def arguments(args):
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0],
                                     formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("--build", default="build", metavar="DIR", help="the build folder")
    parser.add_argument("--program", metavar="FILE", help="the program (default: that of the build folder)")
    parser.add_argument("--journal", metavar="FILE", help="where solutions are kept (default: BUILD/estimates.jsonl)")
    parser.add_argument("--fresh", action="store_true", help="solve everything anew")
    parser.add_argument("--jobs", type=int, default=0, metavar="N", help="solves at a time; 0: as many as cores")
    parser.add_argument("--seed", type=int, default=1, metavar="N", help="of the scenes")
    parser.add_argument("--count", type=int, default=300, metavar="N", help="how many scenes are drawn")
    parser.add_argument("--scenes", type=numbers, metavar="LIST", help="only these of the drawn scenes, as 3,7-9")
    parser.add_argument("--reference", action="store_true", help="the scenes of the reference tables, against these")
    parser.add_argument("--loose", type=tolerance, default=1e-4, metavar="T", help="tolerance whose errors are judged")
    parser.add_argument("--tight", type=tolerance, default=1e-7, metavar="T", help="tolerance they are judged by")
    parser.add_argument("--time-limit", type=float, default=120.0, metavar="S", help="processor seconds of one solve")
    parser.add_argument("--quiet", action="store_true", help="no progress")
    ranges = parser.add_argument_group("ranges of the scenes, each value uniform in its logarithm")
    for name, default, what in (("tabor", (0.01, 10.0), "Tabor parameter"), ("radius", (30.0, 1000.0), "R, in epsilon"),
                                ("wavelength", (0.4, 6.0), "in units of sqrt(R epsilon)"),
                                ("amplitude", (0.003, 0.5), "in units of the wavelength"),
                                ("outer", (0.25, 1.0), "outer radius where it is not R, in units of R")):
        ranges.add_argument(f"--{name}", type=span, default=default, metavar=BETWEEN, help=what)
    for name, default, what in (("smooth", 0.2, "share of scenes without waves"),
                                ("cut", 0.5, "share of surfaces that end"),
                                ("at-radius", 0.5, "share of these that end at R")):
        ranges.add_argument(f"--{name}", type=share, default=default, metavar="SHARE", help=what)
    wanted = parser.parse_args(args)
    if wanted.tight >= wanted.loose and not wanted.reference:
        parser.error(f"--tight {wanted.tight:g}: expected less than --loose {wanted.loose:g}")
    return wanted


class Task:
    """A scene, and the solutions that are compared."""

    def __init__(self, name, scene, truth=None):
        self.name, self.scene, self.truth = name, scene, truth
        self.loose, self.tight = None, truth

    @property
    def is_comparable(self):
        return all(one["status"] == "ok" and one.get("pull_off") for one in (self.loose, self.tight))


def tasks_of(wanted):
    if wanted.reference:
        return [Task(f"table {i}", scene, truth) for i, (scene, truth) in enumerate(reference.documents())]
    return [Task(f"scene {k}", draw.scene(wanted.seed, k, vars(wanted)))
            for k in (wanted.scenes if wanted.scenes is not None else range(wanted.count))]


def run(tasks, journal, wanted):
    """Solves what is not in the journal."""
    begin, done = time.monotonic(), 0

    def one(task):
        task.loose = journal.solution(task.scene, wanted.loose)
        if not task.truth:
            task.tight = journal.solution(task.scene, wanted.tight)

    pool = concurrent.futures.ThreadPoolExecutor(wanted.jobs or len(os.sched_getaffinity(0)))
    try:
        for future in concurrent.futures.as_completed([pool.submit(one, task) for task in tasks]):
            future.result()
            done += 1
            if not wanted.quiet:
                print(f"{done}/{len(tasks)} scenes, {time.monotonic() - begin:.0f} s elapsed", file=sys.stderr)
    finally:
        pool.shutdown(cancel_futures=True)


def statuses(tasks):
    """How many solves ended how, where one did not end well."""
    count = collections.Counter()
    for task in tasks:
        for side, solution in (("loose", task.loose), ("tight", task.tight)):
            if solution["status"] != "ok":
                count[f"{side} {solution['status']}"] += 1
            elif not solution.get("pull_off"):
                count[f"{side} without a pull-off"] += 1
    return ", ".join(f"{words} {n}" for words, n in sorted(count.items()))


def ends(tasks):
    """Why the traces ended, where the program says it."""
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
    """The table and the violations; the exit code."""
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
        print(f"crashed: {task.name}: {one['reason']}\n  {solve.command(task.scene, worse)}")
    print(f"{len(violated)} of {len(compared)} scenes with a violation")
    if violated or crashed:
        return 1
    return 0 if compared else 3


def main(args):
    wanted = arguments(args)
    program = wanted.program or os.path.join(wanted.build, "src", "cli", "pulloff")
    path = wanted.journal or os.path.join(wanted.build, "estimates.jsonl")
    tasks = tasks_of(wanted)
    try:
        journal = solve.Journal(path, program, wanted.time_limit, wanted.fresh)
        try:
            run(tasks, journal, wanted)
        finally:
            journal.close()
    except OSError as error:
        print(f"campaign.py: {error}", file=sys.stderr)
        return 4
    except KeyboardInterrupt:
        print(f"campaign.py: interrupted; what was solved is kept in {path}", file=sys.stderr)
        return 130
    return report(tasks, wanted)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
