"""The claims of the paper: the list is sound, and verdicts follow from numbers."""

import csv
import json
import os
import stat
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
TREE = os.path.join(HERE, "..", "..")
for folder in (HERE, os.path.join(TREE, "reports"), os.path.join(TREE, "reports", "claims")):
    sys.path.insert(0, folder)

import book  # noqa: E402
import formula  # noqa: E402
import judge  # noqa: E402
import run  # noqa: E402
import sources  # noqa: E402
from pulloff_report import claims, sections, summary  # noqa: E402
from pulloff_report.errors import ReportError  # noqa: E402

# A program that knows two scenes, and leaves a line whenever it is asked.
PROGRAM = """#!/bin/sh
echo asked >> "$(dirname "$0")/asked"
case "$*" in
*'--tabor 2.385 '*) echo '{"pull_off": {"force": 1.5718}, "folds": [{"approach": -2.4}, {"approach": -2.9}]}' ;;
*'--tabor 3 '*) echo '{"pull_off": {"force": 1.5510}, "folds": []}' ;;
*) echo 'pulloff: no such scene' >&2; exit 3 ;;
esac
"""

ENTRY = {"id": "made", "where": "Sec. 9", "says": "so much", "claimed": "1.57", "reading": "printed",
         "get": {"force": {"pulloff": "solve --tabor 2.385", "at": "pull_off.force"}}}


class Listed(unittest.TestCase):
    """claims.toml, without running anything."""

    def setUp(self):
        self.claims = book.read(os.path.join(TREE, "reports", "claims", "claims.toml"))

    def sources(self):
        for claim in self.claims:
            for name, source in claim.get("get", {}).items():
                yield f"{claim['id']}.{name}", source

    def test_every_place_of_the_paper_with_a_figure_or_an_equation_is_there(self):
        places = " ".join(claim["where"] for claim in self.claims)
        for figure in (1, 3, 4, *range(6, 16)):
            self.assertRegex(places, rf"Figs?\. ?{figure}\b|Figs \d+-{figure}\b")
        for equation in (1, 4, 5, 7, 9, 12, 13, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30):
            self.assertRegex(places, rf"Eqs? ([\d, -]*\D)?{equation}\b", f"Eq {equation}")

    def test_the_cases_that_are_named_exist(self):
        for name, source in self.sources():
            if "case" in source:
                self.assertTrue(os.path.exists(os.path.join(TREE, "cases", source["case"] + ".yaml")), name)

    def test_the_tables_have_the_rows_that_are_named(self):
        for name, source in self.sources():
            if "table" in source:
                with open(os.path.join(TREE, source["table"]), encoding="utf-8") as stream:
                    rows = list(csv.DictReader(line for line in stream if not line.startswith("#")))
                found = [row for row in rows if sources.is_selected(source["when"], row.__getitem__)]
                self.assertEqual(len(found), 1, name)
                self.assertIn(source["column"], found[0], name)


class Refused(unittest.TestCase):
    def refused(self, message, **changes):
        entry = {key: value for key, value in {**ENTRY, **changes}.items() if value is not None}
        with self.assertRaisesRegex(book.BookError, message):
            book.check_claim(entry, "made")

    def test_the_entry_itself_passes(self):
        book.check_claim(ENTRY, "made")

    def test_what_is_wrong_with_an_entry_is_said(self):
        self.refused("says is missing", says="")
        self.refused("colour is unknown", colour="red")
        self.refused("reading is missing", reading=None)
        self.refused("reading: expected one of", reading="guessed")
        self.refused("in quotes, as it is printed", claimed=1.57)
        self.refused("the printed digits say it", accuracy=0.1)
        self.refused("accuracy is missing", reading="about")
        self.refused("accuracy_because is missing", reading="about", accuracy=0.1)
        self.refused("lower end first", reading="about", claimed=["2", "1"], accuracy=0, accuracy_because="made")
        self.refused("not got: froce", value="froce")
        self.refused("got for nothing: force", value="2.385")
        self.refused("neither a number", value="__import__('os')")
        self.refused("says how to test it", untestable="no number")
        self.refused("expected one of pulloff, case and table", get={"force": {"at": "x"}})
        self.refused("which path or column", get={"force": {"case": "fig03"}})
        self.refused("a command of theory or solve", get={"force": {"pulloff": "run fig03", "at": "x"}})
        self.refused("not those of each", get={"force": {"pulloff": "solve --tabor {tabor}", "at": "x"}})
        self.refused("when is of the wrong type", get={"force": {"case": "fig03", "when": "tabor", "at": "x"}})


class Rule(unittest.TestCase):
    def test_half_a_unit_of_the_last_printed_digit(self):
        self.assertAlmostEqual(judge.half_unit("8.5761"), 5e-5, places=18)
        self.assertEqual((judge.half_unit("-2"), judge.half_unit("1.50")), (0.5, 0.005))

    def test_made_up_numbers(self):
        for expected, computed, low, high, accuracy, reading in (
                ("reproduced", 8.57608, 8.5761, 8.5761, 5e-5, "printed"),
                ("contradicted", 8.57604, 8.5761, 8.5761, 5e-5, "printed"),
                ("within_reading", 1.7809, 1.75, 1.75, 0.05, "about"),
                ("contradicted", 1.6999, 1.75, 1.75, 0.05, "about"),
                ("reproduced", 1.588, 1.5, 1.65, 0.01, "figure"),
                ("within_reading", 1.492, 1.5, 1.65, 0.01, "figure"),
                ("contradicted", 1.489, 1.5, 1.65, 0.01, "figure"),
                ("reproduced", 3.53, 3, float("inf"), 0, "figure"),
                ("reproduced", 6, 6, 6, 0, "figure"),
                ("contradicted", 8, 6, 6, 0, "figure"),
                ("no_result", None, 1, 1, 0.1, "figure"),
                ("no_result", float("nan"), 1, 1, 0.1, "figure")):
            self.assertEqual(judge.verdict(computed, low, high, accuracy, reading), expected, (computed, low))

    def test_the_difference_is_that_from_the_nearer_end(self):
        self.assertAlmostEqual(judge.difference(1.4, 1.5, 2), -0.1)
        self.assertAlmostEqual(judge.difference(2.3, 1.5, 2), 0.3)
        self.assertEqual(judge.difference(1.7, 1.5, 2), 0)


class Formulas(unittest.TestCase):
    def test_values(self):
        values = {"force": [1.7, 1.2, 2.4], "place": [0.1, 0.3, 0.9]}
        for text, expected in (("max(force) - min(force)", 1.2), ("where_greatest(force, place)", 0.9),
                               ("where_least(force, place)", 0.3), ("min(pick(force, place, 0.2, 1))", 1.2),
                               ("count(force)", 3), ("sum(j, 1, 4, j**2)", 30), ("-2**2", -4)):
            self.assertAlmostEqual(formula.evaluate(text, values), expected, places=12)
        self.assertAlmostEqual(formula.evaluate("H(1, 2)", {}), 0.6467637282835622, places=13)
        self.assertAlmostEqual(formula.evaluate("4/pi*E(1) - 2/pi*K(0)", {}), 0.2732395447351628, places=13)
        self.assertAlmostEqual(formula.evaluate("slope(x, y)", {"x": [2, 7, 8], "y": [3, 1, 3 / 64]}), -3, places=12)

    def test_names_and_refusals(self):
        self.assertEqual(formula.names("max(force)*pi + sum(j, 0, n, j*h)"), {"force", "n", "h"})
        for text in ("1 +", "open('x')", "force.real", "[1, 2]", "sum(1, 2)", "1 if 2 else 3"):
            with self.assertRaises(formula.FormulaError):
                formula.parse(text)
        for text in ("1/0", "sqrt(-1)", "missing", "force + 1", "1e999"):
            with self.assertRaises(formula.FormulaError):
                formula.evaluate(text, {"force": [1]})


class Judged(unittest.TestCase):
    """The runner with a made-up program and record."""

    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="pulloff-claims-")
        self.addCleanup(holder.cleanup)
        self.folder = holder.name
        self.program = os.path.join(self.folder, "pulloff")
        with open(self.program, "w", encoding="utf-8") as stream:
            stream.write(PROGRAM)
        os.chmod(self.program, os.stat(self.program).st_mode | stat.S_IXUSR)
        place = os.path.join(self.folder, "run", "made")
        os.makedirs(place)
        points = [{"input": {"radius": 100}, "sweep": {"tabor": tabor}, "status": status, "command": "pulloff solve",
                   "pull_off": {"force": force}} for tabor, status, force in ((1, "ok", 1.67), (2, "ok", 1.58), (3, "failed", None))]
        with open(os.path.join(place, "record.json"), "w", encoding="utf-8") as stream:
            json.dump({"command": "pulloff run made", "points": points}, stream)
        self.kept = os.path.join(self.folder, "kept")
        os.makedirs(self.kept)

    def given(self):
        return sources.Sources(self.program, os.path.join(self.folder, "run"), TREE, self.kept)

    def asked(self):
        with open(os.path.join(self.folder, "asked"), encoding="utf-8") as stream:
            return len(stream.readlines())

    def row(self, **changes):
        return run.row_of({**ENTRY, **changes}, self.given())

    def test_a_command_is_run_once_for_each_program(self):
        self.assertEqual([self.row()["verdict"], self.row()["verdict"]], ["reproduced", "reproduced"])
        self.assertEqual(self.asked(), 1)
        with open(self.program, "a", encoding="utf-8") as stream:
            stream.write("# another\n")
        given = self.given()
        run.row_of(ENTRY, given)
        self.assertEqual(self.asked(), 2)
        given.forget_unused()
        self.assertEqual(len(os.listdir(self.kept)), 1)

    def test_values_of_all_kinds(self):
        several = {"force": {"pulloff": "solve --tabor {tabor}", "at": "pull_off.force", "each": {"tabor": [2.385, 3]}}}
        row = self.row(get=several, value="max(force)/min(force)", claimed="1.02")
        self.assertEqual((row["verdict"], row["commands"]), ("contradicted", ["pulloff solve --tabor 2.385", "pulloff solve --tabor 3"]))
        self.assertEqual(self.row(get={"folds": {"pulloff": "solve --tabor 2.385", "at": "folds.#"}}, claimed="2")["computed"], 2)
        self.assertEqual(self.row(get={"a": {"pulloff": "solve --tabor 2.385", "at": "folds.*.approach"}}, value="min(a)",
                                  claimed="-2.9")["verdict"], "reproduced")
        self.assertEqual(self.row(get={"f": {"case": "made", "when": {"tabor": 2}, "at": "pull_off.force"}}, claimed="1.58")["verdict"],
                         "reproduced")
        self.assertEqual(self.row(get={"f": {"case": "made", "at": "pull_off.force", "all": True}}, value="count(f)", claimed="2")["computed"], 2)

    def test_what_cannot_be_had_is_told(self):
        for get, message in (({"f": {"pulloff": "solve --tabor 4", "at": "x"}}, "no such scene"),
                             ({"f": {"pulloff": "solve --tabor 3", "at": "pull_off.farce"}}, "there is no farce"),
                             ({"f": {"case": "made", "when": {"tabor": 3}, "at": "pull_off.force"}}, "nothing solved"),
                             ({"f": {"case": "made", "at": "pull_off.force"}}, "2 rows"),
                             ({"f": {"case": "absent", "at": "x"}}, "no record of case absent")):
            row = self.row(get=get)
            self.assertEqual(row["verdict"], "no_result")
            self.assertIn(message, row["reason"])
        bare = {"id": "bare", "where": "Fig. 1", "says": "a sketch", "untestable": "no number"}
        self.assertEqual(run.row_of(bare, self.given())["verdict"], "not_testable")

    def test_the_report_shows_them(self):
        made = run.document([self.row(), self.row(id="other", claimed="1.60"),
                             self.row(id="open", claimed=["1.5", "inf"], reading="figure", accuracy=0, accuracy_because="made")], "0")
        path = os.path.join(self.folder, "claims.json")
        run.write(path, made)
        judged = claims.read(path)
        self.assertEqual(summary.claims(judged), "3 claims of the paper: 2 reproduced and 1 contradicted.")
        from pulloff_report.sections import claims as section
        rows = section.build(sections.Source(None, None, None, judged)).data["rows"]
        self.assertEqual([(row["claimed"], row["word"]) for row in rows],
                         [("1.57", "reproduced"), ("1.60", "contradicted"), ("≥ 1.5", "reproduced")])
        made["claims"][0]["verdict"] = "believed"
        run.write(path, made)
        with self.assertRaisesRegex(ReportError, "believed"):
            claims.read(path)


if __name__ == "__main__":
    unittest.main()
