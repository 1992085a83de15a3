#!/usr/bin/python3
"""Tests the standard uncertainties of the pull-off force: draws the noise of a measured profile, or the uncertain inputs,
many times, solves each draw, and compares the scatter of the forces with what one solve states.

    noise.py                            200 draws of every scene
    noise.py --draws 30 --scenes soft   fewer, of one scene

For each scene: the force without noise, the standard deviation of the drawn forces beside what is stated in the mean of
the draws, the mean deviation from the force without noise, and the part of the draws whose force is within twice the
stated uncertainty of it. Exit code: 0 every ratio is 1 within four times its own scatter 1/sqrt(2 draws), and for noise
0.15 more, and the scene inputs-jump has no stated uncertainty; 1 otherwise, 2 bad usage."""

import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import random
import statistics
import subprocess
import sys
import tempfile

# Numbers of a measurement in SI units: a tip of radius 30 nm, rows 0.1 nm apart, in nm.
SI = {"work-j-per-m2": 0.08, "modulus-pa": 5e9, "distance-m": 3e-10}
NOISE = {  # scene: amplitude of a waviness of 6 nm, noise (nm), what else is given
    "stiff": (0.0, 0.01, {"modulus-pa": 5e10}),
    "usual": (0.0, 0.01, {}),
    "soft": (0.0, 0.03, {"modulus-pa": 5e8}),
    "rigid": (0.0, 0.01, {"modulus-pa": "inf"}),
    "wavy": (0.1, 0.01, {}),
    "known": (0.1, 0.01, {"smooth": 0.01}),
    "worn": (None, 0.01, {}),  # flat up to a radius of 4.6 nm, with an edge of 1 nm
}
SPHERE, WAVE = {"radius-m": 3e-8}, {"amplitude-m": 4e-11, "wavelength-m": 6e-9}
PARTS = {"work-j-per-m2": 0.1, "modulus-pa": 0.1, "distance-m": 0.03, "radius-m": 0.05}
INPUTS = {  # scene: what is given, and the relative uncertainties
    "inputs-stiff": (SI | SPHERE | WAVE | {"modulus-pa": 5e10}, PARTS | {"amplitude-m": 0.1}),
    "inputs-soft": (SI | SPHERE | {"modulus-pa": 5e8}, PARTS),
    "inputs-jump": (SI | SPHERE | WAVE | {"modulus-pa": 5e8}, PARTS),  # a groove closes in some draws
}
NOT_LINEAR = "inputs-jump"
ROWS, END = 201, 20.0


def gap(r, amplitude):
    if amplitude is None:
        beyond = r * r / 60.0 - 0.35
        return 0.5 * (beyond + math.hypot(beyond, 0.1)) - 0.5 * (-0.35 + math.hypot(0.35, 0.1))
    return 30.0 - math.sqrt(900.0 - r * r) + amplitude * (1.0 - math.cos(2.0 * math.pi * r / 6.0))


def write_table(path, amplitude, noise, draw):
    rows = [(END * k / (ROWS - 1), noise * draw.gauss(0.0, 1.0)) for k in range(ROWS)]
    path.write_text("r,gap\n" + "".join(f"{r!r},{gap(r, amplitude) + off!r}\n" for r, off in rows), encoding="utf-8")


def solve(program, given):
    """The force in nN and its stated uncertainty."""
    words = [word for name, value in given.items() for word in (f"--{name}", str(value))]
    done = subprocess.run([program, "solve", "--from-physical", *words, "--preload-load-n", "1e-9", "--json"],
                          capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"noise.py: pulloff solve {' '.join(words)}: {done.stderr}")
    si = json.loads(done.stdout)["physical"]
    return 1e9 * si["pull_off"]["force_n"], 1e9 * (si.get("uncertainty", {}).get("force_n") or math.nan)


def drawn_noise(program, scene, number, folder):
    amplitude, noise, more = NOISE[scene]
    path = folder / f"{scene}{number}.csv"
    write_table(path, amplitude, noise, random.Random(f"{scene} {number}"))
    return solve(program, SI | {"table-scale": 1e-9, "smooth": "auto"} | more | {"profile-file": path})


def true_force(program, scene, folder):
    amplitude, _, more = NOISE[scene]
    path = folder / f"{scene}.csv"
    write_table(path, amplitude, 0.0, random.Random())
    return solve(program, SI | {"table-scale": 1e-9} | {k: v for k, v in more.items() if k != "smooth"} | {"profile-file": path})[0]


def drawn_inputs(program, scene, number):
    given, parts = INPUTS[scene]
    draw = random.Random(f"{scene} {number}")
    return solve(program, given | {key: repr(given[key] * (1.0 + part * draw.gauss(0.0, 1.0))) for key, part in parts.items()})


def stated_inputs(program, scene):
    given, parts = INPUTS[scene]
    return solve(program, given | {key: f"{given[key]!r}+-{given[key] * part!r}" for key, part in parts.items()})


def judge(program, scene, draws, folder, pool):
    """One line of the table. Returned: whether the scatter is as stated."""
    if scene in NOISE:
        truth = true_force(program, scene, folder)
        found = list(pool.map(lambda k: drawn_noise(program, scene, k, folder), range(draws)))
        refused = sum(math.isnan(u) for _, u in found)
        stated = math.sqrt(statistics.fmean(u * u for _, u in found if not math.isnan(u)))
        within = statistics.fmean(abs(f - truth) < 2.0 * u for f, u in found)
    else:
        truth, stated = stated_inputs(program, scene)
        found = list(pool.map(lambda k: drawn_inputs(program, scene, k), range(draws)))
        refused, within = 0, statistics.fmean(abs(f - truth) < 2.0 * stated for f, _ in found)
    forces = [f for f, _ in found]
    scatter = statistics.stdev(forces)
    print(f"| {scene} | {truth:.3f} | {statistics.fmean(forces) - truth:+.3f} | {scatter:.3f} | {stated:.3f} | "
          f"{scatter / stated:.3f} | {100 * within:.0f} % | {refused} |", flush=True)
    if scene == NOT_LINEAR:
        return math.isnan(stated)
    return abs(scatter / stated - 1.0) < 4.0 / math.sqrt(2.0 * draws) + (0.15 if scene in NOISE else 0.0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="build/src/cli/pulloff")
    parser.add_argument("--draws", type=int, default=200)
    parser.add_argument("--scenes", default=",".join([*NOISE, *INPUTS]))
    wanted = parser.parse_args()
    scenes = wanted.scenes.split(",")
    if not set(scenes) <= {*NOISE, *INPUTS} or wanted.draws < 2:
        parser.error(f"expected at least 2 draws, and scenes among {', '.join([*NOISE, *INPUTS])}")
    print("| scene | force, nN | bias | scatter | stated | ratio | within 2 | not linear |\n|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        held = [judge(wanted.program, scene, wanted.draws, pathlib.Path(folder), pool) for scene in scenes]
    return 0 if all(held) else 1


if __name__ == "__main__":
    sys.exit(main())
