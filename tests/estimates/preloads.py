#!/usr/bin/python3
"""Solves random scenes with several preloads, to see what the preload changes and to test the bound from JKR theory.

    preloads.py --count 1000 --seed 1         each scene with several preloads, and with an unlimited one
    preloads.py --scenes 17,40-44             only these of the drawn scenes
    preloads.py --general --count 30          wavy scenes of any law and profile, default and unlimited preload

Prints for each preload how many scenes have a larger pull-off force after a harder preload, for how many it is known
that none gives more, and the work. Prints how often the deepest minimum of the load up to the preload is not what a
test at given approach measures, and by how much minima of the load beyond the default preload exceed the bound that
`complete` relies on. Exit code: 0 the bound holds, 1 it does not, 2 bad usage, 130 interrupted."""

import math
import os
import statistics
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from scipy.special import struve

import draw
import options
import solve

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "reference", "make"))
from general_scene import abel             # pylint: disable=wrong-import-position
from profiles import profile_of            # pylint: disable=wrong-import-position

LOADS = (0, 0.5, 1, 1.5, 2, 3, 5)
USUAL = 1          # the default preload of a solve, pi w R
MORE = 0.02        # relative difference above which a pull-off force counts as larger
WAVES = 0.25       # allowance of the solver for the contact radius of a minimum, in wavelengths
SAMPLES = 40       # samples of Eq 5 in a wavelength
STEEP = {"smooth": 0.0, "amplitude": (0.05, 0.5), "pliant": (0.05, 10.0)}   # general scenes with later minima
EXCESSES = (0, 0.05, 0.1, 0.2, 0.5, 1)


def arguments(args):
    parser = options.parser_of(__doc__, "preloads.jsonl", 1000, (1e-4, 1e-4))
    options.add_ranges(parser, {"tabor": (0.05, 5.0), "radius": (20.0, 300.0), "wavelength": (0.4, 6.0),
                                "amplitude": (0.001, 0.5), "outer": (0.25, 1.0)},
                       {"smooth": 0.0, "cut": 0.5, "at-radius": 1.0})
    parser.add_argument("--general", action="store_true", help="scenes of any law, profile, waves and coupling")
    return parser.parse_args(args)


def points(solution):
    return solution["work"]["points"]


def row(name, found, beside):
    """The row of one preload. Given: its solutions, and those with an unlimited preload."""
    both = [(one, other) for one, other in zip(found, beside) if one["status"] == other["status"] == "ok"]
    if not both:
        return f"{name:8}{0:8}"
    forces = [(one["pull_off"]["force"], other["pull_off_any"]["force"]) for one, other in both]
    return (f"{name:8}{len(both):8}{sum(f < (1 - MORE) * most for f, most in forces):8}"
            f"{sum(f < 0.5 * most for f, most in forces):9}"
            f"{sum(one['pull_off_any']['complete'] for one, _ in both):10}"
            f"{sum(one['pull_off']['preload']['approach'] is None for one, _ in both):12}"
            f"{statistics.median(points(one) for one, _ in both):10.0f}{sum(points(one) for one, _ in both):10}")


def general_loads(scene, radii):
    """The same of any profile by its Abel transform g, load 2 (a g - int g)/c - sqrt(8 pi a^3/c), in pi w R of a sphere
    and in pi w epsilon of other profiles."""
    waves = ";".join(wave.replace(",", "@") for wave in scene["wave"])
    profile = profile_of(scene["profile"], waves, str(scene.get("radius", "-")))
    fine = np.linspace(0.0, radii[-1], 8 * len(radii) + 1)[1:]
    g = abel(profile, fine)
    area = np.concatenate([[0.0], np.cumsum(0.5 * np.diff(fine) * (g[1:] + g[:-1]))])
    unit = math.pi * scene.get("radius", 1.0)
    elastic = 2.0 * (fine * g - area) / (scene["coupling"] * unit)
    return np.interp(radii, fine, elastic), np.sqrt(8.0 * math.pi * radii**3 / scene["coupling"]) / unit


def wavelengths(scene):
    """The longest and the shortest wavelength."""
    lengths = [float(wave.split(",")[1]) for wave in scene["wave"]] if "wave" in scene else [scene["wavelength"]]
    return max(lengths), min(lengths)


def loads(scene, radii):
    """The load of Eq 5 at contact radii, in pi w R: the part without adhesion, and the adhesive part."""
    stiffness = math.sqrt(scene["radius"] / scene["tabor"]**3)
    x = 2 * math.pi / scene["wavelength"] * radii
    elastic = (4 * stiffness / (3 * math.pi * scene["radius"]**2) * radii**3
               + stiffness * scene["amplitude"] / scene["radius"] * radii * (x * struve(0, x) - struve(1, x)))
    return elastic, math.sqrt(8 * stiffness / math.pi) / scene["radius"] * radii**1.5


def excess(scene, minimum):
    """The factor on the adhesive part of Eq 5 with which it has a minimum as deep as the given one, at a contact radius
    no smaller: one of EXCESSES, or infinity."""
    length, shortest = wavelengths(scene)
    first = max(minimum["contact_radius"] - WAVES * length, 1e-3 * length)
    radii = np.arange(first, 3 * first + 4 * length, shortest / SAMPLES)
    elastic, adhesive = (general_loads if "wave" in scene else loads)(scene, radii)
    for part in EXCESSES:
        load = elastic - (1 + part) * adhesive
        inner = load[1:-1]
        least = inner[(inner <= load[:-2]) & (inner <= load[2:])]
        if least.size and least.min() <= minimum["load"]:
            return part
    return math.inf


def beyond(scene, usual, most):
    """Minima in tension that only a trace beyond the default preload finds."""
    if usual["status"] != "ok" or most["status"] != "ok" or most["rigid"] or scene.get("tabor") == 0:
        return []
    minima = [[mark for mark in one["extrema"] if mark["kind"] == "minimum"] for one in (usual, most)]
    return [mark for mark in minima[1][len(minima[0]):] if mark["load"] < 0]


def drawn(wanted):
    """The scenes, and the options of their solves by the names of the rows."""
    numbers = wanted.scenes if wanted.scenes is not None else range(wanted.count)
    preloads = {f"{load:g}": {"preload-load": load} for load in LOADS}
    if not wanted.general:
        return [draw.scene(wanted.seed, k, vars(wanted)) for k in numbers], {**preloads, "any": {"preload": "inf"}}
    scenes = [draw.general_scene(wanted.seed, k, {**draw.GENERAL, **STEEP}) for k in numbers]
    # with a profile wanted, a solve ends at the default preload
    return [scene for scene in scenes if scene["wave"]], {f"{USUAL:g}": {"want": "profile"}, "any": {"preload": "inf"}}


def main(args):
    wanted = arguments(args)
    program = wanted.program or f"{wanted.build}/src/cli/pulloff"
    journal = solve.Journal(wanted.journal or f"{wanted.build}/preloads.jsonl", program, wanted.time_limit, wanted.fresh)
    scenes, preloads = drawn(wanted)
    found = {}
    with ThreadPoolExecutor(wanted.jobs or None) as pool:
        for name, flags in preloads.items():
            found[name] = list(pool.map(lambda scene, flags=flags: journal.solution({**scene, **flags}, wanted.loose),
                                        scenes))
            if not wanted.quiet:
                print(f"{name}: {len(scenes)} scenes", file=sys.stderr)
    journal.close()
    print(f"{'load':8}{'solved':>8}{'> 2 %':>8}{'> twice':>9}{'complete':>10}{'unmeasured':>12}{'points':>10}{'sum':>10}")
    for name, solutions in found.items():
        print(row(name, solutions, found["any"]))
    excesses = [excess(scene, mark) for scene, usual, most in zip(scenes, found[f"{USUAL:g}"], found["any"])
                for mark in beyond(scene, usual, most)]
    print(f"minima in tension beyond the usual preload: {len(excesses)}; adhesion of Eq 5 must be greater by: "
          + ", ".join(f"{part:g}: {sum(one == part for one in excesses)}" for part in (*EXCESSES, math.inf)))
    return int(any(one > EXCESSES[2] for one in excesses))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
