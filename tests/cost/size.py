#!/usr/bin/python3
"""Compares the nodes and the memory that `pulloff plan` states in advance with those that the solves then use.

size.py PROGRAM [FACTOR]: every solve has to use between 1/FACTOR of the stated values and all of them (FACTOR: 8). Prints a
table. Also tests that the plan says so if the machine has not the memory, or a mesh not the nodes."""

import json
import os
import resource
import subprocess
import sys
import tempfile

FACTOR = 8.0
# Smooth and rough, compliant and rigid, many waves, large, other profiles and laws, coarse and fine.
SCENES = (
    {"tabor": 1},
    {"tabor": 30, "tolerance": 1e-8},
    {"tabor": 0.15, "amplitude": 3.4, "wavelength": 38, "radius": 70},
    {"tabor": 3, "amplitude": 1, "wavelength": 20},
    {"tabor": 5, "amplitude": 10, "wavelength": 20, "outer_radius": 100},
    {"tabor": 3, "amplitude": 1, "wavelength": 20, "radius": 3000},
    {"tabor": 2, "amplitude": 0.1, "wavelength": 2, "radius": 200},
    {"tabor": 12, "amplitude": 0.2, "wavelength": 5, "tolerance": 1e-4},
    {"profile": "cone:0.3", "coupling": 0.05},
    {"profile": "power:0.001,4", "coupling": 0.2},
    {"profile": "truncated:20,100", "coupling": 0.5},
    {"coupling": 0.5, "waves": "1@20;0.3@7"},
    {"tabor": 3, "law": "morse:1"},
    {"tabor": 1, "scheme": "triangle", "nodes": 501, "grading": "uniform"},
)
DEFAULTS = {"scheme": "panel", "outer_radius": "inf"}


def plan(program, scene, *options, memory=None):
    """What `pulloff plan` prints for a case with this scene; with the address space limited to `memory` bytes."""
    keys = {**DEFAULTS, **scene}
    if "tabor" in scene or "waves" in scene:  # a sphere
        keys.setdefault("radius", 100)
    lines = ["name: size", "title: Size", "suites: [own]", "want: [pull_off]", "scene:"]
    limit = memory and (lambda: resource.setrlimit(resource.RLIMIT_AS, (memory, memory)))
    with tempfile.NamedTemporaryFile("w", suffix=".yaml", encoding="utf-8") as file:
        file.write("\n".join(lines + [f"  {key}: {json.dumps(value)}" for key, value in keys.items()]) + "\n")
        file.flush()
        return subprocess.run([program, "plan", *options, file.name], stdout=subprocess.PIPE, text=True, check=True,
                              preexec_fn=limit).stdout


def planned(program, scene):
    return json.loads(plan(program, scene, "--json"))["cases"][0]["points"][0]


# A scene, the memory in bytes, and what the plan has to say.
WARNINGS = (
    ({"tabor": 3, "amplitude": 1, "wavelength": 20, "radius": 100000}, None, None),
    ({"tabor": 3, "amplitude": 1, "wavelength": 20, "radius": 100000}, 10 ** 8, "this machine has 100 MB"),
    ({"tabor": 3, "amplitude": 0.1, "wavelength": 0.01, "radius": 1000}, None, "a mesh has at most 196608 nodes"),
)


def wrong_warnings(program):
    for scene, memory, words in WARNINGS:
        found = [line for line in plan(program, scene, memory=memory).splitlines() if line.startswith("  but ")]
        if (words is None and found) or (words and not any(words in line for line in found)):
            yield f"{scene} with {memory} bytes: the plan says {found}, expected {words}"


def used(program, scene):
    """(nodes, bytes) that a solve of a scene uses."""
    words = [word for key, value in scene.items() if key != "waves" for word in ("--" + key.replace("_", "-"), str(value))]
    for wave in scene.get("waves", "").split(";"):
        words += ["--wave", wave.replace("@", ",")] if wave else []
    with tempfile.TemporaryFile("w+") as out:
        child = subprocess.Popen([program, "solve", "--json"] + words, stdout=out)
        _, status, usage = os.wait4(child.pid, 0)
        out.seek(0)
        result = json.load(out)
    if status or result["status"] != "ok":
        sys.exit(f"{words}: {result['status']}")
    work = result["work"]
    return max(work["nodes"], work["factorized_nodes"] - 1), 1024 * usage.ru_maxrss


def main(program, factor=FACTOR):
    wrong = list(wrong_warnings(program))
    print(f"{'stated':>7} {'used':>6} nodes  {'stated':>7} {'used':>6} MB")
    for scene in SCENES:
        stated = planned(program, scene)
        nodes, memory = used(program, scene)
        name = " ".join(f"{key}={value}" for key, value in scene.items())
        print(f"{stated['nodes']:7} {nodes:6}        {stated['bytes'] / 1e6:7.0f} {memory / 1e6:6.0f}     {name}", flush=True)
        for most, found in ((stated["nodes"], nodes), (stated["bytes"], memory)):
            if not most / float(factor) <= found <= most:
                wrong.append(f"{name}: {most} stated, {found} used")
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
