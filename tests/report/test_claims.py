"""The claims of the paper: the list is sound, and verdicts follow from numbers."""

import ast
import csv
import json
import math
import os
import re
import stat
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
TREE = os.path.join(HERE, "..", "..")
for folder in (HERE, os.path.dirname(HERE), os.path.join(TREE, "reports"), os.path.join(TREE, "reports", "claims")):
    sys.path.insert(0, folder)

import book  # noqa: E402
import checksum  # noqa: E402
import formula  # noqa: E402
import judge  # noqa: E402
import others  # noqa: E402
import preloads  # noqa: E402
import robust  # noqa: E402
import run  # noqa: E402
import sources  # noqa: E402
from pulloff_report import claims, findings, sections  # noqa: E402
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

ENTRY = {"id": "made", "where": "Sec. 9", "quote": "It is so much.", "tests": "so much", "claimed": "1.57", "reading": "printed",
         "get": {"force": {"pulloff": "solve --tabor 2.385", "at": "pull_off.force"}},
         "change": {"words": "half the force", "claimed": "1.60"}}

PRELOADS = {"fig9": {"figures": "9", "because": "made", "choice": [{"words": "far"}, {"words": "near"}]}}


class Listed(unittest.TestCase):
    """claims.toml, without running anything."""

    def setUp(self):
        self.claims, self.preloads, self.surveys, self.sentences = book.read(run.LIST)

    def sources(self):
        for claim in self.claims:
            for choice in book.choices(claim):
                for name, source in choice["get"].items():
                    yield f"{claim['id']}.{name}", source

    def test_the_list_of_viscoelastic_spheres_is_valid(self):
        """A list that only ./reports/claims/run.py --paper reads: each entry has a quotation, and a source or a reason."""
        path = os.path.join(os.path.dirname(run.LIST), "..", "viscoelastic", "claims.toml")
        claims, _, _, _ = book.read(path)
        self.assertEqual(len({claim["id"] for claim in claims}), len(claims))
        self.assertTrue(all(claim["where"].startswith("arXiv:") for claim in claims))
        self.assertEqual(sum("untestable" in claim for claim in claims), 5)

    def test_no_entry_takes_a_node_of_a_curve_for_its_extreme(self):
        """The largest tension of a profile, and the largest load of Eq 5 against the contact radius, lie between the nodes: with
        the nodes a ratio of 3.378 was 3.400, and a span of 10.12 was 7.20."""
        found = []
        for claim in self.claims:
            for choice in book.choices(claim):
                curves = {name for name, source in choice["get"].items() if source.get("at", "").startswith(("profile.", "curve", "line-"))
                          or re.search(r"--(contact-radius|approach) \{", source.get("pulloff", ""))}
                calls = [node for node in ast.walk(formula.parse(choice["value"] or "0")) if isinstance(node, ast.Call)]
                found += [claim["id"] for call in calls if call.func.id in ("max", "min", "where_greatest", "where_least")
                          for part in call.args for name in ast.walk(part) if isinstance(name, ast.Name) and name.id in curves
                          and not any(name in ast.walk(inner) for inner in calls if inner.func.id in ("farthest", "highest", "lowest"))]
        self.assertEqual(found, [])

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
                many = [len(value) for value in source["when"].values() if isinstance(value, list)]
                self.assertTrue(found, name)
                if many or not source.get("all"):
                    self.assertEqual(len(found), *(many or [1]), name)
                self.assertIn(source["column"], found[0], name)

    def test_a_claim_stands_alone(self):
        for claim in self.claims:
            for key in ("tests", "note", "survives"):
                self.assertNotRegex(claim.get(key, ""), r"^(The same|…)|[Ss]ee (above|below)|row (above|below)|next row", claim["id"])

    def test_the_entries_of_a_figure_use_its_preloads(self):
        """A preload is written out only where an entry says in `tests` or in its choices which it is, and why."""
        used = {claim["preload"] for claim in self.claims if "preload" in claim}
        self.assertEqual(used, set(self.preloads))
        for claim in self.claims:
            lines = [source["pulloff"] for choice in claim.get("choice", [{}]) for source in [*claim.get("get", {}).values(),
                     *choice.get("get", {}).values()] if "pulloff" in source]
            if "kind" not in claim and any("preload" in line for line in lines) and "preload" not in claim:
                self.assertRegex(claim["tests"] + claim.get("note", ""), "pressed|preloads|JKR|Eq 5 gives", claim["id"])
            if "kind" not in claim and re.search(r"Figs?\.? ?(8|9|1[0-5])\b", claim["where"]):
                for line in lines:
                    self.assertTrue("--amplitude" not in line or not line.startswith("solve") or "preload" in line
                                    or "--approach-end" in line, f"{claim['id']}: no preload in {line}")

    def test_a_check_quotes_nothing(self):
        for claim in self.claims:
            self.assertEqual("kind" in claim, "quote" not in claim, claim["id"])

    def test_both_sides_are_not_one_number(self):
        """No number is got twice under two names."""
        for claim in self.claims:
            for choice in book.choices(claim):
                lines = [json.dumps(source, sort_keys=True) for source in choice["get"].values()]
                self.assertEqual(len(lines), len(set(lines)), claim["id"])


class Refused(unittest.TestCase):
    def refused(self, message, **changes):
        entry = {key: value for key, value in {**ENTRY, **changes}.items() if value is not None}
        with self.assertRaisesRegex(book.BookError, message):
            book.check_claim(entry, "made")

    def test_the_entry_itself_passes(self):
        book.check_claim(ENTRY, "made")

    def test_what_is_wrong_with_an_entry_is_said(self):
        self.refused("tests is missing", tests="")
        self.refused("quote is missing", quote=None)
        self.refused("quote is of the wrong type", quote=[1])
        self.refused("kind: expected implementation check", kind="guess")
        self.refused("expected two or more", choice=[{"words": "one"}])
        self.refused("words are missing", choice=[{"words": "one"}, {"set": {"tabor": 2}}])
        self.refused("colour is unknown", choice=[{"words": "one"}, {"words": "two", "colour": "red"}])
        self.refused("not those of each", choice=[{"words": "one", "set": {"tabor": 2}}, {"words": "two"}],
                     get={"force": {"pulloff": "solve --tabor {tabor}", "at": "x"}})
        self.refused("change is missing", change=None)
        self.refused("change: words are missing", change={"claimed": "1.60"})
        self.refused("change: it changes nothing", change={"words": "nothing", "swap": ["--tabor 4", "--tabor 5"]})
        self.refused("change: colour is unknown", change={"words": "red", "colour": "red"})
        self.refused("not got: froce", change={"words": "a slip", "value": "froce"})
        self.refused("colour is unknown", colour="red")
        self.refused("reading: expected one of", reading=None)
        self.refused("reading: expected one of", reading="guessed")
        self.refused("in quotes, as it is printed", claimed=1.57)
        self.refused("the convention says it", accuracy=0.1, accuracy_because="made")
        self.refused("the convention says it", reading="about", accuracy=0.1, accuracy_because="made")
        self.refused("expected for an equation", reading="equation", accuracy=0.1)
        self.refused("range: expected for an axis", reading="axis")
        self.refused("range: expected for an axis", range=[0, 1])
        for reading in ("large", "gradual"):
            self.refused("claimed is missing, or stated for a ratio", reading=reading)
        self.refused("lower end first", reading="about", claimed=["2", "1"])
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
        for expected, computed, low, high, reading in (
                ("reproduced", 8.57608, 8.5761, 8.5761, "printed"), ("contradicted", 8.57604, 8.5761, 8.5761, "printed"),
                ("within_reading", 1.7809, 1.75, 1.75, "about"), ("contradicted", 1.574, 1.75, 1.75, "about"),
                ("within_reading", 1.4, 1.5, 1.65, "about"), ("contradicted", 1.3, 1.5, 1.65, "about"),
                ("within_reading", 1.492, 1.5, 2, "axis"), ("contradicted", 1.489, 1.5, 2, "axis"),
                ("within_reading", 1.79, 2, 2, "logarithmic"), ("contradicted", 1.78, 2, 2, "logarithmic"),
                # 0.05 decades: a factor of 1.122 in both directions, 12.2 % above and 10.9 % below
                ("within_reading", 2.244, 1.9, 2, "logarithmic"), ("contradicted", 2.245, 1.9, 2, "logarithmic"),
                ("within_reading", 0.034, 0.1, 0.1, "order"), ("contradicted", 0.31, 0.1, 0.1, "order"),
                ("within_reading", 2.01, 1, float("inf"), "large"), ("contradicted", 1.99, 1, float("inf"), "large"),
                ("within_reading", 1.99, 1, float("inf"), "gradual"), ("contradicted", 0.49, 1, float("inf"), "gradual"),
                ("contradicted", 2.01, 1, float("inf"), "gradual"),
                ("reproduced", 3.53, 3, float("inf"), "bound"), ("contradicted", 8, 6, 6, "bound"),
                ("reproduced", 1.009, 1, 1, "equation"), ("contradicted", 1.011, 1, 1, "equation"),
                ("no_result", None, 1, 1, "about"), ("no_result", float("nan"), 1, 1, "about")):
            claim = {"reading": reading, "range": [1.5, 2], "accuracy": 0.01}
            low, high, accuracy = judge.reach(claim, "8.5761", low, high, computed=computed)
            self.assertEqual(judge.verdict(computed, low, high, accuracy, reading), expected, (computed, low))

    def test_a_scaled_convention(self):
        for reading, low, scale, expected in (("about", 2, 2, (2, 2, 0.4)), ("order", 1, 2, (1 / 9, 9, 0)),
                                              ("large", 1, 0.5, (2 ** 0.5, float("inf"), 0)), ("gradual", 1, 2, (0.25, 4, 0)),
                                              ("bound", 3, 2, (3, 3, 0))):
            for found, wanted in zip(judge.reach({"reading": reading}, None, low, low, scale), expected, strict=True):
                self.assertAlmostEqual(found, wanted, places=12)

    def test_the_difference_is_that_from_the_nearer_end(self):
        self.assertAlmostEqual(judge.difference(1.4, 1.5, 2), -0.1)
        self.assertAlmostEqual(judge.difference(2.3, 1.5, 2), 0.3)
        self.assertEqual(judge.difference(1.7, 1.5, 2), 0)

    def test_a_claim_of_several_choices(self):
        for expected, verdicts in (("reproduced", ["reproduced", "reproduced"]),
                                   ("within_reading", ["reproduced", "within_reading"]),
                                   ("depends", ["within_reading", "contradicted"]),
                                   ("contradicted", ["contradicted", "contradicted"]),
                                   ("no_result", ["contradicted", "no_result"])):
            self.assertEqual(judge.overall(verdicts), expected)
        self.assertEqual(judge.overall(["reproduced"], is_check=True), "checked")
        self.assertEqual(judge.overall(["contradicted"], is_check=True), "check_failed")


class Formulas(unittest.TestCase):
    def test_values(self):
        values = {"force": [1.7, 1.2, 2.4], "place": [0.1, 0.3, 0.9]}
        for text, expected in (("max(force) - min(force)", 1.2), ("where_greatest(force, place)", 0.9),
                               ("where_least(force, place)", 0.3), ("min(pick(force, place, 0.2, 1))", 1.2),
                               ("sum(j, 1, 4, j**2)", 30), ("-2**2", -4), ("least(j, 0, 4, (j-3)**2)", 0),
                               ("below(force, 1.7)", 1), ("max(differences(scaled(force, 2), place))", 3.9), ("crossing(place, scaled(force, -1), -1.3)", 0.26)):
            self.assertAlmostEqual(formula.evaluate(text, values), expected, places=12)
        self.assertAlmostEqual(formula.evaluate("H(1, 2)", {}), 0.6467637282835622, places=13)
        self.assertAlmostEqual(formula.evaluate("4/pi*E(1) - 2/pi*K(0)", {}), 0.2732395447351628, places=13)
        self.assertEqual(formula.greatest_at([1, 5, 3, 2], [7, 2, 7, 2]), [5, 3])
        self.assertEqual(formula.evaluate("last(distinct(x))", {"x": [3, 1, 3]}), 3)
        self.assertEqual(formula.evaluate("total(last(x, 2))", {"x": [3, 1, 4]}), 5)
        self.assertEqual(formula.evaluate("worst(x, 2)", {"x": [3, 0, 3]}), 0)

    def test_extremes_are_located_between_the_points(self):
        """Those of a sine whose points miss them: 0.2 apart, the largest at 1.6."""
        at = [0.2 * k for k in range(15, -1, -1)]
        values = {"x": at, "y": [math.sin(x) for x in at]}
        for text, expected in (("highest(y, x, 0, 3)", 1), ("highest(y, x, 0, 0.9)", math.sin(0.9)), ("lowest(y, x, 0.7, 2)", math.sin(0.7)),
                               ("place_of_lowest(scaled(y, -1), x, -5, 5)", math.pi / 2), ("lowest(y, x, -1, 1)", 0)):
            self.assertAlmostEqual(formula.evaluate(text, values), expected, places=3)
        self.assertEqual(formula.evaluate("first(logs(x))", {"x": [100]}), 2)
        self.assertRaises(formula.FormulaError, formula.evaluate, "highest(y, x, 4, 5)", values)

    def test_the_distance_of_two_curves(self):
        line = {"x": [0, 2, 2], "y": [0, 0, 4]}
        for point, width, expected in (((1, 1), 1, 1), ((1, 1), 2, 0.5), ((3, 5), 1, 2 ** 0.5), ((-3, 0), 1, 3)):
            values = {"a": [2, point[0]], "b": [2, point[1]], **line}
            self.assertAlmostEqual(formula.evaluate(f"farthest(a, b, x, y, {width}, 1)", values), expected, places=12)

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
                   "curve": f"curve-{tabor - 1}.csv", "pull_off": {"force": force}}
                  for tabor, status, force in ((1, "ok", 1.67), (2, "ok", 1.58), (3, "failed", None))]
        checksum.write(os.path.join(place, "record.json"), {"command": "pulloff run made", "points": points})
        self.kept = os.path.join(self.folder, "kept")
        os.makedirs(self.kept)

    def given(self):
        return sources.Sources(self.program, os.path.join(self.folder, "run"), TREE, self.kept)

    def asked(self):
        with open(os.path.join(self.folder, "asked"), encoding="utf-8") as stream:
            return len(stream.readlines())

    def row(self, **changes):
        given = self.given()
        return run.row_of({**ENTRY, **changes}, given, others.read(given))

    def computed(self, **changes):
        return self.row(**changes)["choices"][0]["computed"]

    def test_a_command_is_run_once_for_each_program(self):
        self.assertEqual([self.row()["verdict"], self.row()["verdict"]], ["reproduced", "reproduced"])
        self.assertEqual(self.asked(), 1)
        with open(self.program, "a", encoding="utf-8") as stream:
            stream.write("# another\n")
        given = self.given()
        run.row_of(ENTRY, given, [])
        self.assertEqual(self.asked(), 2)
        given.forget_unused()
        self.assertEqual(len(os.listdir(self.kept)), 1)

    def test_values_of_all_kinds(self):
        several = {"force": {"pulloff": "solve --tabor {tabor}", "at": "pull_off.force", "each": {"tabor": [2.385, 3]}}}
        row = self.row(get=several, value="max(force)/min(force)", claimed="1.02")
        self.assertEqual((row["verdict"], row["choices"][0]["commands"]),
                         ("contradicted", ["pulloff solve --tabor 2.385", "pulloff solve --tabor 3"]))
        self.assertEqual(self.computed(get={"folds": {"pulloff": "solve --tabor 2.385", "at": "folds.#"}}, claimed="2"), 2)
        self.assertEqual(self.row(get={"a": {"pulloff": "solve --tabor 2.385", "at": "folds.*.approach"}}, value="min(a)",
                                  claimed="-2.9")["verdict"], "reproduced")
        self.assertEqual(self.row(get={"f": {"case": "made", "when": {"tabor": 2}, "at": "pull_off.force"}}, claimed="1.58")["verdict"],
                         "reproduced")
        self.assertEqual(self.computed(get={"f": {"case": "made", "at": "pull_off.force", "all": True}}, value="min(f)"), 1.58)

    def test_the_curve_of_a_point(self):
        with open(os.path.join(self.folder, "run", "made", "curve-1.csv"), "w", encoding="utf-8") as stream:
            stream.write("# a curve\nload,approach\n0.5,-1\n-2,3\n")
        get = {"f": {"case": "made", "when": {"tabor": 2}, "at": "curve.load"}}
        self.assertEqual(self.computed(get=get, value="min(f)", claimed="-2"), -2)
        line = {"f": {"case": "made", "when": {"tabor": 2}, "at": "line-jkr.load"}}
        self.assertIn("line-jkr.csv", self.row(get=line, value="min(f)")["reason"])

    def test_choices(self):
        force = {"force": {"pulloff": "solve --tabor {tabor}", "at": "pull_off.force"}}
        choices = [{"words": "softer", "set": {"tabor": 3}}, {"words": "harder", "set": {"tabor": 2.385}}]
        row = self.row(get=force, choice=choices)
        self.assertEqual((row["verdict"], [part["verdict"] for part in row["choices"]]), ("depends", ["contradicted", "reproduced"]))
        self.assertEqual(self.row(get=force, choice=choices, claimed="1.6", change={"words": "more", "claimed": "2"})["verdict"],
                         "reproduced")
        self.assertEqual(self.row(get=force, choice=choices, claimed=1.5, reading="equation", accuracy=0.01)["verdict"], "contradicted")
        self.assertEqual(self.row(kind=book.CHECK)["verdict"], "checked")

    def test_an_entry_at_fault_is_told(self):
        self.assertEqual(self.row()["faults"], [])
        wrong = {"claimed": "1.60", "change": {"words": "half the force", "claimed": "1.57"}}
        self.assertRegex(self.row(**wrong)["faults"][0], "expected brief, weight, note and survives")
        self.assertEqual(self.row(**wrong, brief="made", weight=1, note="made", survives="made")["faults"], [])
        vacuous = {"get": {"force": {"pulloff": "solve --tabor 2.385", "at": "pull_off.force"}}, "value": "force/force", "claimed": "1"}
        self.assertEqual(self.row(**vacuous, change={"words": "another law", "swap": ["2.385", "3"]})["faults"],
                         ["the verdict does not change with another law"])
        self.assertRegex(self.row(change={"words": "another law", "swap": ["2.385", "4"]})["faults"][0], "another law: .*no such scene")

    def test_the_physics_is_changed(self):
        get = {"force": {"pulloff": "solve --tabor {tabor}", "at": "pull_off.force"}}
        change = {"words": "stiffer", "swap": ["--tabor 2.385", "--tabor 3"]}
        choice = [{"words": "one", "set": {"tabor": 2.385}}, {"words": "two", "set": {"tabor": 3}}]
        row = self.row(get=get, choice=choice, change=change)      # the first choice is changed
        self.assertEqual({**row["change"], "commands": []}, {"words": "stiffer", "computed": 1.551, "verdict": "contradicted",
                                                             "reason": None, "commands": [], "moved": True})

    def test_a_verdict_that_the_convention_decides(self):
        rough = {"reading": "about", "change": {"words": "more", "claimed": 3}}
        self.assertEqual([self.row(**rough, claimed=claimed)["decided"] for claimed in (1.6, 1.7, 1.8, 2.5)], [False, True, True, False])

    def test_preloads_and_choices_are_combined(self):
        claim = {"choice": [{"words": "one", "set": {"tabor": 2}}, {"words": "two"}], "preload": "fig"}
        preloads = [{"words": "far", "set": {"preload": 4}}, {"words": "near", "set": {"preload": 1}}]
        made = book.with_preloads(claim, {"fig": {"choice": preloads}})
        self.assertEqual([choice["words"] for choice in made["choice"]], ["one, far", "one, near", "two, far", "two, near"])
        self.assertEqual([(choice["own"], choice["preload"]) for choice in made["choice"]], [("one", 0), ("one", 1), ("two", 0), ("two", 1)])
        self.assertEqual([choice["set"] for choice in made["choice"][:3]],
                         [{"tabor": 2, "preload": 4}, {"tabor": 2, "preload": 1}, {"preload": 4}])

    def test_what_cannot_be_had_is_told(self):
        for get, message in (({"f": {"pulloff": "solve --tabor 4", "at": "x"}}, "no such scene"),
                             ({"f": {"pulloff": "solve --tabor 3", "at": "pull_off.farce"}}, "there is no farce"),
                             ({"f": {"case": "made", "when": {"tabor": 3}, "at": "pull_off.force"}}, "nothing solved"),
                             ({"f": {"case": "made", "at": "pull_off.force"}}, "2 rows"),
                             ({"f": {"case": "absent", "at": "x"}}, "no record of case absent")):
            row = self.row(get=get)
            self.assertEqual(row["verdict"], "no_result")
            self.assertIn(message, row["reason"])
        bare = {"id": "bare", "where": "Fig. 1", "quote": "A sketch.", "tests": "a sketch", "untestable": "no number"}
        self.assertEqual(run.row_of(bare, self.given(), [])["verdict"], "not_testable")

    def answer(self, name, forces, quantities=("pull_off_force",)):
        """The record of an external solver on the case `made`; a force None is a failure."""
        place = os.path.join(self.folder, "run", "solvers", name, "made")
        os.makedirs(place)
        points = [{"input": {"radius": 100}, "sweep": {"tabor": tabor}, "status": "failed" if force is None else "ok",
                   "command": "pulloff solve", "pull_off": {"force": force}} for tabor, force in zip((1, 2, 3), forces)]
        checksum.write(os.path.join(place, "record.json"), {"command": "x", "points": points, "solver": {"quantities": quantities}})

    def test_an_altered_record_has_no_number(self):
        path = os.path.join(self.folder, "run", "made", "record.json")
        with open(path, encoding="utf-8") as stream:
            text = stream.read()
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text.replace("1.67", "1.76"))
        row = self.row(get={"f": {"case": "made", "at": "pull_off.force", "when": {"tabor": 1}}})
        self.assertEqual(row["verdict"], "no_result")
        self.assertIn("record.json was altered: it does not have its checksum", row["reason"])

    def test_external_solvers_judge_what_they_were_asked_for(self):
        self.answer("right", (1.671, 1.581, None))
        self.answer("wrong", (-1.671, -1.581, None))
        self.answer("few", (1.671, None, None))
        self.answer("right@7", (9, 9, None))                        # a coarser value of its knob
        self.answer("mute", (1.671, 1.581, None), ("folds",))       # does not compute the force
        case = {"get": {"f": {"case": "made", "at": "pull_off.force", "all": True}}, "value": "min(f)", "claimed": "1.58"}
        row = self.row(**case)
        self.assertEqual([(entry["name"], entry["verdict"]) for entry in row["solvers"]],
                         [("few", "no_result"), ("right", "reproduced"), ("wrong", "contradicted")])
        self.assertEqual(run.solvers_of(row), "reproduced by 1 of 3 external solvers; not by few, wrong")
        self.assertEqual(self.row()["solvers"], [])                 # its number is from a command of this program
        from pulloff_report.sections import claims as section
        self.assertEqual(section.by_solvers(row), "1 of 3 external solvers, not by few (no result), wrong (−1.671)")
        made = run.document([row], "0", PRELOADS)
        self.assertIn("reproduced by 1 of 3", run.text_of(made))
        run.write(os.path.join(self.folder, "claims.json"), made)
        self.assertEqual(claims.read(os.path.join(self.folder, "claims.json"))["claims"][0]["solvers"][1]["computed"], 1.581)

    def test_the_report_shows_them(self):
        made = run.document([self.row(), self.row(id="other", claimed="1.60"),
                             self.row(id="open", claimed=["1.5", "inf"], reading="bound", where="Fig. 9"),
                             self.row(id="both", kind=book.CHECK)], "0", PRELOADS)
        path = os.path.join(self.folder, "claims.json")
        run.write(path, made)
        judged = claims.read(path)
        self.assertEqual(findings.paper(judged)["headline"], "2 of 3 statements hold under every convention of reading and every preload that the "
                         "numbers of the paper admit")
        self.assertEqual(findings.paper(judged)["text"], "Read by one convention, 2 statements hold; 1 is contradicted.")
        from pulloff_report.sections import claims as section
        data = section.build(sections.Source(None, None, None, judged)).data
        groups = data["groups"]
        self.assertEqual((data["unseen"], data["decided"], data["preloads"][0]["words"]), (1, [], ["far", "near"]))
        self.assertEqual(groups[0]["rows"][0]["change"], "half the force: 1.572, does not hold")
        self.assertEqual([[(row["claimed"], row["verdict"]["word"]) for row in group["rows"]] for group in groups],
                         [[("1.60", "contradicted")], [("1.57", "reproduced"), ("≥ 1.5", "reproduced")],
                          [("1.57", "implementation check passed")]])
        self.assertEqual([claim["id"] for claim in claims.contradicted(judged)], ["other"])
        made["claims"][0]["verdict"] = "believed"
        run.write(path, made)
        with self.assertRaisesRegex(ReportError, "believed"):
            claims.read(path)


def entry(name, *verdicts, kind=None, words=None):
    """A judged claim: of each choice the verdicts with half, once and twice the accuracy, its own words and its preload."""
    short = {"h": "within_reading", "c": "contradicted", "-": judge.NO_RESULT}
    parts = [{"words": f"{own}, at {place}", "own": own, "preload": place, "computed": 1.0 + number, "low": 2.0,
              "verdicts": dict(zip(judge.SCALES, (short[letter] for letter in letters))), "verdict": short[letters[1]]}
             for number, (letters, own, place) in enumerate(verdicts)]
    verdict = judge.overall([part["verdict"] for part in parts], bool(kind))
    return {"id": name, "tests": "made", "kind": kind, "choices": parts, "verdict": verdict}


class Robust(unittest.TestCase):
    """What follows from all claims: counts, preloads in common, sentences."""

    ALWAYS = entry("always", ("hhh", "one", 0), ("hhh", "one", 1))
    MOVES = entry("moves", ("chh", "one", 0), ("chh", "one", 1))
    LIGHT = entry("light", ("hhh", "one", 0), ("ccc", "one", 1))
    OWN = entry("own", ("hhh", "one", 0), ("hhh", "one", 1), ("ccc", "two", 0), ("ccc", "two", 1))
    NEVER = entry("never", ("ccc", None, 0), ("ccc", None, 1))
    CHECK = entry("check", ("hhh", None, None), kind=book.CHECK)

    def test_counts(self):
        found = robust.counts([self.ALWAYS, self.MOVES, self.LIGHT, self.OWN, self.NEVER, self.CHECK])
        cells = {(cell["scale"], cell["preload"]): (cell["holds"], cell["depends"], cell["contradicted"]) for cell in found["table"]}
        self.assertEqual((found["statements"], found["holds_always"], found["moved"]), (5, 1, 1))
        self.assertEqual([cells[key] for key in (("once", 0), ("once", 1), ("once", None), ("half", None))],
                         [(3, 1, 1), (2, 1, 2), (2, 2, 1), (1, 2, 2)])

    def survey(self, name, claimed, *numbers):
        return {"id": name, "figure": "9", "words": "force", "claimed": claimed, "tried": [
            {"words": f"Δ† = {place}", "approach": place, "computed": number,
             "holds": {scale: abs(number / claimed - 1) <= 0.1 * factor for scale, factor in judge.SCALES.items()}}
            for place, number in enumerate(numbers)]}

    def test_preloads_in_common(self):
        low, high = self.survey("low", 1, 1, 1.05, 2), self.survey("high", 10, 5, 11.5, 10)
        found = robust.common([low, high])
        self.assertEqual([found[key] for key in ("half", "once", "twice", "nearest", "numbers", "tried")],
                         [[], [], ["Δ† = 1"], "Δ† = 1", [1.05, 11.5], 3])
        self.assertIsNone(robust.common([]))
        judged = {"common": found, "surveys": [low, high]}
        text = findings.preload(judged)
        self.assertEqual(text["headline"], "No single preload gives the numbers of Figures 9 and 9")
        self.assertIn("|W̄| ≈ 1 of Figure 9 needs Δ† = 0 to 1; |W̄| ≈ 10 of Figure 9 needs Δ† of 2 and more", text["text"])
        both = robust.common([low, self.survey("high", 10, 5, 10, 10)])
        self.assertEqual(findings.preload({"common": both, "surveys": [low]})["headline"], "The preload Δ† = 1 gives the numbers of Figures 9")

    def test_sentences(self):
        rows = [self.ALWAYS, self.MOVES, self.LIGHT, self.OWN, self.NEVER, self.CHECK]
        def verdict(*names):
            return robust.sentence({"where": "Abstract", "quote": "so", "entries": list(names), "words": "It is {always}."}, rows, [])
        self.assertEqual([verdict(*names)["verdict"] for names in (("always",), ("always", "check"), ("always", "moves"), ("always", "never"),
                                                                   ("light",), ("never",))],
                         ["robust", "robust", "as_read", "in_part", "in_part", "fails"])
        self.assertEqual([verdict(name)["failing"] for name in ("light", "own", "never", "always")],
                         [[{"id": "light", "words": ["one, at 1"]}], [{"id": "own", "words": ["two"]}], [{"id": "never", "words": ["made"]}], []])
        self.assertEqual(verdict("moves")["convention"], ["moves"])

    def test_the_numbers_of_a_text_are_those_of_the_entries(self):
        rows, surveys = [self.OWN], [self.survey("low", 1, 1, 2)]
        self.assertEqual(robust.filled("{own}; {own | two}; {own | claimed}; {low}", rows, surveys), "1 to 4; 3 to 4; 2; 1 to 2")
        with self.assertRaisesRegex(book.BookError, "nowhere} is neither"):
            book.check_placeholders("{nowhere}", [], [], "made")
        with self.assertRaisesRegex(book.BookError, "has no choice three"):
            book.check_placeholders("{own | three}", [{"id": "own", "choice": [{"words": "one"}]}], [], "made")

    def test_no_number_of_the_first_page_is_written_by_hand(self):
        """A contradiction and a sentence have their computed numbers from the records: each names one at least."""
        found = book.read(run.LIST)
        self.assertEqual([part["quote"] for part in found.sentences if not book.placeholders(part["words"]) and part["entries"] != ["spherical-caps"]], [])
        self.assertEqual([claim["id"] for claim in found.claims if "brief" in claim and not book.placeholders(claim["brief"])], [])

    def test_a_survey_is_checked(self):
        survey = {"id": "made", "figure": "9", "words": "force", "claimed": 1.5, "reading": "about", "preloads": ["--preload 1", "--preload-load 2"],
                  "get": {"force": {"pulloff": "solve --tabor 3 {preload}", "at": "pull_off.force"}}}
        book.check_survey(survey, "made")
        self.assertEqual([book.preload_words(words) for words in survey["preloads"]], [("Δ† = 1", 1.0), ("load 2 πwR", None)])
        for change, message in (({"preloads": ["--preload 1"]}, "two or more"), ({"reading": None}, "reading is unknown"),
                                ({"preloads": ["1", "2"]}, "expected --preload NUMBER"), ({"value": "froce"}, "not got: froce")):
            with self.assertRaisesRegex(book.BookError, message):
                book.check_survey({**survey, **change}, "made")


class Preloads(unittest.TestCase):
    """Commands that differ only in the preload."""

    # A made-up branch: approach, load, and what is there. The force grows beyond the approaches -1, 4.8 and 14.4, and the loads
    # -0.01, 0.7 and 1.3.
    BRANCH = ((-3, -0.01, None), (-1, -1, "minimum"), (4, 0.7, "maximum"), (4.8, 0.6, "jump_in"), (3, -2, "minimum"), (2, -1, None),
              (14, 1.3, "maximum"), (14.4, 1.2, "jump_in"), (12, -1.5, "minimum"), (11, -1.4, "maximum"), (10, -3, "minimum"), (24, 4, None))
    VALUES = {"": (-2, 0, 1, 3, 4.8001, 5, 5.5, 6, 9, 20, 21), "-load": (0, 0.1, 0.2, 0.3, 0.65, 0.7, 0.8, 1.2, 2, 3)}

    def setUp(self):
        self.run, self.given = [], {}

    def document(self, line):
        """The branch up to a preload; it fails without a minimum before it, and at the preload 5.5."""
        self.run.append(line)
        _, of_load, value = preloads.scene_of(line)
        points = [{"position": place, "approach": approach, "load": load, "kind": kind, "load_error_estimate": 1e-9}
                  for place, (approach, load, kind) in enumerate(self.BRANCH)]
        key = "load" if of_load else "approach"
        end = next(place for place, point in enumerate(points) if point[key] >= value)
        minima = [-point["load"] for point in points[:end] if point["kind"] == "minimum"]
        if not minima or value == 5.5:
            return None
        return {"input": {"tabor": 3, "preload": value}, "pull_off": {"force": max(minima)}, "ended": {**points[end], key: value},
                "folds": [point for point in points[:end] if point["kind"] == "jump_in"],
                "extrema": [point | self.given for point in points[:end] if point["kind"] in ("minimum", "maximum")]}

    def lines(self, *kinds):
        return [f"solve --tabor 3 --preload{kind} {value} --tolerance 1e-3" for kind in kinds for value in sorted(self.VALUES[kind], reverse=True)]

    def shared(self, *kinds):
        return preloads.share([], self.lines(*kinds), self.document)

    def test_what_is_not_run_has_the_force_of_what_is_run(self):
        for kinds, most in ((("",), 4), (("-load",), 3), (("", "-load"), 5)):
            self.run = []
            shared = self.shared(*kinds)
            self.assertLessEqual(len(self.run), most)
            self.assertEqual(sorted([*shared, *self.run]), sorted(self.lines(*kinds)))
            for line, part in shared.items():
                self.assertEqual(part["input"], {"tabor": 3})
                if "5.5" not in line:
                    self.assertEqual(part["pull_off"], self.document(line)["pull_off"], line)

    def test_what_a_branch_does_not_decide_is_run(self):
        self.shared("", "-load")
        self.assertLess({line for line in self.lines("", "-load") if re.search("4.8001| 0.7| -2", line)}, set(self.run))
        self.run, self.given = [], {"load_error_estimate": None}    # forces without an error
        self.assertEqual((self.shared(""), sorted(self.run)), ({}, sorted(self.lines(""))))
        made = self.document("solve --preload 21")
        self.given = {}
        self.assertIsNone(preloads.force_at(made, False, 9))
        made = self.document("solve --preload 21")
        self.assertEqual(preloads.force_at(made, False, 9), 2)
        self.assertIsNone(preloads.force_at(made, False, 22))       # beyond its end
        made["pull_off"]["force"] = 2.5                             # not the depth of a minimum on it
        self.assertIsNone(preloads.force_at(made, False, 9))

    def test_which_commands_belong_together(self):
        lines = self.lines("", "-load")
        other = "solve --tabor 4 --preload 1"
        read = {line: ["pull_off.force", "input.tabor"] for line in reversed([*lines, other, "theory jkr --tabor 3 --preload-load 1"])}
        self.assertCountEqual(preloads.scenes(read), [([], lines), ([], [other])])
        for path in ("pull_off.approach", "input.preload", "input.preload_load", "folds.#"):
            read[lines[4]] = ["pull_off.force", path]
            self.assertIn(([lines[4]], lines[:4] + lines[5:]), preloads.scenes(read))


class Brief(unittest.TestCase):
    """What ./reproduce prints of the claims."""

    def test_the_counts_and_what_is_at_fault(self):
        rows = [{"id": "good", "verdict": "reproduced", "faults": [], "reason": None},
                {"id": "weak", "verdict": "reproduced", "faults": ["the answer stays"], "reason": None},
                {"id": "lost", "verdict": judge.NO_RESULT, "faults": [], "reason": "there is no record"}]
        made = {"claims": rows, "counts": {"reproduced": 2, "contradicted": 0, judge.NO_RESULT: 1}}
        command = "    /usr/bin/python3 reports/claims/run.py --claim"
        self.assertEqual(run.brief_of(made).splitlines(),
                         ["weak: the answer stays", f"{command} weak", "lost: there is no record", f"{command} lost",
                          "3 claims: 2 reproduced, 1 no result"])


if __name__ == "__main__":
    unittest.main()
