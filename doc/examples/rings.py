"""Pull-off of smooth spheres: rings of constant pressure, Newton's method, one approach after the other."""
import json
import sys
import time

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.special import ellipe, ellipk


def disc(r, a):
    """Deflection at the radii r under the pressure 1 on a disc of radius a: the integral of G s ds from 0 to a."""
    inside, outside = np.minimum(r / a, 1)**2, np.minimum(a / r, 1)**2
    far = ellipe(outside) - np.where(r > a, (1 - outside) * ellipk(np.where(r > a, outside, 0)), 0)
    return 4 / np.pi * np.where(r < a, a * ellipe(inside), r * far)


def solve(scene, rings):
    """Force and approach at pull-off. Lengths in epsilon, forces in pi w R, the approach positive under pressure."""
    radius, cut = scene["radius"], scene["outer_radius"]
    edge = np.linspace(0, cut, rings + 1)
    r = (edge[:-1] + edge[1:]) / 2
    discs = np.array([np.zeros(rings)] + [disc(r, a) for a in edge[1:]]).T
    matrix = scene["tabor"]**1.5 / np.sqrt(radius) * np.diff(discs)
    undeformed = r**2 / (2 * radius)
    gap, found = undeformed + 6, []
    for approach in np.arange(-6, 1, 0.05):
        for _ in range(50):
            pressure = -8 / 3 * ((1 + gap)**-3 - (1 + gap)**-9)
            slope = 8 * (1 + gap)**-4 - 24 * (1 + gap)**-10
            error = gap + approach - undeformed - matrix @ pressure
            step = np.linalg.solve(np.eye(rings) - matrix * slope, -error)
            gap = gap + step
            if max(abs(step)) < 1e-10:
                break
        else:
            raise ArithmeticError(f"Newton's method did not converge at approach {approach:.3g}")
        found.append((approach, np.sum(pressure * np.diff(edge**2)) / radius))
    curve = CubicSpline(*zip(*found))
    minimum = min(curve.derivative().roots(extrapolate=False), key=curve)
    return {"force": float(-curve(minimum)), "approach": minimum}


def answer(point):
    begin = time.perf_counter()
    if set(point["scene"]) != {"tabor", "radius", "outer_radius"} or point["scene"]["tabor"] > 0.6:
        return {"status": "unsupported", "reason": "only smooth spheres without folds"}
    try:
        pull_off = solve(point["scene"], point["knob"]["rings"])
    except ArithmeticError as why:
        return {"status": "failed", "reason": str(why)}
    return {"status": "ok", "pull_off": pull_off, "seconds": {"solve": time.perf_counter() - begin}}


request, response = sys.argv[1:]
with open(request) as stream:
    asked = json.load(stream)
with open(response, "w") as stream:
    for point in asked["points"]:
        for repeat in range(asked["repeats"]):
            print(json.dumps({"id": point["id"], "repeat": repeat + 1, **answer(point)}), file=stream, flush=True)
