"""Tests of the comparison of energies: a state on a known curve, and what it must find."""

import math
import tempfile
import unittest

import draw
import energies


def curve(count):
    """Points of the branch approach = sin s, load = cos 2s, whose energy is the integral of load d(approach). It turns at
    s = pi/2, so that approaches occur twice."""
    points = []
    for k in range(count):
        s = 3.0 * k / (count - 1)
        points.append({"position": s, "approach": math.sin(s), "load": math.cos(2 * s),
                       "energy": math.sin(s) - 2.0 / 3.0 * math.sin(s)**3, "contact_radius": s,
                       "approach_rate": math.cos(s), "load_rate": -2 * math.sin(2 * s)})
    return points


class Energies(unittest.TestCase):
    def test_a_state_of_the_curve_is_not_off(self):
        tight = curve(120)
        for state in curve(37):
            off, miss = energies.energy_off(state, tight)
            self.assertLess(off, 2e-8, state)
            self.assertGreaterEqual(miss, 1e-8)

    def test_an_error_of_the_energy_is_found(self):
        tight = curve(120)
        for state in curve(37):
            off, _ = energies.energy_off(dict(state, energy=state["energy"] + 1e-5), tight)
            self.assertAlmostEqual(off, 1e-5, delta=1e-7)

    def test_violations_are_those_beyond_both_errors(self):
        task = energies.Task("made up", {})
        task.add("curve energy", "", 1e-6, 1.5e-6, 1e-6)
        self.assertEqual(task.violations, [])
        task.add("curve energy", "", 1e-6, 2.5e-6, 1e-6)
        self.assertEqual(len(task.violations), 1)
        task.add("curve energy", "", math.nan, 1.0, 0.0)      # nothing is stated
        self.assertEqual(len(task.violations), 1)

    def test_points_of_one_branch_alone_are_violations(self):
        """Forces and special points of the two solutions are compared beside their energies."""
        mark = {"kind": "minimum", "approach": -0.5, "load": -2.0, "position": 1.0, "contact_radius": 1.0, "error_estimate": 1e-6,
                "load_error_estimate": 1e-6, "contact_radius_error_estimate": 1e-6}
        one = {"folds": [], "extrema": [mark], "start": -9.0, "end": 1.0,
               "pull_off": {"force": 2.0, "approach": -0.5, "contact_radius": 1.0, "error_estimate": 1e-6}}
        task = energies.Task("made up", {})
        task.add_forces(one, one)
        self.assertEqual(task.violations, [])
        other = dict(mark, kind="maximum", approach=0.5, load=-1.0, position=2.0)
        task.add_forces(one, dict(one, extrema=[mark, other]))
        self.assertEqual([text.split()[0] for text in task.violations], ["missing"])

    def test_tables_and_steep_scenes_are_drawn_again_alike(self):
        with tempfile.TemporaryDirectory() as folder:
            scenes = [draw.table_scene(7, 2, folder) for _ in range(2)]
            with open(scenes[0]["profile-file"], encoding="utf-8") as stream:
                radii = [float(line.split(",")[0]) for line in stream.readlines()[1:]]
        self.assertEqual(*scenes)
        self.assertEqual(radii, sorted(set(radii)))
        self.assertGreater(len(radii), 11)
        profiles = {draw.steep_scene(7, k)["profile"].split(":")[0] for k in range(40)}
        self.assertEqual(profiles, {"cone", "power", "exact_sphere", "hyperboloid"})


if __name__ == "__main__":
    unittest.main()
