"""Tests of the campaign with synthetic solutions: which it must accept, and which not."""

import json
import os
import subprocess
import unittest

import campaign
import compare
import draw
import made_up
import reference

# A program whose true errors are FAULT times those that it states, which fails at Tabor parameters above 9 and refuses
# those above 10. It records each call in the file CALLS.
PROGRAM = """#!/usr/bin/python3
import json, os, sys
with open(os.environ["CALLS"], "a") as stream:
    stream.write(" ".join(sys.argv) + "\\n")
flags = dict(zip(sys.argv[2::2], sys.argv[3::2]))
t, tabor = float(flags["--tolerance"]), float(flags["--tabor"])
if tabor > 9:
    sys.stderr.write("pulloff: no such thing")
    sys.exit(2 if tabor > 10 else 1)
off = t * float(os.environ["FAULT"])
best = {"force": 1.5 + off, "approach": -tabor + 10 * off, "contact_radius": 3 + off, "error_estimate": t,
        "approach_error_estimate": 10 * t, "contact_radius_error_estimate": t}
mark = {"kind": "minimum", "approach": best["approach"], "load": -best["force"], "error_estimate": 10 * t,
        "load_error_estimate": t, "contact_radius": best["contact_radius"], "contact_radius_error_estimate": t,
        "position": 1.0}
print(json.dumps({"status": "ok", "start": -20, "end": 5, "pull_off": best, "folds": [], "extrema": [mark]}))
"""


def mark(kind, approach, load, error=1e-4, position=None, **more):
    return {"kind": kind, "approach": approach, "load": load, "error_estimate": error, "load_error_estimate": error,
            "contact_radius": 2.0, "contact_radius_error_estimate": error,
            "position": approach if position is None else position, **more}


def document(folds=(), extrema=((-1.0, -1.5),), end=5.0, error=1e-4, **more):
    """A solution, whose pull-off is the deepest of its minima."""
    minima = [mark("minimum", approach, load, error) for approach, load in extrema]
    best = dict(min(minima, key=lambda one: one["load"]), **more)
    return {"status": "ok", "start": -9.0, "end": end, "folds": list(folds), "extrema": minima,
            "pull_off": {"force": -best["load"], "approach": best["approach"], "error_estimate": error,
                         "approach_error_estimate": error, "contact_radius": best["contact_radius"],
                         "contact_radius_other": best.get("contact_radius_other"),
                         "contact_radius_error_estimate": error}}


def tight(*args, **more):
    return document(*args, error=1e-7, **more)


def verdicts(comparison, quantity):
    return [finding.verdict for finding in comparison.findings if finding.quantity == quantity]


class Comparisons(unittest.TestCase):
    def check(self, loose, other, violations):
        found = compare.compare(loose, other)
        self.assertEqual(len(found.violations), violations, found.violations)
        return found

    def test_a_difference_within_both_errors_is_held_open_or_violated(self):
        for difference, own, verdict in ((0.9e-4, 1e-7, "held"), (0.995e-4, 1e-6, "open"), (1.005e-4, 1e-6, "open"),
                                         (1.1e-4, 1e-6, "violated"), (1.005e-4, 1e-7, "violated")):
            self.assertEqual(compare.Finding("force", "", 1e-4, difference, own).verdict, verdict, difference)

    def test_every_quantity_of_the_pull_off_is_compared(self):
        found = self.check(document(), tight(), 0)
        for quantity in ("force", "approach", "contact radius"):
            self.assertEqual(verdicts(found, quantity), ["held"])
        found = self.check(document(extrema=[(-1.0, -1.5004)]), tight(), 2)     # also that of the extremum
        self.assertEqual(verdicts(found, "force"), ["violated"])
        found = self.check(document(contact_radius=2.01), tight(), 1)
        self.assertEqual(verdicts(found, "contact radius"), ["violated"])

    def test_numbers_without_a_stated_error_are_counted_separately(self):
        loose = document()
        loose["pull_off"]["error_estimate"] = None
        self.assertEqual(verdicts(self.check(loose, tight(), 0), "force"), ["unstated"])

    def test_either_of_two_stated_radii_may_be_correct(self):
        found = self.check(document(contact_radius=9.0, contact_radius_other=2.0), tight(), 0)
        self.assertTrue(found.undecided)
        self.check(document(contact_radius=9.0, contact_radius_other=5.0), tight(), 1)

    def test_points_beyond_the_end_of_one_trace_are_not_compared(self):
        shorter, longer = [(-1.0, -1.5)], [(-1.0, -1.5), (6.0, -1.7)]
        found = self.check(document(extrema=shorter), tight(extrema=longer, end=9.0), 0)
        self.assertTrue(found.ended_apart and found.beyond)
        self.assertEqual(verdicts(found, "force"), ["held"])
        self.check(document(extrema=shorter, end=9.0), tight(extrema=longer, end=9.0), 2)   # minimum and force

    def test_missing_and_additional_folds_are_violations(self):
        pair = [mark("jump_in", -1.0, -0.7, position=1.0), mark("jump_out", -1.4, -1.0, position=2.0)]
        more = pair + [mark("jump_in", -0.5, -0.3, position=3.0), mark("jump_out", -0.8, -0.2, position=4.0)]
        found = self.check(document(folds=pair), tight(folds=more), 2)
        self.assertEqual((len(found.missing), len(found.added)), (2, 0))
        found = self.check(document(folds=more), tight(folds=pair), 2)
        self.assertEqual((len(found.missing), len(found.added)), (0, 2))
        self.assertEqual(len(verdicts(found, "fold approach")), 2)

    def test_a_pair_below_the_stated_errors_is_no_violation(self):
        faint = [mark("jump_in", -0.5, -0.3, position=3.0), mark("jump_out", -0.50005, -0.3, position=4.0)]
        self.assertEqual(self.check(document(), tight(folds=faint), 0).faint, 2)
        self.check(document(error=1e-5), tight(folds=faint), 2)


class Draws(unittest.TestCase):
    RANGES = vars(campaign.arguments([]))

    def test_scene_k_stays_the_same(self):
        self.assertEqual(draw.scene(1, 0, self.RANGES), draw.scene(1, 0, self.RANGES))
        self.assertNotEqual(draw.scene(1, 0, self.RANGES), draw.scene(2, 0, self.RANGES))
        # The same scenes of the case `random` as in tests/harness/test_sample.c.
        for k, tabor, radius in ((199, 0.00108449, 52.0513), (999, 0.00416498, 113.855)):
            self.assertEqual(draw.between((1e-3, 10), draw.uniform(20200908, k, "tabor")), tabor)
            self.assertEqual(draw.between((30, 500), draw.uniform(20200908, k, "radius")), radius)


class Campaigns(made_up.Case):
    PROGRAM = PROGRAM

    def calls(self):
        with open(os.path.join(self.folder.name, "calls"), encoding="utf-8") as stream:
            return len(stream.readlines())

    def run_it(self, fault, *more):
        os.environ.update(FAULT=str(fault), CALLS=os.path.join(self.folder.name, "calls"))
        return self.run_campaign(campaign.main, "--count", "6", "--tabor", "0.1:8", *more)

    def test_violated_errors_are_reported(self):
        self.assertEqual(self.run_it(0.5)[0], 0)
        code, text = self.run_it(3, "--fresh")
        self.assertEqual(code, 1)
        self.assertIn("6 of 6 scenes with a violation", text)
        command = next(line for line in text.splitlines() if line.startswith("  pulloff solve --tabor"))
        done = subprocess.run([self.program, *command.split()[1:]], capture_output=True, check=True)
        self.assertEqual(json.loads(done.stdout)["status"], "ok")

    def test_solutions_are_kept(self):
        self.run_it(0.5)
        self.assertEqual(self.calls(), 12)
        self.run_it(0.5, "--count", "7")
        self.assertEqual(self.calls(), 14)
        with open(os.path.join(self.folder.name, "journal"), "r+", encoding="utf-8") as stream:
            text = stream.read()
            stream.seek(0)
            stream.truncate(len(text) - 20)                 # as if it was killed while writing a line
        self.assertEqual(self.run_it(0.5, "--count", "7")[0], 0)
        self.assertEqual(self.calls(), 15)
        self.run_it(0.5, "--count", "7")
        self.assertEqual(self.calls(), 15)

    def test_a_solve_without_a_document_is_a_failure(self):
        code, text = self.run_it(0.5, "--tabor", "9.5:9.9")
        self.assertEqual(code, 1)
        self.assertIn("crashed: scene 0: exit code 1: pulloff: no such thing", text)

    def test_a_refusal_is_not_a_failure(self):
        code, text = self.run_it(0.5, "--tabor", "8:11", "--count", "12")
        self.assertRegex(text, r"loose crashed \d+, loose refused \d+")
        self.assertNotIn("exit code 2", text)
        self.assertEqual((code, self.run_it(0.5, "--tabor", "10.5:11")[0]), (1, 3))


class References(unittest.TestCase):
    def test_reference_tables_become_documents(self):
        documents = reference.documents()
        self.assertGreater(len(documents), 30)
        flags, smooth = next((flags, one) for flags, one in documents if flags["tabor"] == 1 and len(flags) == 3)
        self.assertEqual(flags, {"tabor": 1.0, "radius": 100.0, "outer-radius": "inf"})
        self.assertAlmostEqual(smooth["pull_off"]["contact_radius"], 13.568208, 6)
        self.assertFalse(compare.compare(smooth, smooth).violations)


if __name__ == "__main__":
    unittest.main()
