#!/usr/bin/python3
"""The scenes on which the constants are measured: scenes.txt, a command of `pulloff` a line.

    scenes.py --program build/src/cli/pulloff      draws them anew: prints what belongs into scenes.txt

They are drawn by a seed (tests/estimates/draw.py), solved once, and kept if they are solved and cheap: a bound of the
counted work, so that the choice does not depend on the machine. Rings and triangles, rigid scenes, lines of scenes and
closed forms are listed below."""

import argparse
import json
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "estimates"))
import draw                                             # noqa: E402  pylint: disable=wrong-import-position
import solve                                            # noqa: E402  pylint: disable=wrong-import-position

SEED = 11
RANGES = {"tabor": (0.1, 16.0), "radius": (30.0, 200.0), "wavelength": (1.0, 6.0), "amplitude": (0.003, 0.5),
          "outer": (0.25, 1.0), "smooth": 0.2, "cut": 0.5, "at_radius": 0.5}
COUNT = 100                                             # scenes on panels
MOST_WORK = 150e6                                       # iterations times nodes squared: 0.15 s
TOLERANCES = ("1e-4", "1e-6")                           # of every other scene
WANTS = {3: "preload", 7: "hysteresis", 11: "curve", 13: "profile"}    # of every 16th scene

# Where something else is at work than in a solve on panels of one scene.
OTHERS = """
solve --tabor 20 --tolerance 1e-4
solve --tabor 30 --radius 50 --tolerance 1e-4
solve --tabor 4 --amplitude 0.4 --wavelength 10 --outer-radius 100 --tolerance 1e-4
solve --tabor 10 --amplitude 0.2 --wavelength 20 --radius 50 --tolerance 1e-6
solve --tabor 0.05 --amplitude 2 --wavelength 20 --tolerance 1e-6
solve --tabor 0.5 --outer-radius 60 --scheme triangle --nodes 120
solve --tabor 2 --outer-radius 60 --scheme triangle --nodes 150
solve --tabor 1 --scheme triangle --nodes 150 --grading graded
solve --tabor 2 --amplitude 0.5 --wavelength 20 --outer-radius 50 --scheme triangle --nodes 150
solve --tabor 0.7 --amplitude 1 --wavelength 15 --outer-radius 40 --radius 60 --scheme triangle --nodes 160
solve --tabor 1 --amplitude 1 --wavelength 30 --radius 50 --scheme triangle --nodes 120
solve --tabor 0.2 --outer-radius 100 --scheme ring --nodes 150
solve --tabor 3 --outer-radius 60 --scheme ring --nodes 200
solve --tabor 2 --scheme ring --nodes 150 --grading graded
solve --tabor 1.5 --amplitude 0.5 --wavelength 20 --outer-radius 50 --scheme ring --nodes 150
solve --tabor 2 --scheme triangle --nodes 100 --outer-radius 60 --want hysteresis,curve
solve --tabor 0 --amplitude 0.3 --wavelength 10
solve --tabor 0 --amplitude 1 --wavelength 10 --outer-radius 100
solve --tabor 0 --amplitude 10 --wavelength 20 --radius 300
solve --tabor 0 --amplitude 100 --wavelength 60
solve --tabor 0 --amplitude 3 --wavelength 0.01
solve --tabor 0 --want preload,curve
solve --tabor 1e-6 --want hysteresis
solve --tabor 1e-4 --amplitude 1 --wavelength 20 --tolerance 1e-6
solve --tabor 1 --want diagnostics
solve --tabor 0.5 --amplitude 0.5 --wavelength 20 --radius 40 --tolerance 1e-4 --want diagnostics
solve --tabor 1.5 --amplitude 1 --wavelength 20 --radius 60 --tolerance 1e-4 --preload 3
solve --tabor 2 --preload -1 --tolerance 1e-4
solve --tabor 3 --amplitude 0.4 --wavelength 10 --radius 40 --outer-radius 40 --preload inf --tolerance 1e-4
follow --key tabor --from 0.1 --to 3 --points 20 --amplitude 1 --wavelength 20 --outer-radius 100 --tolerance 1e-4
follow --key tabor --from 0.02 --to 8 --points 20 --tolerance 1e-6
follow --key amplitude --from 0.05 --to 2 --points 20 --tabor 2 --wavelength 20 --radius 60 --tolerance 1e-4
follow --key wavelength --from 10 --to 30 --points 16 --tabor 1 --amplitude-ratio 0.03 --radius 60 --outer-radius 60 --tolerance 1e-6
follow --key radius --from 30 --to 200 --points 12 --tabor 1.5 --amplitude 0.5 --wavelength 20 --tolerance 1e-4
follow --key tabor --from 3 --to 0.5 --points 12 --of folds --tolerance 1e-6
follow --key amplitude --from 0.5 --to 0.1 --points 12 --of folds --tabor 2 --wavelength 20 --radius 60 --tolerance 1e-4
theory guduru --tabor 5 --amplitude 10 --wavelength 20 --radius 100
theory guduru --tabor 0.3 --amplitude 1 --wavelength 5 --radius 100
theory guduru --tabor 3 --amplitude 0.01 --wavelength 20 --radius 200
theory guduru --tabor 2 --amplitude 1e-3 --wavelength 1e-3 --radius 100
theory guduru --tabor 1 --amplitude 0.4 --wavelength 10 --radius 100 --contact-radius 17
theory rigid --amplitude 5 --wavelength 20
theory rigid --amplitude 1e-3 --alpha 100
theory rigid --amplitude 1000 --alpha 1e-3
theory rigid --amplitude 30 --alpha 1 --approach 0.2
theory kesari-lew --tabor 5 --amplitude 1 --wavelength 20 --contact-radius 20
""".strip().splitlines()


def words_of(scene, k):
    """The command of the k-th scene drawn."""
    want = ["--want", WANTS[k % 16]] if k % 16 in WANTS else []
    flags = [word for name, value in scene.items() for word in (f"--{name}", solve.number(value))]
    return ["solve", *flags, "--tolerance", TOLERANCES[k % 2], *want]


def is_cheap(program, words):
    done = subprocess.run([program, *words, "--time-limit", "0.6", "--json"], capture_output=True, check=False, text=True)
    found = json.loads(done.stdout) if done.stdout else {"status": "crashed"}
    work = found.get("work", {})
    return found["status"] == "ok" and work["newton_iterations"] * work["nodes"]**2 < MOST_WORK


def read(path=os.path.join(HERE, "scenes.txt")):
    """The commands, as lists of words."""
    with open(path, encoding="utf-8") as stream:
        return [line.split() for line in stream if line.strip() and not line.startswith("#")]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, help="the program that solves them")
    program = parser.parse_args().program
    print(f"# Drawn by scenes.py, seed {SEED}: the first {COUNT} that are solved at little cost, and others.")
    k, kept = 0, 0
    while kept < COUNT:
        words = words_of(draw.scene(SEED, k, RANGES), k)
        if is_cheap(program, words):
            print(" ".join(words))
            kept += 1
        k += 1
    print("\n".join(OTHERS))


if __name__ == "__main__":
    main()
