#!/usr/bin/python3
"""Counts how many random scenes of any law, profile, waves and coupling the solver solves within a time limit.

    solved.py --count 1000 --seed 1           solve on all cores, and count how the solves ended
    solved.py --scenes 17,40-44               only these of the drawn scenes

Prints the number of scenes for each status, and each scene that was not solved with its command and reason. Solutions
are kept, so that an interrupted campaign can be continued. Exit code: 0 every scene was solved, refused or ended with a
status, 1 a solve crashed, 2 bad usage, 4 a file cannot be written, 130 interrupted."""

import collections
import sys

import draw
import options
import solve


def arguments(args):
    parser = options.parser_of(__doc__, "solved.jsonl", 1000, (1e-6, 1e-6))
    parser.set_defaults(time_limit=20.0)
    return parser.parse_args(args)


class Task:
    """A scene and its solution."""

    def __init__(self, number, scene):
        self.number, self.scene, self.solution = number, scene, None

    def solve(self, journal, wanted):
        self.solution = journal.solution(self.scene, wanted.loose)


def status_of(task):
    """The status of a solve. An input that is refused has a message and no document."""
    solution = task.solution
    refused = solution["status"] == "crashed" and solution["reason"].startswith("exit code 2: ")
    return "refused" if refused else solution["status"]


def report(tasks, wanted):
    """Prints the counts and the scenes that were not solved, and returns the exit code."""
    count = collections.Counter(status_of(task) for task in tasks)
    print(f"{len(tasks)} scenes by seed {wanted.seed}, tolerance {wanted.loose:g}, at most "
          f"{wanted.time_limit:g} s of processor time each")
    for status, number in count.most_common():
        print(f"{status:20s} {number}")
    for task in tasks:
        if task.solution["status"] != "ok":
            print(f"scene {task.number}: {status_of(task)}: {task.solution.get('reason', 'no reason')}\n"
                  f"  {solve.command(task.scene, wanted.loose)}")
    return 1 if count["crashed"] else 0


def main(args):
    wanted = arguments(args)
    tasks = [Task(k, draw.general_scene(wanted.seed, k))
             for k in (wanted.scenes if wanted.scenes is not None else range(wanted.count))]
    return solve.campaign("solved.py", "solved.jsonl", tasks, wanted, report)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
