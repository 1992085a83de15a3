"""Tests of the campaign on staircases with a synthetic program: what it must accept, and what not."""

import json
import os
import unittest

import made_up
import staircase
import steps

# A program with a minimum of the load at approach -1, a jump of loading at approach 5 and load 2, and a greater
# pull-off beyond the jump. Before the jump the load falls from a maximum of 2.1 at approach 4; at approach 4.9 it falls
# below the load of the minimum. In load control the jump is at the load 2.1. FAULT: how a loop differs from this.
PROGRAM = """#!/usr/bin/python3
import json, os, sys
fault = json.loads(os.environ["FAULT"])
flags = dict(zip(sys.argv[2::2], sys.argv[3::2]))
t, want = float(flags["--tolerance"]), flags["--want"]
if float(flags["--tabor"]) > 4.5:
    sys.exit("pulloff: no such thing")
part = fault.get("part", 0.5)
soft, hard = 0.5 + part * t, 3 + part * t
def mark(kind, approach, load, position):
    return {"kind": kind, "approach": approach, "load": load, "position": position, "error_estimate": t,
            "load_error_estimate": t, "energy": 1.0}
document = {"status": "ok", "folds": [mark("jump_in", 5, 2, 3.0)],
            "extrema": [mark("minimum", -1, -0.5, 1.0), mark("maximum", 4, 2.1, 2.0), mark("minimum", 1, -3, 4.0)]}
def bound(approach, load, position=None):
    return {"approach": approach, "load": load, "position": position}
def step(begin, until, force, approach, *cycles):
    return {"preload": begin, "until": until, "open": until is None, "force": force, "error_estimate": t,
            "approach": approach, "approach_error_estimate": t, "cycles": list(cycles)}
def cycle(begin, energy, jumps):
    return {"preload": begin, "energy_lost": energy, "energy_lost_error_estimate": t, "jumps": jumps}
first, jump = bound(-1, -0.5, 1.0), bound(5, 2, 3.0)
if want == "preload":
    best = {"force": hard, "error_estimate": t, "preload": {"approach": 5, "load": 2}, "complete": True,
            "searched": {"approach": 20, "load": 30}}
    if "--approach-end" in flags:
        assert float(flags["--approach-end"]) == 40
        best["force"] += fault.get("longer", 0)
    top = bound(4, 2.1, 2.0)
    document.update(pull_off_any=best, work={"seconds": 0.1}, staircase={
        "displacement_control": {"steps": [step(first, bound(4.9, -0.5), soft, -1, cycle(first, 0, 0)),
                                           step(jump, None, hard, 1, cycle(jump, 7, 2))]},
        "load_control": {"steps": [step(bound(None, 0), top, soft, -1, cycle(bound(None, 0), None, 2)),
                                   step(top, None, hard, 1, cycle(top, None, 3))]}})
else:
    def loop(component, preload):
        jumped = preload > (5 if component == "approach" else 2.1) + fault.get("fold", 0)
        pull = {"force": hard + fault.get("force", 0), "approach": 1, "position": 4.0} if jumped else {
            "force": soft, "approach": -1, "position": 1.0}
        if component == "approach" and (preload < -1 or (4.9 < preload and not jumped)):
            off = fault.get("reversal", 0)
            pull = {"force": soft + off, "approach": preload - off, "position": 1.5}
        if component == "approach" and 4.8 < preload < 4.95 and "end" in fault:    # the step ends there otherwise
            pull = {"force": soft, "approach": -1, "position": 1.0} if preload > 4.9 else {
                "force": soft + fault["end"], "approach": preload, "position": 1.5}
        energy = None if component == "load" else 7 + fault.get("energy", 0) if jumped else 0
        return {"preload": {"approach": preload, "load": preload if component == "load" else fault.get("end", 0) - soft},
                "pull_off": pull, "energy_lost": energy, "energy_lost_error_estimate": t}
    if float(flags.get("--preload", 9)) < fault.get("refused", -1):
        document.update(status="not_found", reason="expected a harder preload")
    document["hysteresis"] = {
        "displacement_control": loop("approach", float(flags.get("--preload", 9))),
        "load_control": loop("load", float(flags.get("--preload-load", 9)))}
print(json.dumps(document))
"""


class Campaigns(made_up.Case):
    PROGRAM = PROGRAM

    def run_it(self, fault, *more):
        os.environ["FAULT"] = json.dumps(fault)
        return self.run_campaign(staircase.main, "--fresh", "--count", "2", "--tabor", "0.1:4", *more)

    def test_a_correct_staircase_is_accepted(self):
        code, text = self.run_it({})
        self.assertEqual(code, 0, text)
        # Both sides of the minimum, of the end of the first step and of the jump; in load control, only of the jump.
        self.assertIn("steps 8, loops 16", text)
        self.assertIn("0 of 2 scenes with a violation", text)

    def test_equal_tension_at_the_reversal_is_no_violation(self):
        code, text = self.run_it({"end": 1e-7})
        self.assertEqual(code, 0, text)
        self.assertIn("of these 4 with a tension at reversal as great", text)

    def test_a_loop_that_differs_is_a_violation(self):
        for fault, words in (({"fold": 1e-3}, "force"), ({"energy": 1e-2}, "energy lost"), ({"reversal": 1e-3}, "no step is said to hold"),
                             ({"end": 1e-3}, "force"), ({"refused": 3}, "expected a harder preload")):
            code, text = self.run_it(fault)
            self.assertEqual(code, 1, fault)
            self.assertIn("2 of 2 scenes with a violation", text)
            violated = [line for line in text.splitlines() if line.startswith("  ") and words in line]
            self.assertTrue(violated, (fault, text))

    def test_a_greater_pull_off_after_a_harder_preload_is_a_violation(self):
        self.assertEqual(self.run_it({}, "--complete")[0], 0)
        code, text = self.run_it({"longer": 1e-3}, "--complete")
        self.assertEqual(code, 1)
        self.assertIn("said of 2 of 2 scenes", text)

    def test_a_solve_without_a_document_is_a_failure(self):
        code, text = self.run_it({}, "--tabor", "4.6:4.9")
        self.assertEqual(code, 1)
        self.assertIn("crashed: scene 0: exit code 1: pulloff: no such thing", text)


class Places(unittest.TestCase):
    def test_number_of_compared_places_is_limited_and_includes_the_last(self):
        control = steps.CONTROLS[0]
        cycles = [{"preload": {"approach": float(k), "position": float(k)}, "energy_lost": 0.0} for k in range(20)]
        one = {"preload": cycles[0]["preload"], "until": None, "open": True, "cycles": cycles}
        document = {"folds": [], "extrema": [], "staircase": {control.name: {"steps": [one]},
                                                              "load_control": {"steps": []}}}
        self.assertEqual(len(steps.places(document, control)), 20)
        chosen = {place.value for _, place, _ in steps.loops(document, 5)}
        self.assertEqual(len(chosen), 5)
        self.assertTrue({0.0, 19.0} <= chosen)
        self.assertEqual(steps.said(document, control, 7.5)[1], cycles[7])
        self.assertIsNone(steps.said(document, control, -1.0))


if __name__ == "__main__":
    unittest.main()
