#!/usr/bin/python3
"""The measurement of costs on the smallest scenes, and the section of the report. test_cost.py PROGRAM"""

import copy
import json
import os
import subprocess
import sys
import tempfile
import types
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
sys.path.insert(0, os.path.join(ROOT, "reports"))
sys.path.insert(0, os.path.join(ROOT, "tests", "report"))

import synthetic  # noqa: E402
from pulloff_report import cost, errors, page  # noqa: E402
from pulloff_report.plots import cost as plot  # noqa: E402
from pulloff_report.sections import cost as section  # noqa: E402

PROGRAM = None
N, K = 12, 16  # nodes of a panel, and of the skeleton of a cell


def written(folder, document):
    path = os.path.join(folder, "cost.json")
    with open(path, "w", encoding="utf-8") as stream:
        json.dump(document, stream)
    return path


def section_text(document, paper=False):
    data = section.build(types.SimpleNamespace(cost=document)).data
    return page.environment().get_template("sections/cost.html").render(data=data, paper=paper)


class Measured(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "cost.json")
            subprocess.run([PROGRAM, "--few", path], check=True)
            cls.document = cost.read(path)

    def test_dense_operations(self):
        for mesh in self.document["meshes"]:
            nodes, active = mesh["nodes"], mesh["dense"]["active"]
            self.assertEqual(mesh["dense"]["product"]["flops"], 2 * nodes ** 2)
            self.assertAlmostEqual(mesh["dense"]["factors"]["flops"] / (2 / 3 * (active + 1) ** 3), 1, places=4)
            self.assertEqual(mesh["dense"]["solve"]["flops"], 2 * (active + 1) ** 2)
            self.assertLessEqual(active, nodes)

    def test_compressed_operations(self):
        """Inverse and products of every active panel, and between 4 and 11 products of two blocks in each cell above."""
        for mesh in self.document["meshes"]:
            panels = mesh["hierarchical"]["active"] / N
            of_panels = panels * 2 * N * (N * N + 2 * N * K + K * K)
            found = mesh["hierarchical"]["factors"]["flops"] - of_panels
            self.assertGreaterEqual(found, (panels - 1) * 8 * K ** 3)
            self.assertLessEqual(found, (panels - 1) * 22 * K ** 3 + 32 * 8 * K ** 3)  # and the cells between the outer ones

    def test_both_ways_solve_the_same(self):
        for mesh in self.document["meshes"]:
            self.assertGreater(mesh["hierarchical"]["newton_iterations"], 1)
            self.assertLess(abs(mesh["hierarchical"]["newton_iterations"] - mesh["dense"]["newton_iterations"]), 6)

    def test_no_rate_above_the_machine(self):
        """The rates of matrices that are not in the cache at once: at most twice that of a large product."""
        machine = self.document["machine"]
        for part, way, _, rate in plot.rates(self.document)[0]:
            self.assertLess(rate, 2 * machine["flops_single"], (part, way))

    def test_waves_and_section(self):
        self.assertEqual([wave["waves"] for wave in self.document["waves"]],
                         sorted(wave["waves"] for wave in self.document["waves"]))
        self.assertIn("Every mesh", section_text(self.document))


class Drawn(unittest.TestCase):
    def test_exponents_are_those_of_the_data(self):
        found = plot.exponents(synthetic.cost_document(1.25, 2.75, 1.5))
        for name, power in {"hierarchical": 1.25, "hierarchical solve": 1.25, "dense": 2.75, "dense product": 2.75, "trace": 1,
                            "waves solve": 1.5, "waves points": 0}.items():
            self.assertAlmostEqual(found[name], power if name != "trace" else 1, places=9, msg=name)

    def test_crossover(self):
        self.assertEqual(section.crossover(synthetic.cost_document(1.25, 2.75, 1.5)), 250)
        self.assertIsNone(section.crossover(synthetic.cost_document(2.75, 1.25, 1.5)))

    def test_both_forms(self):
        document = synthetic.cost_document(1.25, 2.75, 1.5)
        self.assertIn("equilibrium 1.25", section_text(document))
        self.assertNotIn("Every mesh", section_text(document, paper=True))

    def test_without_a_measurement(self):
        self.assertEqual(section.build(types.SimpleNamespace(cost=None)).absent, "the cost of an equilibrium (./reproduce --only cost)")
        self.assertIsNone(cost.read("/nowhere/cost.json"))

    def test_wrong_documents_are_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            for change in (lambda d: d.update(schema="other"), lambda d: d["machine"].pop("bytes"),
                           lambda d: d["meshes"][0]["dense"].update(solve=1), lambda d: d["waves"][0].pop("trace")):
                document = copy.deepcopy(synthetic.cost_document(1.25, 2.75, 1.5))
                change(document)
                with self.assertRaises(errors.ReportError):
                    cost.read(written(folder, document))


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
