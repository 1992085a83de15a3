#!/usr/bin/python3
"""Tests the stated errors of viscoelastic pull-offs: random scenes are solved with a loose and a tight tolerance.

    rates.py PROGRAM --count 40 --seed 1

Tabor parameter, ratio of the moduli, spectrum, speed over eight decades, preload, waves and spring are drawn; with
--loaded the speed of loading and the dwell, too. Prints how often the errors hold and the largest true error over the
stated one, each violation with its command, and the solves that failed. Exit code: 0 no violation and few failures, 1
otherwise."""

import argparse
import concurrent.futures
import json
import math
import random
import subprocess
import sys

MOST_FAILURES = 0.05  # of the scenes


def scene(seed, number, most_tabor, loaded):
    draw = random.Random(f"{seed} {number}")

    def between(low, high):
        return f"{low * (high / low)**draw.random():.6g}"

    ratio = between(0.01, 1.0)
    material = f"sls:{ratio}" if draw.random() < 0.4 else f"gamma:{ratio},{between(0.1, 2.0)}"
    words = ["--tabor", between(0.05, most_tabor), "--preload", f"{draw.uniform(0.5, 8.0):.6g}", "--viscoelastic", material,
             "--unload-speed", draw.choice(("0", "inf")) if draw.random() < 0.1 else between(1e-4, 1e4)]
    if draw.random() < 0.4:
        words += ["--amplitude", between(0.05, 1.5), "--wavelength", between(10.0, 40.0)]
    if draw.random() < 0.25:
        words += ["--stiffness", between(0.05, 10.0)]
    if draw.random() < loaded:
        words += ["--load-speed", "inf" if draw.random() < 0.1 else between(1e-3, 1e3)]
        words += ["--dwell", draw.choice(("0", "inf")) if draw.random() < 0.3 else between(1e-3, 1e2)]
    return words


def solve(program, words, tolerance):
    line = [program, "solve", *words, "--tolerance", tolerance, "--json"]
    return json.loads(subprocess.run(line, capture_output=True, text=True).stdout)


def numbers(document):
    """(name, value, error) of every result with an error."""
    off, unloading = document["pull_off"], document["unloading"]
    yield "force", off["force"], off["error_estimate"]
    yield "approach", off["approach"], off["approach_error_estimate"]
    yield "contact radius", off["contact_radius"], off["contact_radius_error_estimate"]
    if unloading["time"] is not None:
        yield "time", unloading["time"], unloading["time_error_estimate"]
    # Unloading ends at another position with other steps. The work from there until the bodies are infinitely far apart is
    # minus the energies of interaction and spring, and up to about the stored energy is dissipated still.
    if "loading" in unloading:
        start, error = unloading["loading"]["start"]["energies"], unloading["loading"]["error_estimate"]
        for name in "work", "dissipated", "jumps":
            yield f"{name} of loading", start[name], error[name]
    end, error = unloading["end"]["energies"], unloading["error_estimate"]
    yield "work until apart", end["work"] - end["adhesive"] - end["spring"], \
        error["work"] + error["adhesive"] + error["spring"] + 2.0 * end["stored"]
    yield "losses", end["dissipated"] + end["jumps"], error["dissipated"] + error["jumps"] + 2.0 * end["stored"]


def judge(job):
    program, words, loose, tight = job
    found = [solve(program, words, tolerance) for tolerance in (loose, tight)]
    failed = [document["reason"] for document in found if document["status"] != "ok"]
    if failed:
        return words, failed[0], []
    ratios = []
    for (name, value, error), (_, true, rest) in zip(*map(numbers, found)):
        ratios.append((name, abs(value - true) / (error + rest), value, true, error))
    return words, None, ratios


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--loose", default="1e-6")
    parser.add_argument("--tight", default="1e-8")
    parser.add_argument("--most-tabor", type=float, default=5.0)
    parser.add_argument("--loaded", type=float, default=0.0, help="share of the scenes that are loaded at a speed (0)")
    parser.add_argument("--jobs", type=int, default=2)
    given = parser.parse_args()
    jobs = [(given.program, scene(given.seed, k, given.most_tabor, given.loaded), given.loose, given.tight) for k in range(given.count)]
    failures, violations, worst, count = 0, 0, {}, {}
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        for words, reason, ratios in pool.map(judge, jobs):
            line = f"pulloff solve {' '.join(words)}"
            if reason:
                failures += 1
                print(f"failed: {line}: {reason}")
            for name, ratio, value, true, error in ratios:
                worst[name] = max(worst.get(name, 0.0), ratio)
                count[name] = count.get(name, 0) + 1
                if not ratio <= 1.0 or math.isnan(ratio):
                    violations += 1
                    print(f"violated: {name} {value:.10g}, with less tolerance {true:.10g}, error {error:.2g}: {line}")
    for name, ratio in worst.items():
        print(f"{name}: {count[name]} compared, largest true error over the stated one {ratio:.2g}")
    print(f"{given.count} scenes, {failures} failed, {violations} stated errors do not hold")
    return 0 if not violations and failures <= MOST_FAILURES * given.count else 1


if __name__ == "__main__":
    sys.exit(main())
