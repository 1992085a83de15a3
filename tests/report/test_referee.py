"""A referee's repetition: rows of the ledger drawn at random, each computed by other means than those of this program.

Usage: test_referee.py PROGRAM [SEED]

The other means are those of reference/make (route 2 of Eq 22, the solver of Eqs 10-17 without elements, the laws), mpmath, and Eq 5
and its minimum written out here. A row is signed if the computed number of the ledger is repeated and its verdict follows from the
number. Each seed draws 20 rows; another seed draws others.
"""

import functools
import json
import math
import os
import random
import subprocess
import sys
import unittest

import mpmath
import numpy as np
import scipy.optimize
import scipy.special

TREE = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
sys.path.insert(0, os.path.join(TREE, "reference", "make"))
sys.path.insert(0, os.path.join(TREE, "reports", "claims"))

import judge  # noqa: E402
import rigid  # noqa: E402
import smooth_sphere  # noqa: E402
from landmarks import pull_off  # noqa: E402

PROGRAM = os.path.abspath(sys.argv[1]) if len(sys.argv) > 1 and os.path.exists(sys.argv[1]) else None
SEED = int(sys.argv[2]) if len(sys.argv) > 2 else 20201002
DRAWN = 20


@functools.lru_cache(maxsize=None)
def rigid_pull_off(amplitude, alpha):
    """(force, approach) of the rigid wavy sphere, Eq 22."""
    alpha, amplitude = rigid.LONG(alpha), rigid.LONG(amplitude)
    x = rigid.pull_off(alpha, amplitude)
    return -float(rigid.load(rigid.folded_integral, alpha, amplitude, x)), float(1 - x)


def rigid_scene(amplitude, wavelength=20, radius=100):
    return rigid_pull_off(amplitude, amplitude * radius / wavelength ** 2)[0]


def model(alpha, radius):
    """Eq 20 as printed."""
    return 1 / (1 + 4 * math.pi ** 2 * alpha) + 1 / (1 + radius / (4 * math.pi ** 2 * alpha)) ** 2


def guduru(tabor, amplitude, wavelength, radius=100.0):
    """The deepest minimum of the load by Eq 5, in its form without cancellation, by a scan and Brent's method."""
    modulus = math.sqrt(radius / tabor ** 3)
    k = 2 * math.pi / wavelength

    def load(a):
        wave = math.pi * amplitude * (k * a * a * scipy.special.struve(0, k * a) - a * scipy.special.struve(1, k * a))
        return (modulus * (4 * a ** 3 / (3 * radius) + wave) - np.sqrt(8 * math.pi * modulus * a ** 3)) / (math.pi * radius)
    a = np.arange(wavelength / 400, 40 * wavelength, wavelength / 60)
    best = int(np.argmin(load(a)))
    return -scipy.optimize.minimize_scalar(load, bounds=(a[best - 1], a[best + 1]), method="bounded", options={"xatol": 1e-10}).fun


def johnson(tabor, amplitude, wavelength, radius):
    return math.sqrt(2 * wavelength * tabor ** 1.5 / (math.pi ** 2 * amplitude ** 2 * math.sqrt(radius)))


def envelope(*scene):
    return 1.5 * (1 + 1 / (math.sqrt(math.pi) * johnson(*scene))) ** 2


def lennard_jones(gap):
    return -8 / 3 * ((1 + gap) ** -3 - (1 + gap) ** -9)


def mpmath_bound():
    """4π² times the largest value of −sin(x)/x."""
    x = mpmath.findroot(lambda x: mpmath.cos(x) * x - mpmath.sin(x), 4.5)
    return float(4 * mpmath.pi ** 2 * -mpmath.sin(x) / x)


def smallest_slope(amplitude=1.7, wavelength=9.1, radius=61.3):
    begin = 2 * math.pi * amplitude * radius / wavelength
    k = 2 * math.pi / wavelength
    return min((begin + j * wavelength / 1000) / radius + k * amplitude * math.sin(k * (begin + j * wavelength / 1000)) for j in range(1001))


def smooth(tabor):
    """The pull-off force of the smooth sphere on an unbounded half-space, by the solver of reference/make."""
    return -float(pull_off(smooth_sphere.solve_tabor(tabor, levels=smooth_sphere.POLISH[:1], check=False)).load)


def area(ratio):
    """The mean of the true over the apparent area by Eq 27."""
    return float(1 + mpmath.quad(lambda r: (2 * mpmath.pi * ratio) ** 2 * mpmath.sin(2 * mpmath.pi * r) ** 2 / 2, [0, 1]))


AMPLITUDES = (0.31622776601683794, 1, 10, 100, 10000)
# Entry -> (its numbers by other means, one for each choice, in the order of the ledger; relative tolerance).
ROWS = {
    "eq4-compactness": (lambda: [mpmath_bound()], 1e-9),
    "critical-radius": (lambda: [smallest_slope()], 1e-9),
    "eq7-eq8-jkr": (lambda: [1.5], 1e-12),
    "lj-greatest-tension": (lambda: [lennard_jones(3 ** (1 / 6) - 1)], 1e-12),
    "maugis-factor": (lambda: [-lennard_jones(3 ** (1 / 6) - 1) * (9 / (2 * math.pi)) ** (1 / 3)], 1e-12),
    "eq18-crest": (lambda: [rigid_pull_off(100, 1)[0] / 2], 1e-9),
    "eq19-composite": (lambda: [1 / (1 + 4 * math.pi ** 2)], 1e-12),
    "eq20-normalisation": (lambda: [rigid_pull_off(1, 1e-8)[0]], 1e-9),
    "rumpf-first-decreases": (lambda: [min(min(model(1e-4, r), model(1e4, r)) / model(0.1, r) for r in (1, 10, 100, 1000, 10000))], 1e-9),
    "bounds-lower": (lambda: [rigid_scene(1) / (2 * model(0.25, 100)), rigid_scene(10) / model(2.5, 100), rigid_scene(10) / (2 * model(2.5, 100))], 1e-9),
    "fig6-bradley": (lambda: [rigid_pull_off(1, 1e-4)[0]], 1e-9),
    "fig6-not-monotonic": (lambda: [rigid_pull_off(1, 1)[0] / rigid_pull_off(1, 0.1)[0]], 1e-9),
    "fig6-approach-small": (lambda: [max((rigid_pull_off(1, alpha)[1] for alpha in (1e-4, 0.01)), key=abs)], 1e-6),
    "fig6-approach-large": (lambda: [min(rigid_pull_off(1, alpha)[1] for alpha in (1, 10)) / max(
        rigid_pull_off(1, alpha)[1] for alpha in (1e-4, 0.01))], 1e-6),
    "fig7-start": (lambda: [min(rigid_pull_off(a, 1e-4)[0] for a in (0.001, *AMPLITUDES))], 1e-9),
    "fig7-decays": (lambda: [max(rigid_pull_off(a, 0.1)[0] / rigid_pull_off(a, 1e-4)[0] for a in AMPLITUDES)], 1e-9),
    "fig7-three-decades": (lambda: [math.log10(2 / rigid_pull_off(10000, 100)[0])], 1e-9),
    "fig7-rumpf": (lambda: [math.log10(rigid_pull_off(a, 1)[0] / rigid_pull_off(a, 0.1)[0]) / math.log10(model(1, r) / model(0.1, r))
                            for a, r in ((100, 10000), (10000, 1000), (10, 10000), (100, 100))], 1e-9),
    "fig7-rumpf-limit": (lambda: [2 * model(1e6, 100), model(1e6, 100)], 1e-9),
    "fig8-high-rigid": (lambda: [rigid_scene(10) / rigid_scene(1)], 1e-9),
    "fig8-high-jkr": (lambda: [guduru(5, 10, 20)], 1e-6),
    "eq24-jkr": (lambda: [max(max(guduru(*s) / envelope(*s), envelope(*s) / guduru(*s)) for s in ((3, 1, 20, 100), (3, 0.25, 5, 200)))], 1e-6),
    "eq28-area": (lambda: [area(0.1)], 1e-9),
    "eq29-eq30-work": (lambda: [1 - 1 / (2 * math.pi * johnson(3, 1, 20, 100) ** 2)], 1e-9),
}


def ledger(names):
    words = [word for name in names for word in ("--claim", name)]
    done = subprocess.run([sys.executable, os.path.join(TREE, "reports", "claims", "run.py"), "--program", PROGRAM, "--run", "nowhere",
                           "--output", os.environ.get("TMPDIR", "/tmp") + f"/pulloff-referee-{os.getpid()}", "--json", *words],
                          capture_output=True, text=True, check=False, cwd=TREE)
    return {row["id"]: row for row in json.loads(done.stdout)["claims"]}


@unittest.skipUnless(PROGRAM, "no program is given")
class Referee(unittest.TestCase):
    def test_twenty_rows_are_repeated_by_other_means(self):
        drawn = random.Random(SEED).sample(sorted(ROWS), DRAWN)
        rows = ledger(drawn)
        for name in drawn:
            compute, tolerance = ROWS[name]
            for number, choice in zip(compute(), rows[name]["choices"], strict=True):
                with self.subTest(row=name, choice=choice["words"], seed=SEED):
                    self.assertAlmostEqual(choice["computed"] / number, 1, delta=tolerance)
                    low, high = (math.inf if end is None and other is not None else end for end, other in (
                        (choice["low"], None), (choice["high"], choice["low"])))
                    self.assertEqual(choice["verdict"], judge.verdict(number, low, high, choice["accuracy"], choice["reading"]))

    def test_the_smooth_sphere_by_the_solver_without_elements(self):
        said = subprocess.run([PROGRAM, "solve", "--tabor", "1", "--json"], capture_output=True, text=True, check=True).stdout
        self.assertAlmostEqual(json.loads(said)["pull_off"]["force"] / smooth("1"), 1, delta=1e-5)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
