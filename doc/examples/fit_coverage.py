"""How good the standard errors of fit.py are: many measurements with other noise, other samples and other range and modulus to
start from, up to 30 % off, are fitted, and the differences from the true values are divided by the stated errors. Before that, the jumps of
the model are compared with those of the program's own loop through a spring, and the theories with its closed forms.

    python3 fit_coverage.py [COUNT]
"""

import sys

import numpy as np

import fit
import pulloff

work, distance, modulus, zero, _ = fit.TRUE
unit = np.pi * work * fit.RADIUS  # of force, nN
loop = pulloff.solve(tabor=(fit.RADIUS * work**2 / (modulus**2 * distance**3)) ** (1 / 3), want="hysteresis", preload_load=3,
                     approach_start=-80, stiffness=fit.STIFFNESS * distance / unit)["hysteresis"]["spring"]["jumps"]
jumps = [jump["before"]["approach"] * distance + jump["before"]["load"] * unit / fit.STIFFNESS + zero for jump in loop]
ends = [part[0][end] for part, end in zip(fit.parts("truth", fit.TRUE), (-1, 0))]
print(f"\njumps at {ends[0]:.5f} and {ends[1]:.5f} nm; the loop of the program: {jumps[0]:.5f} and {jumps[1]:.5f} nm")
assert np.allclose(jumps, ends, rtol=0, atol=2e-4)
for model in ("JKR", "DMT", "Maugis"):
    assert abs(fit.branch(model, 0.66)[1].min() + pulloff.theory(model.lower(), tabor=0.66)["pull_off_force"]) < 1e-4

count = int(sys.argv[1]) if len(sys.argv) > 1 else 200
ratios, squares = [], []
for seed in range(count):
    measured = fit.measure(seed)
    start = fit.guess(fit.TRUE[1:3] * np.random.default_rng(1000 + seed).uniform(0.7, 1.3, 2), *measured)
    found, covariance, sum_of_squares, terms = fit.fit(fit.split(*measured), start)
    ratios.append((found - fit.TRUE) / np.sqrt(np.diag(covariance)))
    squares.append(sum_of_squares / terms)
size = np.abs(ratios)
print(f"{count} measurements, {np.count_nonzero(np.array(squares) < 1.3)} converged: chi2/n at most {max(squares):.2f}")
for name, numbers in zip(fit.NAMES, size.T):
    print(f"{name:10} within 1 standard error {np.mean(numbers < 1):4.0%}, within 2 {np.mean(numbers < 2):4.0%}, "
          f"largest {numbers.max():.1f}")
sys.exit(0 if max(squares) < 1.3 and size.max() < 5 else 1)
