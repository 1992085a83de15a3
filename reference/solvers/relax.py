"""Loading and unloading at given approach by overdamped relaxation, as a molecular-dynamics-like code would do it: no
tangent of the branch, no unstable equilibria, only states to which the surfaces come to rest. Written from Eqs 2, 9, 15
and 16 of the paper; the surface is the one of newton.py.

At a new approach the surfaces start from the last state of rest and move by dH/dt = -(residual of Eq 15), with implicit
steps. A jump is a state of rest far from the last one; it is located by halving the
step of the approach.
"""

import numpy as np
from scipy.linalg import lu_factor, lu_solve
from scipy.optimize import minimize_scalar

import ask
import newton

STEP, FINEST = 0.1, 1e-3     # of the approach; FINEST is the approach_step of the manifest
FIRST, LONGEST = 2.0, 20.0   # step of the relaxation in time
JUMP = 0.5                   # change of a gap (relative to 1 + H), in a step FINEST, that is a jump


def residual(sphere, gap, approach):
    return gap + approach - sphere.shape - sphere.matrix @ newton.traction(gap)


def rest(sphere, gap, approach):
    """The state of rest that the surfaces reach from `gap` at an approach."""
    time, gap = FIRST, gap.copy()
    unit = np.eye(len(gap))
    for _ in range(3000):
        jacobian = unit - sphere.matrix * newton.slope(gap)
        factors = lu_factor(unit / time + jacobian, check_finite=False)
        # a step longer than the growth of an unstable mode leads to the unstable equilibrium and not away from it
        if newton.orientation(factors) < 0:
            time *= 0.5
            continue
        change = -lu_solve(factors, residual(sphere, gap, approach), check_finite=False)
        size = np.max(np.abs(change) / (1 + gap))
        if size > 0.2:
            time *= 0.15 / size
            continue
        gap += change
        if size < 1e-8 and np.max(np.abs(residual(sphere, gap, approach))) < 1e-9:
            return gap
        # longer steps would be Newton's method, which does not pass a place where an equilibrium has just ended
        time = min(1.3 * time, LONGEST)
    raise ArithmeticError(f"no state of rest at approach {approach:.6g}")


def sweep(sphere, gap, begin, ended, direction):
    """States of rest (approach, load, gap) from `begin` on, and the jumps between them."""
    approach, step, states, jumps = begin, STEP, [(begin, sphere.load(gap, begin), gap)], []
    while not ended(*states[-1][:2]):
        new = rest(sphere, gap, approach + direction * step)
        jumped = np.max(np.abs(new - gap) / (1 + np.minimum(new, gap))) > JUMP
        if jumped and step > FINEST:
            step = max(step / 2, FINEST)
            continue
        approach += direction * step
        load = sphere.load(new, approach)
        if jumped:
            jumps.append({"phase": "loading" if direction > 0 else "unloading", "approach": approach,
                          "load_before": states[-1][1], "load_after": load,
                          "energy_lost": energy(sphere, gap, approach) - energy(sphere, new, approach)})
        gap = new
        states.append((approach, load, gap))
        step = min(STEP, step * 1.5)
    return states, jumps


def energy(sphere, gap, approach):
    """Eq 17: interaction and elastic energy, in pi w R eps."""
    interaction = -4 / 3 * (1 + gap)**-2 + 1 / 3 * (1 + gap)**-8
    return sphere.weights @ (interaction + 0.5 * newton.traction(gap) * (gap + approach - sphere.shape))


def solve(scene, point):
    sphere = newton.Sphere(scene, point["knob"]["nodes"])
    furthest, hardest = ask.number(point["preload"]["approach"]), point["preload"]["load"]
    far = -12.0 - 2 * scene["amplitude"]
    begin = rest(sphere, sphere.shape - far, far)
    loading, jumps_in = sweep(sphere, begin, far, lambda d, w: (furthest is not None and d >= furthest)
                              or (hardest is not None and w >= hardest), 1)
    unloading, jumps_out = sweep(sphere, loading[-1][2], loading[-1][0],
                                 lambda d, w: d <= far or (d < -1 and w > -1e-2), -1)
    i = min(range(1, len(unloading) - 1), key=lambda k: unloading[k][1])
    (begin, *_), (at, load, gap), (end, *_) = unloading[i - 1:i + 2]
    if not any(end <= jump["approach"] <= begin for jump in jumps_out):
        found = minimize_scalar(lambda d: sphere.load(rest(sphere, gap, d), d), bounds=(end, begin), method="bounded",
                                options={"xatol": FINEST})
        at, load = found.x, found.fun
    gap = rest(sphere, gap, at)
    jumps = jumps_in + jumps_out
    return {"pull_off": {"force": -load, "approach": at, "contact_radius": newton.contact_radius(sphere, gap)},
            "hysteresis": {"force": -load, "approach": at, "energy_lost": sum(j["energy_lost"] for j in jumps),
                           "jumps": jumps}}


if __name__ == "__main__":
    ask.serve(solve)
