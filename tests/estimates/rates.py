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
import time

MOST_FAILURES = 0.05  # of the scenes
QUANTILES = (0.01, 0.1, 0.5, 0.9)


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


def solve(wanted, words, tolerance):
    line = [wanted.program, "solve", *words, "--tolerance", tolerance, "--json"]
    line += ["--time-limit", str(wanted.time_limit)] if wanted.time_limit else []
    return json.loads(subprocess.run(line, capture_output=True, text=True, check=False).stdout)


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
    """(words, documents, rows): a row has the name of a number, true over stated error, value, that with less tolerance, and
    stated error. None if there was no time left."""
    wanted, words, end = job
    if time.monotonic() > end:
        return None
    found = []
    for tolerance in (wanted.loose, wanted.tight):
        found.append(solve(wanted, words, tolerance))
        if found[-1]["status"] != "ok":
            return words, found, []
    return words, found, [(name, abs(value - true) / (error + rest), value, true, error)
                          for (name, value, error), (_, true, rest) in zip(*map(numbers, found))]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--loose", default="1e-6")
    parser.add_argument("--tight", default="1e-8")
    parser.add_argument("--most-tabor", type=float, default=5.0)
    parser.add_argument("--loaded", type=float, default=0.0, help="share of the scenes that are loaded at a speed (0)")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--time-limit", type=float, help="processor seconds of one solve (no limit)")
    parser.add_argument("--minutes", type=float, default=math.inf, help="no scene is begun later than this (no limit)")
    return parser.parse_args()


def quantile(ordered, share):
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))]


def tell_seconds(what, documents):
    seconds = sorted(document["work"]["seconds"] for document in documents)
    if seconds:
        print(f"{what}: {len(seconds)} solves, median {quantile(seconds, 0.5):.2f} s, greatest {seconds[-1]:.1f} s")


def main():
    wanted = arguments()
    end = time.monotonic() + 60.0 * wanted.minutes
    jobs = [(wanted, scene(wanted.seed, k, wanted.most_tabor, wanted.loaded), end) for k in range(wanted.count)]
    failures, late, violations, factors, solved = 0, 0, 0, {}, ([], [])
    with concurrent.futures.ThreadPoolExecutor(wanted.jobs) as pool:
        for words, found, rows in filter(None, pool.map(judge, jobs)):
            for side, document in zip(solved, found):
                side.append(document)
            line = f"pulloff solve {' '.join(words)}"
            if found[-1]["status"] != "ok":
                late += found[-1]["status"] == "out_of_time"
                failures += found[-1]["status"] != "out_of_time"
                side = ("loose", "tight")[len(found) - 1]
                print(f"{side} solve ended with {found[-1]['status']}: {line}: {found[-1]['reason']}", flush=True)
            for name, ratio, value, true, error in rows:
                factors.setdefault(name, []).append(1.0 / max(ratio, 1e-16))
                if not ratio <= 1.0 or math.isnan(ratio):
                    violations += 1
                    print(f"violated: {name} {value:.10g}, with less tolerance {true:.10g}, error {error:.2g}: {line}", flush=True)
    print(f"stated error over the true one at {', '.join(f'{100 * share:.0f} %' for share in QUANTILES)} of the numbers:")
    for name, of in factors.items():
        of.sort()
        print(f"{name}: {len(of)} compared, least {of[0]:.2g}, {', '.join(f'{quantile(of, share):.2g}' for share in QUANTILES)}")
    for what, documents in zip((wanted.loose, wanted.tight), solved):
        tell_seconds(f"tolerance {what}", documents)
    print(f"{len(solved[0])} of {wanted.count} scenes, {failures} failed, {late} exceeded the time limit, "
          f"{violations} stated errors do not hold")
    if not factors:
        return 3
    return 0 if not violations and failures <= MOST_FAILURES * len(solved[0]) else 1


if __name__ == "__main__":
    sys.exit(main())
