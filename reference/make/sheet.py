#!/usr/bin/env python3
"""The certified values of the adhesion sheet: those of contact laws, rigid bodies, JKR with grooves, and viscoelastic bodies.

    sheet.py --seal              write the header of sheet/values.csv anew, with the checksum of problems.json, and that of
                                 values.csv into doc/sheet.md; no value changes
    sheet.py --write             compute the values of these groups, and replace them in sheet/values.csv
    sheet.py --sample            recompute some problems by both routes and compare (exit 1 on disagreement)
    sheet.py --sample --all      every problem
    --balls PROGRAM              the program sheet_balls (target of the build, where Arb is installed); without it --sample
                                 compares with the second route alone
    --pulloff PROGRAM            the program pulloff, the second route of viscoelastic bodies

Contact laws and rigid bodies: intervals in ball arithmetic (balls/) and mpmath (sheet_laws.py). The interval of the first
has to contain the number of the second within 1e-18. JKR with grooves and viscoelastic bodies are rows of tables of this
folder. The first table has two routes of its own; the half-width of a viscoelastic number is the uncertainty of the table or
the difference from the program, whichever is greater.
"""

import argparse
import hashlib
import json
import re
import subprocess
import sys
from pathlib import Path

from mpmath import ceil, floor, log10, mp, mpf, nstr

import sheet_laws
from command_line import STORED, run
from tables import read_table, write_table

SHEET = STORED / "sheet"
COLUMNS = "problem quantity value digits half_width route_1 route_2".split()
PRINTED, MOST_DIGITS = 15, 10      # digits of a value; of those that are certified
LIMIT = mpf("1e-18")               # relative difference of the routes
SAMPLE = ["law-jkr", "law-flat-punch", "law-dmt", "law-cone", "rigid-truncated", "groove-open", "rate-fast"]
HEADER = {
    "what": "adhesion-sheet-1: certified values of problems.json",
    "source": "K. L. Johnson, K. Kendall, A. D. Roberts (1971); B. V. Derjaguin, V. M. Muller, Yu. P. Toporov (1975); "
              "K. Kendall (1971); D. Maugis (1992); R. S. Bradley (1932); solved anew",
    "kind": "oracle",
    "method": "two routes a value, named in the columns route_1 and route_2",
    "units": "the quantities of problems.json name theirs",
    "uncertainty": "half_width: the true value is within this of the one that is printed. digits: the significant digits "
                   "that are certain, at most 10",
    "evidence": "contact laws and rigid bodies: proven intervals, and a second route within 1e-18 of them; the other "
                "groups: the difference of the routes",
    "generator": "reference/make/sheet.py, sheet_elastic.py and the generators of the tables that they name",
    "command": "python3 reference/make/sheet.py --write --balls build/tests/sheet/sheet_balls --pulloff build/src/cli/pulloff",
    "date": "2026-11-27"}


def header():
    """The header with the checksum of the problems as they are."""
    return HEADER | {"problems": hashlib.sha256((SHEET / "problems.json").read_text().encode()).hexdigest()}


BALLS, QUADRATURE = "ball arithmetic (Arb)", "mpmath: quadrature and energies"
GROOVES = {"pull_off_force": ("force", "force_uncertainty"), "pull_off_approach": ("approach", "approach_uncertainty"),
           "pull_off_radius": ("contact_radius", "edge_uncertainty")}
VISCOELASTIC = {"pull_off_force": "force", "pull_off_approach": "approach", "pull_off_radius": "contact_radius"}
PROGRAM_TOLERANCE = "1e-8"


def read_problems():
    """The problems; numbers are texts, as written."""
    return json.loads((SHEET / "problems.json").read_text(), parse_float=str, parse_int=str)["problems"]


def intervals(program, problem):
    """{quantity: (middle, radius)} of a problem in ball arithmetic."""
    name = "law-maugis" if problem["id"].startswith("law-maugis") else problem["id"]
    words = [f"{key}={value}" for key, value in problem["parameters"].items()]
    lines = subprocess.run([program, name, *words], check=True, capture_output=True, text=True).stdout.splitlines()
    found = {}
    for line in lines:
        quantity, value = line.split(" ", 1)
        middle, _, radius = value.strip("[]").partition(" +/- ")
        found[quantity] = mpf(middle), mpf(radius or 0)
    return found


def certain(value, half_width):
    """Significant digits of a value that are certain."""
    return int(min(MOST_DIGITS, floor(-log10(half_width / abs(value)))))


def row(problem, quantity, value, half_width, routes):
    """A row: the value rounded, the half-width with the rounding, rounded up."""
    printed = nstr(value, PRINTED)
    half_width = half_width + abs(value - mpf(printed)) + mpf(10) ** -PRINTED * abs(value)
    scale = mpf(10) ** (floor(log10(half_width)) - 1)
    half_width = ceil(half_width / scale) * scale
    return [problem, quantity, printed, str(certain(value, half_width)), nstr(half_width, 2), *routes]


def enclosed(program, problem):
    """The rows of a problem that is enclosed. Without the program the stored values take the place of the intervals."""
    second = sheet_laws.solve(problem["id"], problem["parameters"])
    first = intervals(program, problem) if program else stored_intervals(problem["id"])
    if set(first) != set(second) or set(first) != {quantity["name"] for quantity in problem["quantities"]}:
        raise ValueError(f"{problem['id']}: the routes have other quantities than the problem")
    for name, (value, radius) in first.items():
        if not abs(value - second[name]) <= radius + LIMIT * abs(value):
            raise ValueError(f"{problem['id']} {name}: {nstr(value, 25)} +/- {nstr(radius, 2)} and {nstr(second[name], 25)}")
    return [row(problem["id"], quantity["name"], *first[quantity["name"]], (BALLS, QUADRATURE))
            for quantity in problem["quantities"]]


def stored_intervals(problem):
    return {entry["quantity"]: (mpf(entry["value"]), mpf(entry["half_width"])) for entry in stored()
            if entry["problem"] == problem}


def stored():
    return read_table(SHEET / "values.csv")[1]


def only(rows, wanted):
    """The row whose columns have these values."""
    found = [entry for entry in rows if all(same(entry[key], value) for key, value in wanted.items())]
    if len(found) != 1:
        raise ValueError(f"{len(found)} rows with {wanted}")
    return found[0]


def same(text, value):
    try:
        return float(text) == float(value)
    except ValueError:
        return text == value


def with_grooves(problem):
    entry = only(read_table(STORED / "jkr_grooves.csv")[1], problem["parameters"])
    routes = "jkr_grooves.csv: tractions by collocation", "gap in the grooves by least squares"
    return [row(problem["id"], name, mpf(entry[column]), mpf(entry[uncertainty]), routes)
            for name, (column, uncertainty) in GROOVES.items()]


def viscoelastic(problem, program):
    p = problem["parameters"]
    scene = {"tabor": p["tabor"], "radius": p["R"], "viscoelastic": f"sls:{p['k']}", "preload": p["preload"],
             "unload_speed": p["unload_speed"], "amplitude": p.get("A", "0"), "outer_radius": p.get("outer_radius", "inf")}
    if "A" in p:
        scene["wavelength"] = p["wavelength"]
    entry = only(read_table(STORED / "viscoelastic.csv")[1], {**scene, "stiffness": "-", "load_speed": "-"})
    words = [f"--{key.replace('_', '-')}={value}" for key, value in scene.items()]
    answer = subprocess.run([program, "solve", *words, "--tolerance", PROGRAM_TOLERANCE, "--json"], check=True,
                            capture_output=True, text=True).stdout
    other = json.loads(answer, parse_float=mpf)["pull_off"]
    rows = []
    for name, column in VISCOELASTIC.items():
        value, uncertainty = mpf(entry[column]), mpf(entry[column + "_uncertainty"])
        routes = "viscoelastic.csv: Copson panels and Runge-Kutta", "steps in time of pulloff"
        rows.append(row(problem["id"], name, value, max(uncertainty, abs(value - other[column])), routes))
    return rows


def rows_of(problem, given):
    """The rows of a problem of these groups, or None."""
    if problem["group"] in ("contact law", "rigid"):
        return enclosed(given.balls, problem)
    if problem["group"] == "JKR with grooves":
        return with_grooves(problem)
    return viscoelastic(problem, given.pulloff) if problem["group"] == "rate-dependent" and given.pulloff else None


def write(given):
    """Computes the rows; those of other groups stay."""
    if not given.balls or not given.pulloff:
        raise ValueError("--write needs --balls and --pulloff")
    kept = stored() if (SHEET / "values.csv").exists() else []
    rows = []
    for problem in read_problems():
        made = rows_of(problem, given)
        rows += made or [[entry[column] for column in COLUMNS] for entry in kept if entry["problem"] == problem["id"]]
        print(f"{problem['id']}: {'computed' if made else 'kept'}", flush=True)
    write_table(SHEET / "values.csv", header(), COLUMNS, rows)


def seal(_):
    """The values as they are, with the checksum of the problems; both have to have the same quantities in the same order."""
    rows = [[entry[column] for column in COLUMNS] for entry in stored()]
    asked = [[problem["id"], quantity["name"]] for problem in read_problems() for quantity in problem["quantities"]]
    if [entry[:2] for entry in rows] != asked:
        raise ValueError("values.csv and problems.json have other quantities")
    write_table(SHEET / "values.csv", header(), COLUMNS, rows)
    page = STORED.parent / "doc" / "sheet.md"
    checksum = read_table(SHEET / "values.csv")[0]["sha256"]
    page.write_text(re.sub(r"(?<=sha256 )[0-9a-f]{64}", checksum, page.read_text()))


def sample(given):
    count = 0
    for problem in read_problems():
        if not given.all and problem["id"] not in SAMPLE:
            continue
        made = rows_of(problem, given)
        old = [[entry[column] for column in COLUMNS] for entry in stored() if entry["problem"] == problem["id"]]
        if made and given.balls and made != old:
            raise ValueError(f"{problem['id']}: stored {old}, recomputed {made}")
        count += len(made or [])
    print(f"values.csv: {count} values recomputed by {'both routes' if given.balls else 'the second route'}, all agree")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    action = parser.add_mutually_exclusive_group(required=True)
    action.add_argument("--seal", action="store_true")
    action.add_argument("--write", action="store_true")
    action.add_argument("--sample", action="store_true")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--balls", metavar="PROGRAM", type=Path)
    parser.add_argument("--pulloff", metavar="PROGRAM", type=Path)
    given = parser.parse_args()
    mp.dps = 40
    return run(seal if given.seal else write if given.write else sample, given)


if __name__ == "__main__":
    sys.exit(main())
