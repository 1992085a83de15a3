"""What programs make of the adhesion sheet: a line a problem, a column a program."""

from . import Section

TABLE = "sheet/scoreboard.csv"


def build(source):
    table = source.references.table(TABLE) if source.references else None
    if table is None:
        return Section("scores", "Scores on the adhesion sheet", "scores.html", None, absent="scores of programs on the adhesion sheet")
    names = list(table.columns)
    rows = [dict(zip(names, cells)) for cells in zip(*table.columns.values())]
    programs = list(dict.fromkeys(row["program"] for row in rows))
    cells = {(row["problem"], row["program"]): row for row in rows}
    problems = [{"id": row["problem"], "level": row["level"], "certified": row["certified"],
                 "cells": [cells.get((row["problem"], program)) for program in programs]}
                for row in {row["problem"]: row for row in rows}.values()]
    used = [{"program": program, **next({key: row[key] for key in ("version", "command")} for row in rows if row["program"] == program)}
            for program in programs]
    data = {"programs": programs, "problems": problems, "used": used, "digest": table.digest()}
    return Section("scores", "Scores on the adhesion sheet", "scores.html", data, on_paper=False,
                   omitted_words=f"the digits of {len(programs)} programs on {len(problems)} problems of the adhesion sheet")
