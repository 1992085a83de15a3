#!/usr/bin/python3
"""Whether constants.toml, the source, the results, doc/constants.md and doc/method.md agree; and the functions that measure."""

import os
import re
import tomllib
import unittest

import document
import measure
import outcome
import scan
import scenes


def labels():
    with open(os.path.join(measure.HERE, "constants.toml"), "rb") as stream:
        return set(tomllib.load(stream)["labels"])


class Agreement(unittest.TestCase):
    """Between the files."""

    def test_every_constant_is_listed(self):
        names = labels()
        found = {key for key in scan.constants(measure.ROOT) if key[1] not in names}
        listed = {(entry["file"], entry["name"]) for entry in measure.table()}
        self.assertEqual(sorted(found - listed), [], "add them to tests/constants/constants.toml")
        self.assertEqual(sorted(listed - found), [], "take them out of tests/constants/constants.toml")

    def test_kinds(self):
        for entry in measure.table():
            self.assertIn(entry["kind"], ("tuned", "limit", "derived", "stated"), entry["name"])
            self.assertTrue(entry["does"], entry["name"])

    def test_a_tuned_constant_that_changes_nothing_has_a_scene_and_a_test(self):
        idle = document.idle(document.rows())
        self.assertEqual([entry["name"] for entry in idle if not (entry.get("scene") and entry.get("test"))], [],
                         "say in tests/constants/constants.toml which scene needs them")
        for entry in measure.table():
            if "test" in entry:
                name = entry["test"].removeprefix("harness_")
                files = [file for folder in ("unit", "harness", "cli") for file in
                         (f"{folder}/test_{name}.c", f"{folder}/test_{name}.py")]
                self.assertTrue(any(os.path.exists(os.path.join(measure.ROOT, "tests", file)) for file in files), name)

    def test_every_measurement_is_of_the_present_value(self):
        stale = set(document.rows()) - measure.wanted_keys(scan.constants(measure.ROOT)) - {measure.UNCHANGED}
        self.assertEqual(sorted(stale), [], "run tests/constants/measure.py")

    def test_the_document_has_the_table(self):
        self.assertTrue(document.current() == "".join(document.lines()), "run tests/constants/document.py")

    def test_the_set_is_large_enough(self):
        commands = scenes.read()
        self.assertGreater(sum(words[0] == "solve" and "--scheme" not in words for words in commands), 100)
        self.assertEqual(len(commands), len({" ".join(words) for words in commands}))


class Method(unittest.TestCase):
    """What doc/method.md names is in the source."""

    def setUp(self):
        with open(os.path.join(measure.ROOT, "doc", "method.md"), encoding="utf-8") as stream:
            self.text = stream.read()

    def test_names(self):
        text = []
        for folder, _, files in os.walk(os.path.join(measure.ROOT, "src")):
            for file in files:
                if file.endswith((".c", ".h")):
                    with open(os.path.join(folder, file), encoding="utf-8") as stream:
                        text.append(file + "\n" + stream.read())
        words = set(re.findall(r"\w+(?:\.[ch]\b)?", "\n".join(text)))
        named = set(re.findall(r"\bpo_\w+(?:\.[ch]\b)?", self.text))
        self.assertEqual(sorted(named - words), [])

    def test_paths(self):
        named = set(re.findall(r"\b(?:src|tests|doc)/[\w/]+(?:\.\w+)?", self.text))
        self.assertEqual([path for path in sorted(named) if not os.path.exists(os.path.join(measure.ROOT, path))], [])


class Scan(unittest.TestCase):
    """Constants of a text."""

    def test_declarations(self):
        text = "/* static const double NO = 1; */\nstatic const double ONE = 0.5, TWO = 3.0 * (2.0 + 1.0);\n" \
               "enum { THREE = 3, FOUR = ONE_MORE + 1, FIVE };\nstatic const double LIST[] = {1.0, 2.0};\n" \
               "#define SIX 6\n  const double local = 1.0;\n"
        found = scan.in_text(text)
        self.assertEqual([part[:2] for part in found],
                         [("ONE", "0.5"), ("TWO", "3.0 * (2.0 + 1.0)"), ("THREE", "3"), ("SIX", "6")])
        for _, value, begin, end in found:
            self.assertEqual(text[begin:end], value)

    def test_tried_values(self):
        self.assertEqual(measure.tried({}, "12", "half"), "6")
        self.assertEqual(measure.tried({}, "1", "half"), "1")
        self.assertEqual(measure.tried({}, "1e-3", "twice"), "(2.0 * (1e-3))")
        self.assertEqual(measure.tried({"twice": "0.9"}, "0.5", "twice"), "0.9")


class Rows(unittest.TestCase):
    """Results that are kept."""

    def test_a_constant_that_moved_takes_its_rows_along(self):
        results = measure.Results(os.devnull)
        results.rows = {("a.c", "ONE", "1.0", "half"): {"file": "a.c"}, ("a.c", "TWO", "2.0", "half"): {"file": "a.c"}}
        results.keep({("b.c", "ONE", "1.0", "half"), ("b.c", "TWO", "3.0", "half")})
        self.assertEqual(results.rows, {("b.c", "ONE", "1.0", "half"): {"file": "b.c"}})


class Outcome(unittest.TestCase):
    """What documents are worth."""

    @staticmethod
    def document(force, **more):
        mark = {"kind": "minimum", "approach": -0.5, "load": -force, "position": 1.0, "error_estimate": 1e-6,
                "load_error_estimate": 1e-6, "contact_radius": 0.0, "unstable_modes": 0}
        work = {"newton_iterations": 10, "factorizations": 1, "kernel_evaluations": 100, "nodes": 20,
                "factorized_nodes": 10, "seconds": 0.1}
        best = {"force": force, "approach": -0.5, "error_estimate": 1e-6, "approach_error_estimate": 1e-6,
                "contact_radius": 0.0, "contact_radius_error_estimate": 0.0}
        return dict({"status": "ok", "input": {"tolerance": 1e-4}, "start": -4.0, "end": 1.0, "folds": [],
                     "extrema": [mark], "pull_off": best, "work": work}, **more)

    def row(self, ours, base, truth):
        tally = outcome.Tally()
        tally.add(ours, base, truth)
        return tally.row()

    def test_the_same(self):
        one = self.document(1.5)
        later = self.document(1.5, work=dict(one["work"], seconds=9.0))
        row = self.row(later, one, one)
        self.assertEqual((row["changed"], row["failed"], row["lost"], row["extra"], row["violated"]), (0, 0, 0, 0, 0))

    def test_an_error(self):
        row = self.row(self.document(1.5003), self.document(1.5), self.document(1.5))
        self.assertEqual((row["changed"], row["worst_error"]), (1, "2"))
        self.assertGreater(row["violated"], 0)

    def test_a_lost_point(self):
        row = self.row(self.document(1.5, extrema=[]), self.document(1.5), self.document(1.5))
        self.assertEqual(row["lost"], 1)

    def test_a_failure(self):
        row = self.row({"status": "crashed"}, self.document(1.5), self.document(1.5))
        self.assertEqual((row["failed"], row["changed"]), (1, 1))

    def test_what_has_no_tolerance(self):
        row = self.row(self.document(1.5 + 2.5e-6), self.document(1.5), None)
        self.assertEqual(row["moved"], "1e-06")

    def test_work(self):
        cost = outcome.cost([self.document(1.5)])
        self.assertEqual(cost["newton_iterations"], 10)
        self.assertEqual(cost["work"], 2.0 * 10 * (400 + 100) + 1000 / 3.0 + 60 * 100)


if __name__ == "__main__":
    unittest.main()
