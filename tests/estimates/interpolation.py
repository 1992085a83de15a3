#!/usr/bin/python3
"""Tests the stated uncertainty of the pull-off force by the interpolation of a table: solves known bodies as tables of few
rows and of many, and counts how often the force of the few rows is off that of the body by more than is stated.

    interpolation.py                    200 random bodies
    interpolation.py --count 20         fewer

The bodies are spheres, cones with a round apex, cones without one, and spheres with a wave. The distance of the rows is
drawn between a thirtieth and three times the length in which the body changes. For each family: the number of tables, how
many were refused when they were read, the part whose error is within what is stated, within three times as much, and the
median of error over stated. Exit code: 0 at least 90 % of all are within what is stated, 1 otherwise."""

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

FINE = 24  # rows of the body for one of the table


def sphere(draw):
    radius = 10.0 ** draw.uniform(0.7, 2.5)
    return lambda r: radius - math.sqrt(radius * radius - r * r), math.sqrt(radius), 0.9 * radius


def blunt_cone(draw, radius=None):
    radius, half = radius or 10.0 ** draw.uniform(0.3, 1.7), math.radians(draw.uniform(15.0, 80.0))
    meet, slope = radius * math.cos(half), 1.0 / math.tan(half)
    drop = radius * (1.0 - math.sin(half))

    def gap(r):
        return radius - math.sqrt(radius * radius - r * r) if r < meet else drop + slope * (r - meet)
    return gap, meet, meet + 60.0 / slope + 60.0


def cone(draw):
    slope = draw.uniform(0.2, 4.0)
    return lambda r: slope * r, 1.0 / slope, 40.0 / slope + 40.0


def wave(draw):
    radius, length = 10.0 ** draw.uniform(1.3, 2.5), draw.uniform(4.0, 20.0)
    amplitude = draw.uniform(0.02, 0.3)
    return (lambda r: r * r / (2.0 * radius) + amplitude * (1.0 - math.cos(2.0 * math.pi * r / length)), length / 8.0,
            8.0 * math.sqrt(radius))


FAMILIES = {"sphere": sphere, "blunt cone": blunt_cone, "cone": cone, "sphere with a wave": wave}


def solve(program, path, gap, rows, end, coupling):
    path.write_text("r,gap\n" + "".join(f"{end * k / (rows - 1)!r},{gap(end * k / (rows - 1))!r}\n" for k in range(rows)))
    done = subprocess.run([program, "solve", "--coupling", repr(coupling), "--profile-file", path, "--json", "--preload-load", "1e-9"],
                          capture_output=True, text=True, check=False)
    return json.loads(done.stdout) if done.returncode in (0, 3) else None


def examine(program, folder, number):
    """(family, error over what is stated); the number is NaN if the table is refused, None if a solve failed."""
    draw = random.Random(f"rows {number}")
    family = list(FAMILIES)[number % len(FAMILIES)]
    gap, length, end = FAMILIES[family](draw)
    coupling = 10.0 ** draw.uniform(-3, 0)
    rows = max(9, math.ceil(end / (length * 10.0 ** draw.uniform(-1.5, 0.5))) + 1)
    path = folder / f"{number}.csv"
    few = solve(program, path, gap, rows, end, coupling)
    if few is None:
        return family, math.nan
    true = solve(program, path, gap, FINE * (rows - 1) + 1, end, coupling)
    if few["status"] != "ok" or not true or true["status"] != "ok":
        return family, None
    stated = few["interpolation"]["force"]
    off = abs(few["pull_off"]["force"] - true["pull_off"]["force"])
    rounding = 3.0 * sum(found["pull_off"]["error_estimate"] for found in (few, true))
    return family, max(0.0, off - rounding) / stated if stated else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="build/src/cli/pulloff")
    parser.add_argument("--count", type=int, default=200)
    wanted = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = list(pool.map(lambda k: examine(wanted.program, pathlib.Path(folder), k), range(wanted.count)))
    print("| body | tables | refused | failed | within | within three | median |\n|---|---|---|---|---|---|---|")
    for family in [*FAMILIES, "all"]:
        mine = [ratio for name, ratio in found if family in (name, "all")]
        ratios = [ratio for ratio in mine if ratio is not None and not math.isnan(ratio)]
        share = [100.0 * statistics.fmean(ratio <= most for ratio in ratios) for most in (1.0, 3.0)]
        print(f"| {family} | {len(mine)} | {sum(r is not None and math.isnan(r) for r in mine)} | {mine.count(None)} | "
              f"{share[0]:.0f} % | {share[1]:.0f} % | {statistics.median(ratios):.2g} |", flush=True)
    return 0 if share[0] >= 90.0 else 1


if __name__ == "__main__":
    sys.exit(main())
