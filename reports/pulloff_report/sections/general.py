"""Other laws and profiles: the figures of the suite general, and how many of its numbers agree with references."""

from . import Section
from .. import plots
from ..records import PASSING
from ..words import count

SUITE = "general"
ABSENT = "other laws and profiles (pulloff run --suite general)"


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
            absent.append(f"{module.TITLE} ({script})")
    rows = [row_of(case) for case in cases]
    total = {name: sum(row[name] for row in rows) for name in ("scenes", "solved", "checks", "passing")}
    words = f"{total['solved']} of {count(total['scenes'], 'scene')} were solved, and {total['passing']} of {count(total['checks'], 'check')} pass."
    return Section("general", "Other laws and profiles", "general.html",
                   {"figures": figures, "absent": absent, "rows": rows, "words": words},
                   [(f"figure-{item.id}", item.title) for item in figures], absent="" if cases else ABSENT)
