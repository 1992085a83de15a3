#!/usr/bin/env python3
"""What coarse steps do to the pull-off of a viscoelastic sphere: the greatest tension by a first-order march whose steps are constant.

The hereditary integral is taken as a sum in which every increment of the traction acts at the end of its step:

    H_n = f - D_n + kappa G [k p_n + sum_m z_m,n],    z_m,n = exp(-h/tau_m) z_m,n-1 + (1 - exp(-h/tau_m)) (1 - k) w_m p_n-1

so that the last increment finds the glassy modulus, whatever the speed is. The tension is too large in proportion to the step where
the body creeps during unloading, and where it does not, the steps pass the greatest tension. The spatial discretisation is that of
unloading.py, with its equations and units.

    coarse_steps.py TABOR VISCOELASTIC PRELOAD SPEED STEP...      force for each step of the approach (epsilon), as viscoelastic.py

For example `coarse_steps.py 2 'gamma:0.1;0.6' 10.7 31.6 0.2 0.1 0.05`.
"""

import sys

import numpy as np

from branch import NotConverged
from unloading import Accuracy
from viscoelastic import test_of

SPACE = Accuracy(order=8, tail=12, width=2.4, step=1e-5, traction=1e-4)
MOST_STEPS = 4000
LONGEST = 0.05           # approach, epsilon, by which the gap follows a step with frozen history
FINER = 1, 4, 16         # times as many parts where Newton's method finds no gap


def advanced(test, gap, history, base, step):
    """The equilibrium at base - step with frozen history. Raises NotConverged."""
    for finer in FINER:
        parts, now = finer * int(np.ceil(step / LONGEST)), gap
        for part in range(1, parts + 1):
            now = test.equilibrium(now, history, test.creep.k, base - step * part / parts)
            if now is None:
                break
        if now is not None:
            return now
    raise NotConverged(f"no equilibrium near the approach {base - step:g}")


def greatest_tension(test, step):
    """The greatest tension of all steps, pi w R. Raises NotConverged."""
    x = step / test.speed / test.creep.times
    keeps, gap, base = np.exp(-x), test.first, test.preload
    p = test.problem.traction(gap)
    z, greatest = p[:, None] * test.creep.parts, -np.inf
    for _ in range(MOST_STEPS):
        z = keeps * z + p[:, None] * (test.creep.parts * (1.0 - keeps))
        try:
            gap = advanced(test, gap, z.sum(axis=1), base, step)
        except NotConverged:
            if -test.weights @ p < greatest:     # the rest of the contact jumps off
                return greatest
            raise
        base -= step
        p = test.problem.traction(gap)
        greatest = max(greatest, -test.weights @ p)
        if test.opening(gap) > 0.0:
            return greatest
    raise NotConverged(f"{MOST_STEPS} steps of {step:g} do not end the contact")


def smooth(tabor, viscoelastic, preload, speed):
    """The test of a smooth sphere on the unbounded half-space. Given: texts, as in viscoelastic.py."""
    return test_of((tabor, "0", "20", "100", "inf", viscoelastic, preload, speed, "-", "-", "-"), SPACE)[0]


def main(words):
    if len(words) < 5:
        print(__doc__.partition("\n\n    coarse")[2], file=sys.stderr)
        return 2
    test = smooth(*words[:4])
    for step in map(float, words[4:]):
        try:
            print(f"step {step:g}: force {greatest_tension(test, step):.7g}")
        except NotConverged as problem:
            print(f"step {step:g}: none: {problem}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
