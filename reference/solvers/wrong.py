"""The solver of newton.py with a planted mistake, which `pulloff conform` and `pulloff verify` have to find. The knob
names the mistake."""

import numpy as np

import ask
import newton

MISTAKES = {
    "sign": lambda scene: -1.0,                          # the load counts positive in tension
    "pi": lambda scene: np.pi,                           # in w R
    "two": lambda scene: 0.5,                            # the factor 2 of the load is forgotten
    "four_thirds": lambda scene: 4 / 3,                  # K in place of E*
    "radius": lambda scene: scene["radius"],             # in pi w epsilon
    "jkr": lambda scene: 2 / 3,                          # in the pull-off force of JKR theory
}


def solve(scene, point):
    factor = MISTAKES[point["knob"]["mistake"]](scene)
    found = newton.solve(scene, point | {"knob": {"nodes": 126}})
    found["pull_off"]["force"] *= factor
    return {"pull_off": found["pull_off"]}


if __name__ == "__main__":
    ask.serve(solve)
