"""How good the standard errors of pulloff.fit are: many measurements of a stiff and of a soft sample with other noise and other samples
are fitted, and the differences from the true values are divided by the stated errors. Before that, the jumps of the model are
compared with those of the program's own loop through a spring, and the theories with its closed forms.

    python3 fit_coverage.py [COUNT]
"""

import sys

import numpy as np

import fit as example
import pulloff
from pulloff import fit

work, distance, modulus, zero, _ = example.TRUE
unit = np.pi * work * example.RADIUS  # of force, nN
tabor = (example.RADIUS * work**2 / (modulus**2 * distance**3)) ** (1 / 3)
loop = pulloff.solve(tabor=tabor, want="hysteresis", preload_load=3, approach_start=-80,
                     stiffness=example.STIFFNESS * distance / unit)["hysteresis"]["spring"]["jumps"]
jumps = [jump["before"]["approach"] * distance + jump["before"]["load"] * unit / example.STIFFNESS + zero for jump in loop]
parts = fit.Model(example.RADIUS, example.STIFFNESS, 20.0, tolerance=1e-9).parts(tabor, example.TRUE)
ends = [part[0][end] for part, end in zip(parts, (-1, 0))]
print(f"\njumps at {ends[0]:.5f} and {ends[1]:.5f} nm; the loop of the program: {jumps[0]:.5f} and {jumps[1]:.5f} nm")
assert np.allclose(jumps, ends, rtol=0, atol=2e-4)
for model in ("JKR", "DMT", "Maugis"):
    assert abs(fit.theory_branch(model, 0.66, 4)[1].min() + pulloff.theory(model.lower(), tabor=0.66)["pull_off_force"]) < 1e-4

# Radius, nm; stiffness, nN/nm; noise, nN; spacing, farthest and deepest position of the base, nm; values
SAMPLES = {"stiff": (30.0, 2.0, 0.04, 0.1, -20.0, 9.0, [0.08, 0.3, 5.0, 4.321, 0.25]),
           "soft": (500.0, 0.5, 0.3, 1.0, -700.0, 80.0, [0.05, 0.5, 0.2, -50.0, 1.0])}
count = int(sys.argv[1]) if len(sys.argv) > 1 else 100
good = True
for name, numbers in SAMPLES.items():
    (example.RADIUS, example.STIFFNESS, example.NOISE, example.SPACING, example.FARTHEST, example.DEEPEST), truth = numbers[:6], np.array(numbers[6])
    example.TRUE = truth
    ratios, squares = [], []
    for seed in range(count):
        found = fit.fit_curve(example.measure(seed), example.RADIUS, example.STIFFNESS)
        ratios.append((found.values - truth) / found.errors)
        squares.append(found.chi2)
    size = np.abs(ratios)
    print(f"{name}: {count} measurements, chi2/n at most {max(squares):.2f}")
    for label, numbers in zip(fit.NAMES, size.T):
        print(f"  {label:18} within 1 standard error {np.mean(numbers < 1):4.0%}, within 2 {np.mean(numbers < 2):4.0%}, largest {numbers.max():.1f}")
    good = good and max(squares) < 1.4 and size.max() < 5
sys.exit(0 if good else 1)
