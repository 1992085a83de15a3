#!/usr/bin/python3
"""A solver that behaves in a chosen way: responder.py MODE TABLE REQUEST RESPONSE

It knows the pull-off of smooth spheres, from the reference table TABLE, and answers with these numbers in the mode
`good`. The other modes are the mistakes that the tests of external solvers expect the program to find.
"""

import csv
import json
import math
import os
import signal
import subprocess
import sys
import time


def read_table(path):
    with open(path, encoding="utf-8") as stream:
        rows = csv.DictReader(line for line in stream if not line.startswith("#"))
        return {float(row["tabor"]): row for row in rows}


FAULTS = {  # of the force
    "sign": lambda force, scene: -force,
    "pi": lambda force, scene: 3.14159265 * force,
    "half": lambda force, scene: force / 2,
    "four_thirds": lambda force, scene: 4 / 3 * force,
    "radius": lambda force, scene: scene["radius"] * force,
    "pi_radius": lambda force, scene: 3.14159265 * scene["radius"] * force,
    "random": lambda force, scene: force * (1 + scene["tabor"]),
}
SHIFTS = {"approach_sign": lambda approach: -approach, "shifted": lambda approach: approach - 1}


def numbers_at(table, tabor):
    """The numbers of a Tabor parameter: of the table, else a power of it between two rows; None beyond."""
    rows = sorted(table)
    if tabor < rows[0]:
        return {**table[rows[0]], "force": 2, "approach": 0}
    above = next((k for k, row in enumerate(rows) if row >= tabor), None)
    if above is None or rows[above] == tabor:
        return table.get(tabor)
    low, high = rows[above - 1], rows[above]
    part = math.log(tabor / low) / math.log(high / low)
    return {name: float(table[low][name]) * (float(table[high][name]) / float(table[low][name]))**part
            for name in ("force", "approach", "contact_radius_over_root_radius")}


def answer(mode, table, point):
    scene = point["scene"]
    row = numbers_at(table, float(scene["tabor"]))
    if row is None or set(scene) - {"tabor", "radius", "outer_radius"}:
        return {"id": point["id"], "status": "unsupported", "reason": "only smooth spheres of the table"}
    force, approach = float(row["force"]), float(row["approach"])
    force = FAULTS.get(mode, lambda force, scene: force)(force, scene)
    approach = SHIFTS.get(mode, lambda approach: approach)(approach)
    if mode == "numberless":
        return {"id": point["id"], "repeat": 1, "status": "ok", "folds": []}
    radius = float(row["contact_radius_over_root_radius"]) * scene["radius"]**0.5
    return {"id": point["id"], "repeat": 1, "status": "ok", "seconds": {"solve": 1e-3},
            "pull_off": {"force": force, "approach": approach, "contact_radius": radius}}


def write(stream, found):
    stream.write(json.dumps(found) + "\n")
    stream.flush()


def spoil(mode, stream, k, found):
    """Answers point number k (from 0) of the request as the mode says."""
    if mode == "nothing" or (mode == "skip" and k == 1):
        return
    if mode == "half_line" and k == 1:
        stream.write(json.dumps(found)[:40])
        stream.flush()
        sys.exit(0)
    if mode == "wrong_type" and k == 1:
        found["pull_off"]["force"] = "two"
    if mode == "list" and k == 1:
        found = [found]
    if mode == "no_status" and k == 1:
        del found["status"]
    if mode == "nan" and k == 1:
        found["pull_off"]["force"] = float("nan")
    if mode == "null" and k == 1:
        found["pull_off"]["force"] = None
    if mode == "lacking" and k == 1:
        del found["pull_off"]["approach"]
    if mode == "scalar" and "pull_off" in found:
        found["pull_off"]["force"] = [found["pull_off"]["force"]]
    if mode == "stranger" and k == 1:
        found["id"] = "4711"
    if mode == "crash" and k == 1:
        print("a secret reason", file=sys.stderr)
        sys.exit(3)
    if mode == "abort" and k == 1:
        os.kill(os.getpid(), signal.SIGSEGV)
    if mode == "hang" and k == 1:
        time.sleep(1000)
    if mode == "deaf" and k == 1:
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        time.sleep(1000)
    if mode == "spawn" and k == 1:
        subprocess.Popen(["sleep", "4711"])  # a child that would live on
        time.sleep(1000)
    if mode == "leave" and k == 1:
        subprocess.Popen(["sleep", "4712"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    if mode == "flood" and k == 1:
        try:
            while True:
                sys.stdout.write("x" * 1000000)
        except OSError:
            sys.exit(0)
    if mode == "gigabyte" and k == 1:
        for _ in range(1000):
            stream.write("x" * 1000000)
    if mode == "inside" and k == 1:
        os.mkdir("parts")
        with open("whole", "w", encoding="utf-8") as other:
            other.write("changed\n")
        os.rename("whole", "parts/whole")
        os.truncate("parts/whole", 0)
    if mode == "environment" and k == 1:
        print(" ".join(f"{key}={value}" for key, value in sorted(os.environ.items())))
        sys.exit(5)
    if mode == "shorter" and k == 1:
        time.sleep(0.2)
        stream.truncate(0)
        time.sleep(1000)
    if mode == "noise":
        print("converged in 7 iterations\n" * 1000)
    if mode == "busy":
        begin = time.process_time()
        while time.process_time() < begin + 0.6:
            pass
    if mode == "long":  # a solve that is not repeated, and after which the process does not end by itself
        time.sleep(6.5 if found["repeat"] == 1 else 1000)
    if mode in ("slow_clock", "slow_failure"):
        time.sleep(1)
    if mode == "slow_failure":
        found = {"id": found["id"], "repeat": found["repeat"], "status": "failed", "reason": "made so",
                 "seconds": {"solve": 1e-3}}
    write(stream, found)
    if mode == "twice" and k == 1:
        write(stream, found)


def main():
    mode, table, request, response = sys.argv[1:5]
    with open(request, encoding="utf-8") as stream:
        asked = json.load(stream)
    if mode == "link" and asked["points"]:
        os.symlink("/etc/passwd", response)
        time.sleep(1)
        return
    if mode == "always_crash":
        sys.exit(1)
    table = read_table(table)
    with open(response, "a", encoding="utf-8-sig" if mode == "marked" else "utf-8") as stream:
        for k, point in enumerate(asked["points"]):
            for repeat in range(asked["repeats"]):
                spoil(mode, stream, k, answer(mode, table, point) | {"repeat": repeat + 1})
                if mode == "slow":
                    time.sleep(0.3)


main()
