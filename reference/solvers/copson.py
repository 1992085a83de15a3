"""The independent solver of reference/make: the elastic surface in Copson's double Abel form on adaptive spectral panels,
Newton's method, arclength in approach, load and central gap. This file only translates scenes and answers; the solver is
the one that computes the reference data, so its verdicts show what the checks are worth, not that both are right.
"""

import pathlib
import sys

import numpy as np

import ask

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "make"))
from branch import POLISH, TRACE, Problem  # noqa: E402
from contact import contact_radius  # noqa: E402
from landmarks import find_landmarks, polish, trace  # noqa: E402
from laws import Mie  # noqa: E402
from profiles import Sphere, Wave, Waved  # noqa: E402


def problem_of(scene, width):
    """The units of that solver: radii in Gamma = sqrt(R mu) epsilon, tractions times mu."""
    mu, amplitude, outer = scene["tabor"], scene["amplitude"], scene["outer_radius"]
    profile = Sphere(mu)
    if amplitude:
        profile = Waved(profile, (Wave(amplitude, 2 * np.pi * width / scene["wavelength"]),))
    core = max(6.0 * np.sqrt(2.0 / mu), 40.0 if amplitude else 10.0)
    return Problem(Mie(3.0, 9.0, mu), profile, mu, None if np.isinf(outer) else outer / width, core)


def solve(scene, point):
    width = np.sqrt(scene["radius"] * scene["tabor"])
    problem = problem_of(scene, width)
    preload, start = point["preload"], point["approach_start"]
    ends = {"first_approach": -15.0 if start is None else start,
            "last_load": np.inf if preload["load"] is None else preload["load"],
            "last_approach": np.inf if preload["approach"] is None else ask.number(preload["approach"])}
    states = trace(problem, TRACE, refine=point["knob"].get("refine", 1), **ends)
    marks = [polish(problem, mark, POLISH[0]) for mark in find_landmarks(problem, states)]
    found = [{"kind": mark.kind, "approach": mark.state.approach, "load": mark.state.load} for mark in marks]
    deepest = min((mark for mark in marks if mark.kind == "minimum"), key=lambda mark: mark.state.load)
    return {
        "start": states[0].approach, "end": states[-1].approach,
        "pull_off": {"force": -deepest.state.load, "approach": deepest.state.approach,
                     "contact_radius": contact_radius(problem, deepest.state) * width},
        "folds": [mark for mark in found if mark["kind"].startswith("jump")],
        "extrema": [mark for mark in found if mark["kind"].startswith("m")],
        "curve": {"approach": [state.approach for state in states], "load": [state.load for state in states]},
    }


if __name__ == "__main__":
    ask.serve(solve)
