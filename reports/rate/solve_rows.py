#!/usr/bin/python3
"""Solves the pull-offs of the published table of viscoelastic spheres, and keeps what was found.

    solve_rows.py PROGRAM FOLDER OUTPUT [--sample N --seed S] [--jobs N] [--seconds S]

FOLDER has the files of github.com/alimaghamii/ML4Adhesion (reference/published/README.md). Each distinct scene is
solved once, in a drawn order, and its result is appended to OUTPUT/PROGRAM-DIGEST.csv: a second run goes on where the
first one ended, and another program begins anew. Lengths in eps, forces in pi w R, speeds in eps/tau_0."""

import argparse
import concurrent.futures
import csv
import hashlib
import json
import os
import pathlib
import random
import resource
import subprocess
import sys
import threading
import time

FILES = ("comb_1to9.csv", "fig_8to11_test.csv", "fig8new.csv")
INPUTS = ("runload", "alphaload", "mu", "k", "n")
RADIUS = 100.0  # eps; not stated by the source: the fast limit agrees with this value
TOLERANCE = "1e-5"  # the stated errors of the force are then about 1e-4
TIME_LIMIT = "120"
RESULTS = ("status", "force", "error", "approach", "pull_off_radius", "preload_radius", "preload_load", "work",
           "dissipated", "jumps", "steps", "seconds", "reason")


def read_table(folder):
    """Returned: the rows of the files, each a dictionary of texts with `file` and `line`."""
    rows = []
    for name in FILES:
        path = pathlib.Path(folder) / name
        if not path.is_file():
            continue
        with open(path, newline="", encoding="utf-8") as file:
            reader = csv.DictReader(file)
            missing = set(INPUTS + ("outputAmplification",)) - set(reader.fieldnames or ())
            if missing:
                sys.exit(f"{path}: no column {', '.join(sorted(missing))}")
            rows += [dict(row, file=name, line=reader.line_num) for row in reader]
    if not rows:
        sys.exit(f"{folder}: none of {', '.join(FILES)}; reference/published/README.md says where they are")
    return rows


def scene(row, outer="inf"):
    """The scene of a row: the key under which its result is kept."""
    return tuple(row[name] for name in INPUTS) + (outer,)


def options(key):
    runload, approach, tabor, ratio, exponent, outer = key
    return ["--tabor", tabor, "--radius", str(RADIUS), "--outer-radius", outer, "--preload", approach, "--viscoelastic",
            f"gamma:{ratio},{exponent}", "--unload-speed", repr(-float(runload)), "--tolerance", TOLERANCE]


def solve(program, key):
    """Returned: the texts of RESULTS."""
    line = [program, "solve", *options(key), "--time-limit", TIME_LIMIT, "--json"]
    done = subprocess.run(line, capture_output=True, text=True, env=dict(os.environ, OPENBLAS_NUM_THREADS="1"))
    try:
        document = json.loads(done.stdout)
    except ValueError:
        return dict.fromkeys(RESULTS, "") | {"status": "refused", "reason": done.stderr.strip().replace("\n", " ")}
    found = {"status": document["status"], "reason": document["reason"], "seconds": document["work"]["seconds"]}
    if document["status"] == "ok":
        off, unloading = document["pull_off"], document["unloading"]
        begin, end = unloading["begin"], unloading["end"]["energies"]
        found |= {"force": off["force"], "error": off["error_estimate"], "approach": off["approach"],
                  "pull_off_radius": off["contact_radius"], "preload_radius": begin["contact_radius"],
                  "preload_load": begin["load"], "work": end["work"], "dissipated": end["dissipated"],
                  "jumps": unloading["jumps"], "steps": unloading["steps"]}
    return {name: str(found.get(name, "")) for name in RESULTS}


def store_of(program, folder):
    digest = hashlib.sha256(pathlib.Path(program).read_bytes()).hexdigest()[:16]
    pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
    return pathlib.Path(folder) / f"rows-{digest}.csv"


def read_store(path):
    """Returned: results by scene. A line that an interruption cut short is left out."""
    if not path.is_file():
        return {}
    with open(path, newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row.get("reason") is not None]
    return {tuple(row[name] for name in INPUTS + ("outer",)): row for row in rows}


def solve_all(program, keys, path, jobs, seconds=float("inf")):
    """Solves the scenes that `path` does not have yet, until the seconds of clock have passed. Returned: results."""
    known = read_store(path)
    missing = [key for key in dict.fromkeys(keys) if key not in known]
    begin, lock = time.monotonic(), threading.Lock()
    with open(path, "a", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, INPUTS + ("outer",) + RESULTS, lineterminator="\n")
        if file.tell() == 0:
            writer.writeheader()

        def one(key):
            if time.monotonic() - begin > seconds:
                return
            row = dict(zip(INPUTS + ("outer",), key)) | solve(program, key)
            with lock:
                writer.writerow(row)
                file.flush()
                known[key] = row

        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            list(pool.map(one, missing))
    return known


def drawn(rows, sample, seed):
    """Rows in a drawn order; the first `sample` of them, or all of them."""
    rows = list(rows)
    random.Random(seed).shuffle(rows)
    return rows[:sample] if sample else rows


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("folder")
    parser.add_argument("output")
    parser.add_argument("--sample", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seconds", type=float, default=float("inf"))
    given = parser.parse_args()
    rows = drawn(read_table(given.folder), given.sample, given.seed)
    solve_all(given.program, [scene(row) for row in rows], store_of(given.program, given.output), given.jobs, given.seconds)
    print(f"{resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime:.1f} s of processor time")


if __name__ == "__main__":
    main()
