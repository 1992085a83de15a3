"""The judgement of the published table of viscoelastic pull-offs: verdicts, and the cause that is shown for each row."""

import csv
import json
import os
import pathlib
import stat
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
TREE = os.path.join(HERE, "..", "..")
RATE = os.path.join(TREE, "reports", "rate")
sys.path.insert(0, RATE)

import judge  # noqa: E402
import solve_rows  # noqa: E402

# A program whose pull-off force is 3 (1 + 1e-3 lg V) and whose relaxed contact is as wide as the preload; cut at R, it is 1 % less.
PROGRAM = """#!/usr/bin/python3
import json, math, sys
given = dict(zip(sys.argv[2::2], sys.argv[3::2]))
open(__file__ + ".asked", "a").write("x")
if given["--tabor"] == "9":
    print(json.dumps({"status": "out_of_time", "reason": "made up", "work": {"seconds": 1.0}}))
    sys.exit(3)
force = 3.0 * (1.0 + 1e-3 * math.log10(float(given["--unload-speed"]))) * (0.99 if given["--outer-radius"] == "100" else 1.0)
begin = {"contact_radius": float(given["--preload"]), "load": 1.0}
print(json.dumps({"status": "ok", "reason": "", "work": {"seconds": 0.5},
                  "pull_off": {"force": force, "error_estimate": 1e-5, "approach": 0.0, "contact_radius": 1.0},
                  "unloading": {"begin": begin, "jumps": 0, "steps": 9, "end": {"energies": {"work": 1.0, "dissipated": 0.5}}}}))
"""
# approach, Tabor parameter, lg V, force over the true one, and the cause
ROWS = ((10, 1, 1, 1.0005, None), (10, 2, 1, 1.02, "repeated"), (10, 2, 1, 0.995, "repeated"), (20, 1, 1, 1.004, "falls"), (20, 1, 2, 0.985, "falls"),
        (110, 1, 1, 0.98, "cut"), (90, 1, 1, 0.989, "cut"), (80, 1, 1, 1.05, "none shown"), (30, 1, 1, 0.95, "none shown"),
        (40, 9, 1, 1.0, "failed"))


class Judged(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.program = os.path.join(self.folder.name, "program")
        pathlib.Path(self.program).write_text(PROGRAM)
        os.chmod(self.program, os.stat(self.program).st_mode | stat.S_IXUSR)
        lines = ["runload,alphaload,mu,k,n,outputAmplification,workofSepration"]
        for approach, tabor, decade, ratio, _ in ROWS:
            force = 3.0 * (1.0 + 1e-3 * decade) * ratio
            lines.append(f"-{10**decade},{approach},{tabor},0.1,0.6,{force / 1.5!r},0")
        pathlib.Path(self.folder.name, "comb_1to9.csv").write_text("\n".join(lines) + "\n")

    def judge(self, *options):
        words = [sys.executable, os.path.join(RATE, "judge.py"), self.program, self.folder.name, self.folder.name, "--coarse", "0", *options]
        ended = subprocess.run(words, capture_output=True, text=True, check=False)
        return ended, json.loads(pathlib.Path(self.folder.name, "table.json").read_text())

    def asked(self):
        return len(pathlib.Path(self.program + ".asked").read_text())

    def test_causes(self):
        ended, found = self.judge()
        self.assertEqual(ended.returncode, 3, ended.stderr)
        self.assertIn("comb_1to9.csv:11: made up", ended.stdout)
        self.assertEqual((found["rows"], found["solved"], found["off"]), (len(ROWS), len(ROWS) - 1, len(ROWS) - 2))
        for cause in judge.CAUSES:
            self.assertEqual(found["causes"][cause]["rows"], sum(row[4] == cause for row in ROWS), cause)
        self.assertAlmostEqual(found["all"]["greatest"], 0.05, 9)
        self.assertAlmostEqual(found["all"]["within"][1], 3 / 9, 9)
        self.assertEqual(found["none_shown_beyond"], [2, 2, 2])

    def test_results_are_kept(self):
        self.judge()
        solved = self.asked()
        self.assertEqual(solved, len(ROWS) - 1 + 2)  # the repeated row once; two wide contacts on a surface that is cut
        store = next(pathlib.Path(self.folder.name).glob("rows-*.csv"))
        self.judge()
        self.assertEqual(self.asked(), solved)
        store.write_text(store.read_text()[:-9])  # an interruption cuts the last line
        self.judge()
        self.assertLessEqual(self.asked(), solved + 1)
        pathlib.Path(self.program).write_text(PROGRAM + "# another program\n")
        self.judge()
        self.assertGreaterEqual(self.asked(), 2 * solved)

    def test_a_sample(self):
        _, found = self.judge("--sample", "4", "--seed", "3")
        self.assertEqual(found["rows"], 4)

    def test_the_step_that_leads_to_a_force(self):
        for wanted, forces, step in ((3.1, (3.2, 3.4), 0.05), (3.3, (3.2, 3.4), 0.15), (2.9, (3.2, 3.4), None), (3.3, (3.2, None), None),
                                     (2.9, (2.5, 2.9), 0.02), (3.201, (3.2, None), 0.1), (3.1, (None, 3.2), None)):
            found = judge.coarse_step((0.1, 0.2), forces, 3.0, wanted)
            self.assertEqual(found is None, step is None, (wanted, forces))
            if step:
                self.assertAlmostEqual(found, step)

    def test_a_coarse_march(self):
        """Its error is of first order, and positive where the body creeps. Given: the first row of reference/viscoelastic.csv."""
        with open(os.path.join(TREE, "reference", "viscoelastic.csv"), encoding="utf-8") as stream:
            first = next(csv.DictReader(line for line in stream if not line.startswith("#")))
        self.assertEqual((first["tabor"], first["viscoelastic"], first["preload"], first["unload_speed"]), ("1", "sls:0.1", "5", "1"))
        words = [sys.executable, os.path.join(TREE, "reference", "make", "coarse_steps.py"), "1", "sls:0.1", "5", "1", "0.1", "0.05"]
        lines = subprocess.run(words, capture_output=True, text=True, check=True).stdout.splitlines()
        errors = [float(line.rpartition(" ")[2]) - float(first["force"]) for line in lines]
        self.assertGreater(errors[1], 1e-3)
        self.assertAlmostEqual(errors[0] / errors[1], 2.0, 1)

    def test_a_folder_without_the_table(self):
        with self.assertRaisesRegex(SystemExit, "none of comb_1to9.csv"):
            solve_rows.read_table(os.path.join(self.folder.name, "none"))


if __name__ == "__main__":
    unittest.main()
