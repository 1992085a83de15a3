#!/usr/bin/python3
"""Compares the staircase of `pulloff solve --want preload` with single loops, for random scenes.

    staircase.py --count 200                  every step of a scene against two loops, reversed just below and above it
    staircase.py --count 200 --scenes 17,40-44   only these of the drawn scenes
    staircase.py --complete --count 500       scenes in which no harder preload gives more, against a trace twice as far

Prints how often the statements hold, and each violation with the commands that repeat it. Solutions are kept, so that
an interrupted campaign can be continued. Exit code: 0 no violation, 1 a violation, 2 bad usage, 3 nothing could be
compared, 4 a file cannot be written, 130 interrupted."""

import collections
import sys

import compare
import draw
import options
import solve
import steps
import table

ORDER = ("force", "approach", "energy lost")


def arguments(args):
    parser = options.parser_of(__doc__, "staircase.jsonl", 200, (1e-4, 1e-6))
    parser.add_argument("--complete", action="store_true", help="whether no harder preload gives more")
    parser.add_argument("--most", type=int, default=6, metavar="N",
                        help="at most so many preloads of a scene are looked at on both sides, of each control")
    options.add_ranges(parser, {"tabor": (0.1, 5.0), "radius": (30.0, 100.0), "wavelength": (1.0, 6.0),
                                "amplitude": (0.003, 0.5), "outer": (0.25, 1.0)},
                       {"smooth": 0.05, "cut": 0.5, "at-radius": 0.5})
    wanted = parser.parse_args(args)
    if wanted.tight >= wanted.loose:
        parser.error(f"--tight {wanted.tight:g}: expected less than --loose {wanted.loose:g}")
    if wanted.most < 2:
        parser.error(f"--most {wanted.most}: expected 2 or more")
    return wanted


class Task:
    """A scene, its staircase, and the solutions with which it is compared: (scene with its wants, tolerance, document).
    """

    def __init__(self, name, scene):
        self.name, self.scene = name, scene
        self.staircase, self.others, self.findings, self.wrong, self.ties = None, [], [], [], 0

    def solve(self, journal, wanted):
        self.staircase = journal.solution(self.flags(), wanted.loose)
        if self.staircase["status"] == "ok" and self.staircase.get("staircase"):
            self.compare(journal, wanted)

    def flags(self, **more):
        return dict(self.scene, want="preload", **more)

    def other(self, journal, scene, tolerance):
        """Solves a scene for the comparison."""
        self.others.append((scene, tolerance, journal.solution(scene, tolerance)))
        return self.others[-1][2]

    @property
    def failed(self):
        return [one for one in [(self.flags(), None, self.staircase)] + self.others if one[2]["status"] != "ok"]

    @property
    def is_compared(self):
        return bool(self.findings)

    @property
    def violations(self):
        return [f"{f.quantity}: stated {f.stated:.3g}, off by {f.difference:.3g}{f.where}"
                for f in self.findings if f.verdict == "violated"] + self.wrong


class Steps(Task):
    """Compares every step with two loops."""

    def compare(self, journal, wanted):
        for control, place, preload in steps.loops(self.staircase, wanted.most):
            scene = dict(self.scene, want="hysteresis", **{control.flag: preload})
            loop = self.other(journal, scene, wanted.tight)
            if loop["status"] == "not_found" and steps.said(self.staircase, control, preload):
                self.wrong.append(f"no loop at {control.component} {preload:.12g}: {loop['reason']}")
            if loop["status"] == "ok" and loop.get("hysteresis"):
                beside = steps.Beside(self.staircase, loop, control, place, preload, wanted.tight)
                self.findings += beside.findings
                self.wrong += beside.wrong
                self.ties += beside.tie


class Complete(Task):
    """Compares the greatest pull-off over all preloads with a trace twice as far."""

    @property
    def is_complete(self):
        return bool((self.staircase.get("pull_off_any") or {}).get("complete"))

    def compare(self, journal, wanted):
        if not self.is_complete:
            return
        best = self.staircase["pull_off_any"]
        searched = best["searched"]["approach"]
        scene = self.flags(**{"approach-end": searched + max(abs(searched), 1.0)})
        longer = self.other(journal, scene, wanted.loose)
        if longer["status"] == "ok" and longer.get("pull_off_any"):
            more = longer["pull_off_any"]
            where = (f" (searched up to approach {searched:.7g}, {best['force']:.10g}; then {more['force']:.10g} from "
                     f"approach {more['preload']['approach']:.10g})")
            self.findings.append(compare.Finding("force", where, compare.value(best, "error_estimate"),
                                                 abs(more["force"] - best["force"]),
                                                 compare.value(more, "error_estimate")))


def tasks_of(wanted):
    kind = Complete if wanted.complete else Steps
    return [kind(f"scene {k}", draw.scene(wanted.seed, k, vars(wanted)))
            for k in (wanted.scenes if wanted.scenes is not None else range(wanted.count))]


def counts(words):
    return ", ".join(f"{n} {word}" for word, n in collections.Counter(words).most_common())


def lines(tasks, wanted):
    """The lines about all scenes together."""
    yield (f"{len(tasks)} scenes by seed {wanted.seed}, staircases at {wanted.loose:g}, "
           + ("traced twice as far" if wanted.complete else f"loops at {wanted.tight:g}")
           + f": {sum(task.is_compared for task in tasks)} compared")
    failed = [one for task in tasks for one in task.failed]
    if failed:
        yield "ended: " + counts(f"{scene['want']} {document['status']}" for scene, _, document in failed)
    if wanted.complete:
        whole = [task for task in tasks if task.staircase["status"] == "ok"]
        yield f"no harder preload gives more: said of {sum(task.is_complete for task in whole)} of {len(whole)} scenes"
        reasons = [(task.staircase.get("pull_off_any") or {}).get("because") for task in whole if not task.is_complete]
        if any(reasons):
            yield "not said: " + counts(str(reason) for reason in reasons)
        seconds = sorted(task.staircase["work"]["seconds"] for task in whole)
        if seconds:
            yield (f"seconds of a staircase: median {table.quantile(seconds, 0.5):.3g}, 90 % "
                   f"{table.quantile(seconds, 0.9):.3g}, most {seconds[-1]:.3g}")
    else:
        yield (f"steps {sum(number_of_steps(task) for task in tasks)}, loops {sum(len(task.others) for task in tasks)}, "
               f"of these {sum(task.ties for task in tasks)} with a tension at reversal as great within the errors")
    yield from table.grid([f for task in tasks for f in task.findings], ORDER[:1] if wanted.complete else ORDER)


def number_of_steps(task):
    found = task.staircase.get("staircase")
    return sum(len(found[control.name]["steps"]) for control in steps.CONTROLS) if found else 0


def tell(task, wanted):
    print(f"violated: {task.name}")
    for text in task.violations:
        print(f"  {text}")
    print(f"  {solve.command(task.flags(), wanted.loose)}")


def report(tasks, wanted):
    """Prints the table and the violations, and returns the exit code."""
    print("\n".join(lines(tasks, wanted)))
    violated = [task for task in tasks if task.violations]
    for task in violated:
        tell(task, wanted)
    crashed = [(task, *one) for task in tasks for one in task.failed if one[2]["status"] == "crashed"]
    for task, scene, tolerance, document in crashed:
        solve.tell_crashed(task.name, document, solve.command(scene, tolerance or wanted.loose))
    return solve.exit_code(len(violated), sum(task.is_compared for task in tasks), crashed)


def main(args):
    wanted = arguments(args)
    return solve.campaign("staircase.py", "staircase.jsonl", tasks_of(wanted), wanted, report)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
