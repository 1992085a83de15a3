"""Other laws and profiles: the figures of the suite general, and how many of its numbers agree with references."""

from . import Section
from .. import plots
from ..records import PASSING
from ..words import count

SUITE = "general"
ABSENT = ("Other laws and profiles are omitted: this run has no record of the suite general "
          "(pulloff run --suite general computes them).")


def missing(module, script):
    return f"{module.TITLE} is omitted: this run has no record of a case that draws it with the script {script}."


def row_of(case):
    """One line of the table: a case, its scenes and checks."""
    return {"case": case, "scenes": len(case.points), "solved": len(case.points) - len(case.unsolved_points()),
            "checks": len(case.checks), "passing": case.count(*PASSING), "worst": case.worst()}


def build(source):
    cases = [case for case in source.run.cases if SUITE in case.record["suites"]]
    figures, absent = [], []
    for script, module in plots.OF_GENERAL.items():
        found = source.run.drawing(script)
        if found:
            figures.append(module.make(found[0], source.references))
        elif cases:
            absent.append(missing(module, script))
    rows = [row_of(case) for case in cases]
    total = {name: sum(row[name] for row in rows) for name in ("scenes", "solved", "checks", "passing")}
    words = f"{total['solved']} of {count(total['scenes'], 'scene')} were solved, and {total['passing']} of {count(total['checks'], 'check')} pass."
    return Section("general", "Other laws and profiles", "general.html",
                   {"figures": figures, "absent": absent if cases else [ABSENT], "rows": rows, "words": words},
                   [(f"figure-{item.id}", item.title) for item in figures])
