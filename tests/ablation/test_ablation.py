#!/usr/bin/python3
"""Whether constants.toml, mechanisms.toml, the source, doc/mechanisms.md and doc/method.md agree; and the functions that
measure."""

import os
import re
import tomllib
import unittest

import ablate
import outcome
import scan
import scenes


class Agreement(unittest.TestCase):
    """Between the files."""

    def test_every_constant_is_listed(self):
        with open(os.path.join(ablate.HERE, "constants.toml"), "rb") as stream:
            kinds = tomllib.load(stream)
        labels = set(kinds.pop("labels"))
        self.assertEqual(set(kinds), {"tuned", "measured", "limit", "derived", "stated"})
        listed = [(file, name) for files in kinds.values() for file, names in files.items() for name in names]
        found = {key for key in scan.constants(ablate.ROOT) if key[1] not in labels}
        self.assertEqual(len(listed), len(set(listed)))
        self.assertEqual(sorted(found - set(listed)), [], "add them to tests/ablation/constants.toml")
        self.assertEqual(sorted(set(listed) - found), [], "take them out of tests/ablation/constants.toml")

    def test_every_mechanism_can_be_switched_off(self):
        for mechanism in ablate.mechanisms():
            for edit in ablate.edits_of(mechanism):
                with open(os.path.join(ablate.ROOT, edit["file"]), encoding="utf-8") as stream:
                    self.assertEqual(stream.read().count(edit["old"]), 1, f"{mechanism['name']}: {edit['old']}")
                self.assertNotEqual(edit["old"], edit["new"])

    def test_the_page_has_the_table(self):
        with open(ablate.PAGE, encoding="utf-8") as stream:
            self.assertTrue(stream.read() == ablate.page(ablate.read_rows()), "run tests/ablation/ablate.py --page")

    def test_the_sets(self):
        sets = scenes.read()
        self.assertEqual(list(sets), ["small", "wavy", "general", "soft"])
        commands = [" ".join(words) for set_of in sets.values() for words in set_of]
        self.assertEqual(len(commands), len(set(commands)))


class Method(unittest.TestCase):
    """What doc/method.md names is in the source."""

    def setUp(self):
        with open(os.path.join(ablate.ROOT, "doc", "method.md"), encoding="utf-8") as stream:
            self.text = stream.read()

    def test_names(self):
        text = []
        for folder, _, files in os.walk(os.path.join(ablate.ROOT, "src")):
            for file in files:
                if file.endswith((".c", ".h")):
                    with open(os.path.join(folder, file), encoding="utf-8") as stream:
                        text.append(file + "\n" + stream.read())
        words = set(re.findall(r"\w+(?:\.[ch]\b)?", "\n".join(text)))
        named = set(re.findall(r"\bpo_\w+(?:\.[ch]\b)?", self.text))
        self.assertEqual(sorted(named - words), [])

    def test_paths(self):
        named = set(re.findall(r"\b(?:src|tests|doc)/[\w/]+(?:\.\w+)?", self.text))
        self.assertEqual([path for path in sorted(named) if not os.path.exists(os.path.join(ablate.ROOT, path))], [])


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


class Outcome(unittest.TestCase):
    """What documents are worth."""

    @staticmethod
    def document(force, **more):
        mark = {"kind": "minimum", "approach": -0.5, "load": -force, "position": 1.0, "error_estimate": 1e-6,
                "load_error_estimate": 1e-6, "contact_radius": 0.0, "unstable_modes": 0}
        work = {"points": 5, "newton_iterations": 10, "factorizations": 1, "kernel_evaluations": 100, "nodes": 20,
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
        self.assertEqual(outcome.cost([self.document(1.5)])["newton_iterations"], 10)


if __name__ == "__main__":
    unittest.main()
