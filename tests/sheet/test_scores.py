"""The stored scores of programs: their table in doc/sheet.md, and the rows of pulloff computed anew."""

import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCORES = ROOT / "reference" / "make" / "sheet_scores.py"
sys.path.insert(0, str(SCORES.parent))

import sheet_elastic  # noqa: E402
import sheet_scores  # noqa: E402
from tables import read_table  # noqa: E402

ANEW = ["elastic-tabor-1", "elastic-cone", "elastic-spring"]


def test_table_is_that_of_the_document():
    table = subprocess.run([sys.executable, str(SCORES), "--table"], check=True, capture_output=True, text=True).stdout
    block = (ROOT / "doc" / "sheet.md").read_text().split("<!-- scores -->\n")[1].split("<!-- /scores -->")[0]
    assert block == table, "python3 reference/make/sheet_scores.py --table prints the block"


def test_rows_of_pulloff_anew():
    problems = [problem for problem in sheet_elastic.read_problems() if problem["id"] in ANEW]
    stored = {row["problem"]: row for row in read_table(sheet_scores.SHEET / "scoreboard.csv")[1] if row["program"] == "pulloff"}
    solve = sheet_scores.pulloff(os.environ["PULLOFF"])
    rows = list(sheet_scores.rows_of("pulloff", "", "", solve, problems, sheet_scores.score.read_values()[0]))
    assert len(rows) == len(ANEW)
    for row in rows:
        found = dict(zip(sheet_scores.COLUMNS, row))
        for name in ("asked", "answered", "force", "digits", "certified"):
            assert found[name] == stored[found["problem"]][name]


def test_every_row_is_a_problem():
    names = {problem["id"] for problem in sheet_elastic.read_problems()}
    rows = read_table(sheet_scores.SHEET / "scoreboard.csv")[1]
    assert len({(row["program"], row["problem"]) for row in rows}) == len(rows) > 30
    assert {row["problem"] for row in rows} <= names
    assert all(float(row["digits"]) <= float(row["certified"]) and int(row["answered"]) <= int(row["asked"]) for row in rows)
