"""External solvers: verdict and coverage of each case, error against run time, and how much faster this program is."""

import shlex
import statistics

from . import Section
from .. import samples, solvers

ABSENT = "external solvers (./reproduce --only solvers)"
GOALS = (("its error", None), ("1e-6", solvers.GOAL))


def figure_of(rows, command):
    from ..plots import solvers as figure   # loads matplotlib
    return figure.make(rows, command)


def cell(solver, name):
    """Verdict, score and coverage of a solver on a case; None if it was not asked."""
    case = solver.cases.get(name)
    if case is None:
        return None
    passing, made = solvers.score(case)
    cover = solvers.coverage(case)
    return {"verdict": case.verdict if cover["asked"] else None, "passing": passing, "made": made, "cover": cover,
            "failed": len(case.failed_points()), "reasons": reasons(case)}


def own_cell(run, found, name):
    """The same of this program, which covers every case; None if it was not run."""
    case = next((case for case in run.cases if case.name == name), None)
    if case is None:
        return None
    passing, made = solvers.score(case)
    checks = next(solvers.coverage(solver.cases[name])["checks"] for solver in found if name in solver.cases)
    return {"verdict": case.verdict, "passing": passing, "made": made, "failed": len(case.failed_points()), "reasons": [],
            "cover": {"asked": len(case.points), "points": len(case.points), "made": checks, "checks": checks}}


def table(run, found, names):
    """A row a solver, this program first, with a cell a case."""
    rows = [{"label": solvers.OURS, "cells": {name: own_cell(run, found, name) for name in names}}]
    rows += [{"label": solver.label, "cells": {name: cell(solver, name) for name in names}} for solver in found]
    return [row for row in rows if any(row["cells"].values())]


def reasons(case):
    """The distinct reasons why points have no result."""
    return list(dict.fromkeys(f"{point['status'].replace('_', ' ')}: {point['reason']}" for point in case.failed_points()
                              if point.get("reason")))[:3]


def comparison(item, ours, goal):
    """How this program compares at an error: the quotient of times, our solve, or why there is none."""
    if not item.usable:
        return {"words": "wrong" if item.wrong else "no result"}
    if goal is not None and item.error > goal:
        best = solvers.quickest(ours, goal)
        quotient = solvers.paired(item, best) if best else None
        return {"least": quotient, "ours": best} if quotient else {"words": "not reached by pulloff"}
    best = solvers.quickest(ours, item.error if goal is None else goal)
    if best is None:
        return {"words": "not reached by pulloff"}
    return {"quotient": solvers.paired(item, best), "ours": best}


def middle(values):
    """The median of the times that are known; None if there are none."""
    known = [value for value in values if value is not None]
    return statistics.median(known) if known else None


def speed_rows(rows):
    found = []
    for scene in samples.scenes(rows):
        here = samples.of(rows, scene)
        ours = [row for row in here if row.name == solvers.OURS]
        for item in here:
            if item.name != solvers.OURS and ours:
                found.append({"scene": samples.scene_name(scene), "item": item,
                              "cells": [comparison(item, ours, goal) for _, goal in GOALS]})
    for before, row in zip([None] + found, found):
        row["first"] = before is None or before["scene"] != row["scene"]
    return found


def slower(rows):
    """Sentences on the scenes and solvers where this program is not faster."""
    found = []
    for row in rows:
        at_error, at_goal = row["cells"]
        name = f"{row['item'].label} on {row['scene']}"
        if at_error.get("words") == "not reached by pulloff":
            found.append(f"{name}: no tolerance of this program reaches its error.")
        elif at_error.get("quotient") is not None and at_error["quotient"] < 1:
            found.append(f"{name}: it is {1 / at_error['quotient']:.3g} times faster than this program.")
        if at_goal.get("quotient") is not None and at_goal["quotient"] < 1:
            found.append(f"{name}: at {GOALS[1][0]} it is {1 / at_goal['quotient']:.3g} times faster than this program.")
    return found


def command(found):
    """The command that times the solvers in turn with this program."""
    named = [f"{solver.about['manifest']}@{solver.about['knob_value']}" if solver.about.get("knob") else solver.about["manifest"]
             for solver in found if solvers.TIMED in solver.cases]
    return f"pulloff run {solvers.TIMED} --solver pulloff " + " ".join(f"--solver {shlex.quote(name)}" for name in named)


def front(found, speeds):
    """What the first page says: the solvers, the smallest and greatest quotient at their error, and how many are below 1."""
    quotients = [row["cells"][0]["quotient"] for row in speeds if row["cells"][0].get("quotient")]
    return {"names": list(dict.fromkeys(solver.name.split("@")[0] for solver in found)), "compared": len(speeds),
            "quotients": len(quotients), "least": min(quotients, default=None), "most": max(quotients, default=None),
            "slower": sum(quotient < 1 for quotient in quotients),
            "beyond": sum(row["cells"][0].get("words") == "not reached by pulloff" for row in speeds)}


def build(source):
    found = solvers.read(source.run)
    data = {"figure": None}
    if found:
        names = list(dict.fromkeys(name for solver in found for name in solver.cases))
        titles = {name: next(s.cases[name].title for s in found if name in s.cases) for name in names}
        rows = solvers.timed(source.run, found)
        speeds = speed_rows(rows)
        ours = next((case for case in source.run.cases if case.name == solvers.TIMED), None)
        data = {"middle": middle, "scene": samples.scene_name, "titles": titles,
                "rows": table(source.run, found, names), "front": front(found, speeds),
                "figure": figure_of(rows, command(found)) if ours and rows else None,
                "speeds": speeds, "slower": slower(speeds), "goals": [name for name, _ in GOALS],
                "timed": [row for row in rows if row.timing],
                "apart": [row for row in rows if row.timing and row.usable and not row.timing["interleaved"]]}
    return Section("solvers", "External solvers", "solvers.html", data, absent="" if found else ABSENT)
