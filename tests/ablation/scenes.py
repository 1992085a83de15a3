#!/usr/bin/python3
"""The scenes on which mechanisms are measured: scenes.txt, a command of `pulloff` a line, in sets.

    scenes.py --program build/src/cli/pulloff      draws them anew: prints what belongs into scenes.txt

They are drawn by a seed (tests/estimates/draw.py), solved once, and kept if they are solved and cheap: a bound of the
counted work, so that the choice does not depend on the machine. Rings and triangles, rigid scenes, lines of scenes,
closed forms and soft scenes are listed below."""

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
COUNT = 50                                              # scenes on panels
MOST_WORK = 150e6                                       # iterations times nodes squared: 0.15 s
WAVY = {"tabor": (0.01, 8.0), "radius": (20.0, 3000.0), "wavelength": (0.5, 4.0), "amplitude": (0.003, 0.3),
        "outer": (0.25, 1.0), "smooth": 0.0, "cut": 0.5, "at_radius": 0.5}
MOST_WAVY, MOST_GENERAL = 60, 50
MOST_WORK_OF_WAVY = 3e9                                 # about 3 s
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
solve --tabor 1e-4 --amplitude 1 --wavelength 18 --outer-radius 100 --scheme triangle --nodes 201
solve --tabor 1e-4 --amplitude 100 --wavelength 30 --outer-radius 100 --scheme triangle --nodes 201
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


# Soft spheres, waves under them, sharp edges, steep laws.
SOFT = """
solve --tabor 100 --tolerance 1e-5
solve --tabor 300 --tolerance 1e-4 --want hysteresis
solve --tabor 1000 --tolerance 1e-4
solve --tabor 3000 --tolerance 1e-4
solve --tabor 10000 --tolerance 1e-4
solve --tabor 300 --law mie:4,10 --tolerance 1e-4
solve --tabor 1000 --law mie:4,10 --tolerance 1e-4
solve --tabor 200 --law morse:2 --tolerance 1e-4
solve --tabor 30 --law mie:12,24 --tolerance 1e-4
solve --profile cone:0.05 --coupling 5 --tolerance 1e-4 --outer-radius inf
solve --profile cone:0.02 --coupling 3 --wave 5,60 --tolerance 1e-4 --outer-radius 1000
solve --profile punch:300,50 --coupling 1 --tolerance 1e-4 --outer-radius inf
solve --profile truncated:500,150 --coupling 0.2 --tolerance 1e-4
solve --tabor 20 --radius 3000 --wavelength 300 --amplitude 5 --preload-load 2 --tolerance 1e-4
solve --tabor 60 --radius 10000 --wavelength 900 --amplitude 10 --preload-load 2 --tolerance 1e-4
solve --tabor 100 --radius 416666.666667 --amplitude 146.666667 --wavelength 16666.666667 --preload-load 1.6976527 --tolerance 1e-4
solve --tabor 150 --radius 416666.666667 --amplitude 146.666667 --wavelength 16666.666667 --preload-load 1.6976527 --tolerance 1e-4
""".strip().splitlines()


def words_of(scene, k, wants):
    """The command of the k-th scene drawn."""
    want = ["--want", wants[k % 16]] if k % 16 in wants else []
    return [*solve.words(scene, TOLERANCES[k % 2]), *want]


def is_cheap(program, words, most):
    done = subprocess.run([program, *words, "--time-limit", "4", "--json"], capture_output=True, check=False, text=True)
    found = json.loads(done.stdout) if done.stdout else {"status": "crashed"}
    work = found.get("work", {})
    return found["status"] == "ok" and work["newton_iterations"] * work["nodes"]**2 < most


def drawn(program, scene_of, count, most, wants):
    """The first `count` commands that are cheap."""
    k, kept = 0, []
    while len(kept) < count:
        words = words_of(scene_of(k), k, wants)
        if is_cheap(program, words, most):
            kept.append(" ".join(words))
        k += 1
    return kept


def read(path=os.path.join(HERE, "scenes.txt")):
    """name of a set -> the commands, as lists of words."""
    sets = {}
    with open(path, encoding="utf-8") as stream:
        for line in stream:
            if line.startswith("# set "):
                commands = sets.setdefault(line.split()[2], [])
            elif line.strip() and not line.startswith("#"):
                commands.append(line.split())
    return sets


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, help="the program that solves them")
    program = parser.parse_args().program
    print(f"# Drawn by scenes.py, seed {SEED}: the first that are solved at little cost, and others.")
    loops = {3: "hysteresis", 11: "hysteresis"}
    sets = {"small": [*drawn(program, lambda k: draw.scene(SEED, k, RANGES), COUNT, MOST_WORK, WANTS), *OTHERS],
            "wavy": drawn(program, lambda k: draw.scene(SEED + 1, k, WAVY), MOST_WAVY, MOST_WORK_OF_WAVY, loops),
            "general": drawn(program, lambda k: draw.general_scene(SEED + 2, k), MOST_GENERAL, MOST_WORK_OF_WAVY, loops),
            "soft": SOFT}
    for name, commands in sets.items():
        print(f"# set {name}\n" + "\n".join(commands))


if __name__ == "__main__":
    main()
