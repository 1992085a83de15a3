#!/usr/bin/python3
"""The Python module, beside the program: the same numbers to the last bit.

Usage: test_pulloff.py PROGRAM. PULLOFF_LIBRARY and PYTHONPATH lead to the library and the module."""

import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy as np

import pulloff

PROGRAM = sys.argv.pop(1)
SOURCE = pathlib.Path(__file__).resolve().parents[2]


def program(*words):
    said = subprocess.run([PROGRAM, *words, "--json"], capture_output=True, text=True, check=True)
    return json.loads(said.stdout)


def timeless(document):
    """A document without the times, which differ from solve to solve."""
    if isinstance(document, dict):
        return {key: timeless(value) for key, value in document.items() if key != "seconds"}
    return [timeless(item) for item in document] if isinstance(document, list) else document


def column(document, name):
    return np.array([math.nan if row[name] is None else row[name] for row in document])


class SameNumbers(unittest.TestCase):
    def test_documents(self):
        for keys in ({"tabor": 1, "preload_load": 1},
                     {"tabor": 2.5, "amplitude": 0.9, "wavelength": 21, "want": "curve,profile,hysteresis,preload,theories"},
                     {"tabor": 0.7, "scheme": "triangle", "nodes": 81, "outer_radius": 100, "want": "curve"},
                     {"tabor": 1, "law": "mie:4,10", "preload": 0.5},
                     {"tabor": 0.1 + 0.2, "want": "profile", "profile_approach": -1.25}):
            words = [word for key, value in keys.items() for word in ("--" + key.replace("_", "-"), str(value))]
            self.assertEqual(timeless(program("solve", *words)), timeless(pulloff.solve(**keys).document), keys)

    def test_uncertain_numbers(self):
        """The names of the sources had the dashes of the options in the program, and the digests differed."""
        keys = {"modulus_pa": "2e9", "work_j_per_m2": "0.05+-0.002", "distance_m": "3e-10", "radius_m": "1e-8+-1e-9"}
        words = [word for key, value in keys.items() for word in ("--" + key.replace("_", "-"), value)]
        shown, result = program("solve", "--from-physical", *words), pulloff.solve(**keys)
        self.assertEqual(shown["digest"], result.document["digest"])
        self.assertEqual(timeless(shown)["uncertainty"], timeless(result.document)["uncertainty"])
        self.assertEqual([source["source"] for source in shown["uncertainty"]["sources"]], ["work_j_per_m2", "radius_m"])

    def test_arrays(self):
        result = pulloff.solve(tabor=3, amplitude=1, wavelength=20, outer_radius=100, want=["curve", "profile"])
        shown = program("solve", "--tabor", "3", "--amplitude", "1", "--wavelength", "20", "--outer-radius", "100", "--want",
                        "curve,profile")
        for name in ("curve", "profile", "folds", "extrema"):
            array = getattr(result, name)
            self.assertGreater(len(array), 1)
            self.assertEqual(len(array), len(shown[name]))
            for field in array.dtype.names:
                key = "error_estimate" if field == "approach_error" else field.replace("_error", "_error_estimate")
                np.testing.assert_array_equal(array[field], column(shown[name], key) if field != "kind"
                                              else [row["kind"] for row in shown[name]])
        self.assertEqual(result.pull_off.force, shown["pull_off"]["force"])
        self.assertEqual(result.pull_off.force_error, shown["pull_off"]["error_estimate"])
        self.assertEqual(result.pull_off.contact_radius, shown["pull_off"]["contact_radius"])
        self.assertEqual(result["ended"], shown["ended"])
        self.assertEqual(len(pulloff.solve(tabor=1).curve), 0)

    def test_theory(self):
        shown = program("theory", "guduru", "--tabor", "5", "--amplitude", "10", "--wavelength", "20",
                        "--contact-radius", "12")
        self.assertEqual(pulloff.theory("guduru", tabor=5, amplitude=10, wavelength=20, at=12),
                         {key: value for key, value in shown.items() if key not in ("schema", "theory")})
        wavy = dict(tabor=5, amplitude=2, wavelength=20)
        shown = program("theory", "guduru", "--tabor", "5", "--amplitude", "2", "--wavelength", "20", "--preload-load", "1",
                        "--load", "-0.7")
        found = pulloff.theory("guduru", **wavy, preload_load=1, load=-0.7, want="curve")
        curve = found.pop("curve")
        self.assertEqual(found | {"digest": ""}, {key: value for key, value in shown.items() if key not in ("schema", "theory")} | {"digest": ""})
        self.assertAlmostEqual(curve["load"][-1], found["reversal_load"], 12)
        self.assertEqual(curve["stable_at_load"].dtype, bool)
        gelatin = dict(modulus_pa=7e5, work_j_per_m2=0.03, distance_m=3e-10, radius_m=0.0125)
        at = pulloff.theory("jkr", **gelatin, load_n=0)
        self.assertAlmostEqual(at["contact_radius"] * 3e-10 / (4.5 * np.pi * 0.03 * 0.0125**2 / 7e5)**(1 / 3), 1, 12)
        self.assertEqual(pulloff.theory("jkr", contact_radius=3.0), pulloff.theory("jkr", at=3.0))
        for wrong, text in (({"load": 0, "at": 1}, "load and at are given: expected one of them"),
                            ({"load": 0, "approach": 1}, "load, approach are given: expected one of them"),
                            ({"load": np.inf}, "load is inf: expected a finite number"),
                            ({"load": -1.6}, "the JKR theory has no stable state at load -1.6: the lowest of all states is -1.5"),
                            ({"load": "x"}, "load is 'x': expected a finite number, or None")):
            with self.assertRaisesRegex(pulloff.Error, text):
                pulloff.theory("jkr", **wrong)
        self.assertIsNone(pulloff.theory("crest", amplitude=0)["crest_radius"])

    def test_compare(self):
        rows = pulloff.Scene(tabor=3, amplitude=1, wavelength=20).compare(preload=1)
        shown = program("compare", "--tabor", "3", "--amplitude", "1", "--wavelength", "20", "--preload", "1")["theories"]
        self.assertEqual([{"theory": name, **row} for name, row in rows.items()], shown)
        self.assertEqual(pulloff.Scene().compare()["kesari-lew"]["reason"], "the surface has no waves")
        self.assertFalse(any("parabola" in row for row in rows.values()))
        wide = pulloff.Scene(tabor=20, tolerance=1e-3).compare()  # the contact radius is 0.68 R
        self.assertEqual([name for name, row in wide.items() if "parabola" in row],
                         [name for name, row in wide.items() if row["assumptions"] == "yes"])
        self.assertEqual(wide["jkr"]["parabola"], {"contact_radius_over_radius": wide["maugis"]["parabola"]["contact_radius_over_radius"],
                                                   "limit": 0.3, "exact_sphere": 100})

    def test_series(self):
        shown = program("follow", "--key", "tabor", "--from", "0.5", "--to", "2", "--points", "7", "--scale", "linear")
        values = [point["input"]["tabor"] for point in shown["points"]]
        results = pulloff.follow("tabor", values)
        self.assertEqual([timeless(one.document)["pull_off"] for one in results],
                         [point["pull_off"] for point in shown["points"]])
        self.assertTrue(any(one["followed"] for one in results))

    def test_a_file_that_changes(self):
        """A table that is written again under its name is read again."""
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "tip.csv")
            forces = []
            for radius in 100, 50, 100:
                path.write_text("r,gap\n" + "".join(f"{r},{r * r / (2 * radius)}\n" for r in range(0, 61, 2)), encoding="utf-8")
                forces.append(pulloff.solve(profile_file=str(path), coupling=0.1)["pull_off"]["force"])
        self.assertEqual(forces[0], forces[2])
        self.assertGreater(forces[0], 1.9 * forces[1])

    def test_si_units(self):
        words = {"modulus": "2e9", "work": "0.05", "distance": "3e-10", "radius": "1e-7"}
        shown = program("solve", "--from-physical", "--modulus-pa", "2e9", "--work-j-per-m2", "0.05", "--distance-m",
                        "3e-10", "--radius-m", "1e-7", "--want", "profile")
        scene = pulloff.Scene.physical(**{key: float(value) for key, value in words.items()}, want="profile")
        result = scene.solve()
        physical = shown.pop("physical")
        self.assertEqual(timeless(shown), timeless(result.document))
        self.assertEqual(result.units, scene.units)
        self.assertEqual(result.pull_off.force * result.units.force, physical["pull_off"]["force_n"])
        self.assertEqual(scene.units.length, physical["units"]["length_m"])
        self.assertEqual(scene.units.traction, physical["units"]["traction_pa"])
        self.assertIsNone(pulloff.Scene(tabor=2).units)

    def test_two_bodies(self):
        shown = program("solve", "--from-physical", "--young-pa", "9e9,2e9", "--poisson", "0.22,0.4", "--radius-m", "2e-8,5e-8",
                        "--work-j-per-m2", "0.05", "--distance-m", "3e-10")
        shown.pop("physical")
        rest = {"work_j_per_m2": 0.05, "distance_m": 3e-10}
        for young, poisson, radius in (((9e9, 2e9), [0.22, 0.4], (2e-8, 5e-8)), ("9e9,2e9", ("0.22", "0.4"), "2e-8,5e-8")):
            result = pulloff.solve(young_pa=young, poisson=poisson, radius_m=radius, **rest)
            self.assertEqual(timeless(shown), timeless(result.document))
        for wrong in (9e9, 2e9, 1e9), (9e9, None), True:
            with self.assertRaisesRegex(pulloff.Error, "^young_pa is .*: expected .*, or a pair"):
                pulloff.Scene(young_pa=wrong, poisson=(0.3, 0.3), radius_m=1e-8, **rest)

    def test_surface_energies(self):
        rest = {"modulus_pa": 2e9, "distance_m": 3e-10, "radius_m": 1e-8}
        one = pulloff.solve(work_j_per_m2=0.0625, **rest)
        for energies in ((0.0625, 0.03125, 0.03125), [0.03125, "0.03125"], "0.03125,0.03125"):
            result = pulloff.solve(surface_energies_j_per_m2=energies, **rest)
            self.assertEqual((result.document["digest"], result.units), (one.document["digest"], one.units))
        for wrong in (0.03125,), 0.03125, (0.1, 0.2, 0.3, 0.4), (0.1, None), (0.1, 0.1, 0.2):
            with self.assertRaisesRegex(pulloff.Error, "^surface_energies_j_per_m2 is .*: expected G1,G2 or G1,G2,G12"):
                pulloff.solve(surface_energies_j_per_m2=wrong, **rest)
        with self.assertRaisesRegex(pulloff.Error, "expected it to be left out beside work_j_per_m2"):
            pulloff.solve(surface_energies_j_per_m2=(0.03, 0.03), work_j_per_m2=0.06, **rest)

    def test_keys_in_si_units(self):
        tip = {"modulus_pa": 2e9, "work_j_per_m2": 0.05, "distance_m": 3e-10, "radius_m": 1e-7}
        options = ["--from-physical"] + [word for key, value in {**tip, "preload_load_n": 2e-9, "stiffness_n_per_m": 2.0}.items()
                                         for word in ("--" + key.replace("_", "-"), repr(value))]
        shown = program("solve", *options)
        shown.pop("physical")
        result = pulloff.solve(**tip, preload_load_n=2e-9, stiffness_n_per_m=2.0, want="hysteresis")
        self.assertEqual(timeless(shown), timeless(result.document))
        del tip["radius_m"]
        values = [1e-7, 2e-7, 3e-7]
        results = pulloff.follow("radius_m", values, **tip)
        for radius, one in zip(values, results):
            self.assertEqual(one.units.force, math.pi * 0.05 * radius)
            alone = pulloff.solve(radius_m=radius, **tip)
            self.assertAlmostEqual(one.pull_off.force / alone.pull_off.force, 1, 6)
        with self.assertRaisesRegex(pulloff.Error, "radius_m is missing: expected a finite number > 0, or two .*; .*"):
            pulloff.solve(**tip)
        with self.assertRaisesRegex(pulloff.Error, "expected only one of preload_load and preload_load_n"):
            pulloff.solve(**tip, radius_m=1e-7, preload_load=1, preload_load_n=1e-9)


class Scenes(unittest.TestCase):
    def test_shown(self):
        self.assertEqual(repr(pulloff.Scene(tabor=3, amplitude=1, wavelength=20, profile="cone:0.3", law="mie:4,10")),
                         "pulloff.Scene(tabor=3, amplitude=1, wavelength=20, profile='cone:0.3', law='mie:4,10')")

    def test_keys(self):
        self.assertEqual(set(pulloff.keys()) & {"tabor", "law", "amplitude_ratio", "want", "profile_approach"},
                         {"tabor", "law", "amplitude_ratio", "want", "profile_approach"})
        self.assertEqual(pulloff.keys()["tabor"], "a finite number >= 0")
        scene = pulloff.Scene(tabor=np.float64(2), nodes=np.int64(101), scheme="ring", outer_radius=math.inf)
        self.assertEqual([scene[key] for key in ("tabor", "nodes", "scheme", "outer_radius", "law")],
                         ["2", "101", "ring", "inf", "lennard-jones"])
        other = scene.copy()
        del scene["tabor"]
        scene["nodes"] = None
        self.assertEqual((scene["tabor"], scene["nodes"], other["tabor"], other["nodes"]), ("1", "501", "2", "101"))
        scene.solve(scheme="panel", want="curve")
        self.assertEqual((scene["scheme"], scene["want"]), ("ring", ""))

    def test_threads_beside_a_solve_of_the_same_scene(self):
        """The flag of an interruption of the main thread belongs to no other solve."""
        scene, found = pulloff.Scene(tabor=4, amplitude=2, wavelength=15), []
        workers = [threading.Timer(0.02, lambda: found.append(scene.solve().pull_off.force)) for _ in range(3)]
        workers += [threading.Timer(0.02, lambda: found.append(scene.copy().solve(tolerance=1.1e-6).pull_off.force))]
        for worker in workers:
            worker.start()
        first = scene.solve().pull_off.force
        for worker in workers:
            worker.join()
        self.assertEqual(len(found), 4)
        for force in found:
            self.assertAlmostEqual(force, first, delta=1e-5)  # of two tolerances, 1e-6 and 1.1e-6

    def test_a_stiffness_as_for_the_program(self):
        self.assertEqual(timeless(pulloff.solve(tabor=2, stiffness=0.3).document), timeless(program("solve", "--tabor", "2", "--stiffness", "0.3")))
        with self.assertRaisesRegex(pulloff.Error, "stiffness is 0.3: expected none"):
            pulloff.follow("tabor", [1, 2], stiffness=0.3)

    def test_an_interrupt_ends_a_solve(self):
        source = ("import os, pulloff, signal, threading, time\n"
                  "threading.Timer(0.7, os.kill, (os.getpid(), signal.SIGINT)).start()\n"
                  "begin = time.monotonic()\n"
                  "try:\n"
                  "    pulloff.solve(tabor=8, amplitude=8, wavelength=16, preload='inf', tolerance=1e-9)\n"
                  "except KeyboardInterrupt:\n"
                  "    print('interrupted')\n")
        said = subprocess.run([sys.executable, "-c", source], capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual((said.stdout, said.stderr), ("interrupted\n", ""))


class Texts(unittest.TestCase):
    def test_versions(self):
        project = (SOURCE / "python" / "pyproject.toml").read_text()
        self.assertEqual(re.search(r'^version = "(.*)"', project, re.M)[1], pulloff.version())

    def test_everything_is_documented(self):
        for name in pulloff.__all__:
            self.assertTrue(getattr(pulloff, name).__doc__, name)
        for name in ("update", "copy", "physical", "solve", "compare"):
            self.assertTrue(getattr(pulloff.Scene, name).__doc__, name)

    def test_the_header_declares_these_functions(self):
        from pulloff import _library
        header = (SOURCE / "src" / "library" / "pulloff.h").read_text()
        declared = set(re.findall(r"\bpulloff_(\w+)\(", header))
        self.assertLessEqual(set(_library.FUNCTIONS), declared)


if __name__ == "__main__":
    unittest.main()
