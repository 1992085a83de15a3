#!/bin/sh
# The printed tables contain the numbers of the JSON document, under the right headings.
# shellcheck disable=SC1091,SC2154
. "$(dirname "$0")/lib.sh"
python=${PYTHON:-python3}

cat >tables.py <<'TABLES'
"""Reads printed tables by the right edges of their headings."""
import json
import math
import re

HEADING = re.compile(r"contact radius|energy lost|unstable modes|\S+")
LABELS = {"point", "jump", "phase", "fold", "obtained"}  # columns of words


def tables(path, *first):
    """The tables whose first heading is one of these: for each its rows, as lists of (heading, cell)."""
    found, edges = [], None
    for line in open(path):
        if line.split() and line.split()[0] in first:
            edges = [(m.end(), m.group()) for m in HEADING.finditer(line) if m.group() not in LABELS]
            found.append([])
        elif edges and line[:1].isalnum() or edges and line[:1] == " " and line.strip():
            if line.startswith("work"):
                break
            begin, row = 0, []
            for edge, name in edges:
                row.append((name, line[begin:edge].split()[-1] if line[begin:edge].split() else ""))
                begin = edge
            found[-1].append((line.split(), row))
    return found


def same(cell, value, places):
    """Whether a cell shows a number to so many significant digits; an unknown number is blank."""
    if value is None or not cell:
        return value is None and not cell
    return math.isclose(float(cell), value, rel_tol=10.0 ** (1 - places), abs_tol=1e-9)


def check(row, *wanted):
    for (name, cell), (heading, value, places) in zip(row, wanted, strict=True):
        assert name == heading, (name, heading)
        assert cell == value if isinstance(value, str) else same(cell, value, places), (row, heading, value)


def landmark(found):
    return (("approach", found["approach"], 9), ("error", found["error_estimate"], 2),
            ("load", found["load"], 9), ("error", found["load_error_estimate"], 2),
            ("contact radius", found["contact_radius"], 6))


def document(path):
    return json.load(open(path))
TABLES

expect 0 '' solve --tabor 2.385 --preload 0.7 --want hysteresis
cp "$work/stdout" solve.text
expect 0 '' solve --tabor 2.385 --preload 0.7 --want hysteresis --json
cp "$work/stdout" solve.json
cat >solve.py <<'SOLVE'
from tables import *

d = document("solve.json")
special, held, loaded = tables("solve.text", "point", "jump")
assert len(special) >= len(d["folds"]) + len(d["extrema"])
for (words, row), found in zip(special, d["folds"] + d["extrema"]):
    assert words[0] == found["kind"], (words, found)
    check(row, *landmark(found), ("unstable modes", found["unstable_modes"], 9))
for rows, control in ((held, "displacement_control"), (loaded, "load_control")):
    jumps = d["hysteresis"][control]["jumps"]
    for (words, row), jump in zip(rows, jumps):
        ends = [jump[end]["approach"] for end in ("before", "after")]
        assert words[:2] == [jump["label"], jump["phase"]]
        check(row, ("approach", "apart" if ends[0] is None else ends[0], 7),
              ("to", "apart" if ends[1] is None else ends[1], 7),
              ("load", jump["before"]["load"], 7), ("to", jump["after"]["load"], 7),
              ("energy lost", "boundless" if jump["energy_lost"] is None else jump["energy_lost"], 5),
              ("error", jump["energy_lost_error_estimate"], 2))
    assert len(jumps) == 2
p = d["pull_off"]
line = next(line for line in open("solve.text") if line.startswith("pull-off force")).replace(",", "").split()
assert same(line[2], p["force"], 9) and same(line[5], p["approach"], 9) and same(line[8], p["contact_radius"], 6), line
line = next(line for line in open("solve.text") if line.startswith("errors")).replace(",", "").split()
assert same(line[2], p["error_estimate"], 2) and same(line[4], p["approach_error_estimate"], 2), line
held = next(line for line in open("solve.text") if line.startswith("displacement control"))
h = d["hysteresis"]["displacement_control"]
numbers = [float(word) for word in re.findall(r"-?\d[\d.e+-]*", held)]
for number, value in zip(numbers, (h["preload"]["approach"], h["preload"]["load"], h["pull_off"]["force"],
                                   h["pull_off"]["approach"], h["energy_lost"],
                                   float(f"{h['energy_lost_error_estimate']:.2g}")), strict=True):
    assert math.isclose(number, value, rel_tol=1e-5), (numbers, h)
SOLVE
check 'solve: special points and jumps' "$python" solve.py

set -- --key tabor --from 1.35 --to 0.92 --points 3 --scale linear --radius 87 --tolerance 1e-5
expect 0 '' follow "$@"
cp "$work/stdout" follow.text
expect 0 '' follow "$@" --json
cp "$work/stdout" follow.json
expect 0 '' follow "$@" --of folds
cp "$work/stdout" folds.text
expect 0 '' follow "$@" --of folds --json
cp "$work/stdout" folds.json
cat >follow.py <<'FOLLOW'
from tables import *

d = document("follow.json")["points"]
(rows,) = tables("follow.text", "tabor")
assert len(rows) == len(d) == 3
for (words, row), point in zip(rows, d):
    p = point["pull_off"]
    check(row, ("tabor", point["input"]["tabor"], 6), ("force", p["force"], 9), ("error", p["error_estimate"], 2),
          ("approach", p["approach"], 9), ("error", p["approach_error_estimate"], 2),
          ("contact radius", p["contact_radius"], 6), ("factorisations", point["work"]["factorizations"], 9))
    assert ("followed" if point["followed"] else "traced") in words
d = document("folds.json")["points"]
(rows,) = tables("folds.text", "fold")
assert len(rows) == 2 * len(d) == 6
for k, (words, row) in enumerate(rows):
    point = d[k % 3]
    assert words[0] == point["folds"][k // 3]["kind"]
    check(row, ("tabor", point["input"]["tabor"], 6), *landmark(point["folds"][k // 3]))
FOLLOW
check 'follow: pull-off and folds' "$python" follow.py

# Results of --want that are too long for the terminal are mentioned.
expect 0 '' solve --tabor 1 --tolerance 1e-4 --want curve,profile,diagnostics
cp "$work/stdout" wanted.text
expect 0 '' solve --tabor 1 --tolerance 1e-4 --want curve,profile,diagnostics --json
cp "$work/stdout" wanted.json
cat >wanted.py <<'WANTED'
from tables import *

d = document("wanted.json")
lines = {words[0]: words for words in map(str.split, open("wanted.text")) if words}
assert lines["curve"][1] == str(len(d["curve"]))
assert lines["profile"][1] == str(len(d["profile"]))
assert same(lines["profile"][5].rstrip(";"), d["profile_approach"], 8)
(held,) = d["contact"]["held"]
assert held["inner"] == 0 and same(lines["annuli"][5], held["outer"], 6)
assert same(lines["checks"][6].rstrip(";"), d["diagnostics"]["residual"], 2)
assert lines["reverse"][1:] == ["status", "ok:", "the", "reverse", "trace", "found", "the", "same",
                                "special", "points"]
assert lines["ended"][3].rstrip(",") and same(lines["ended"][3].rstrip(","), d["ended"]["approach"], 6)
assert same(lines["ended"][5].rstrip(":"), d["ended"]["load"], 6)
WANTED
check 'solve: what is wanted' "$python" wanted.py
finish
