#!/usr/bin/env python3
"""The certified values of the adhesion sheet for elastic bodies with a traction-separation law.

    sheet_elastic.py --write --program PULLOFF   both routes; replaces the rows of this group in sheet/values.csv (some minutes)
    ... --only ID ...                            these problems
    sheet_elastic.py --sample                    the first route again, on one level, for the values without a table of
                                                 their own, and the tables against the others (exit 1 on disagreement)

Route 1 are Copson panels: the tables of this folder (smooth_sphere.py, wavy_sphere.py, general.py, wavy_staircase.py), and
what sheet_points.py computes: the beginning of the S-shaped branch, the jumps through a spring, a very soft sphere, an isolated branch. Route 2 is
the program pulloff at its finest tolerance; it shares no code and no method with route 1. The half-width of a value is the
difference of the routes plus the greater of their own bounds.
"""

import argparse
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
from mpmath import mp, mpf
from numpy.polynomial import Polynomial

import sheet_points
from command_line import STORED, run
from sheet import COLUMNS, SHEET, header, read_problems, row, stored
from tables import read_table, write_table

GROUP = "full law, elastic"
SOFT, ISOLATED = "elastic-tabor-1e3", "elastic-isolated"
TOLERANCE = "1e-10"
FINEST = "pulloff at a tolerance of 1e-10: panels and elliptic kernel"
LENNARD_JONES = "mie:3,9"
FLOOR = 1e-10              # least bound of route 1
NODES = np.array("0.6975 0.698 0.699 0.7 0.703 0.706 0.708 0.712 0.718 0.725 0.73".split(), float)


def law(p):
    """The law of a problem as a word of the program."""
    if "m" in p:
        return f"mie:{p['m']},{p['n']}"
    return f"morse:{p['a']}" if "a" in p else LENNARD_JONES


def profile(p):
    """Its initial gap without waves."""
    if "t" in p:
        return f"cone:{p['t']}"
    return f"truncated:{p['b']},{p['R_t']}" if "b" in p else "sphere"


def waves(p):
    """Its waves (amplitude, length), where it has more than one."""
    return [(p[f"A_{i}"], p[f"L_{i}"]) for i in (1, 2) if f"A_{i}" in p]


# ------------------------------------------------------------------------------------------------ route 1

def special_points(problem):
    """The table of a problem: (name, its special points in order, the factor of the contact radius)."""
    p = problem["parameters"]
    if "coupling" in p:
        wanted = {"law": law(p).replace(",", ";"), "profile": profile(p).replace(",", ";"),
                  "waves": ";".join("@".join(wave) for wave in waves(p)) or "-", "coupling": p["coupling"],
                  "radius": p.get("R", "-"), "outer_radius": p.get("outer_radius", "inf")}
        return "general_special_points.csv", matching("general_special_points.csv", wanted), "contact_radius", 1.0
    if p.get("outer_radius", "inf") == "inf":
        return ("feng_landmarks.csv", matching("feng_landmarks.csv", {"tabor": p["tabor"]}),
                "contact_radius_over_root_radius", np.sqrt(float(p["R"])))
    wanted = {"tabor": p["tabor"], "amplitude": p.get("A", "0"), "wavelength": p.get("wavelength", "20"), "radius": p["R"],
              "outer_radius": p["outer_radius"]}
    return "wavy_landmarks.csv", matching("wavy_landmarks.csv", wanted), "contact_radius", 1.0


def matching(table, wanted):
    rows = [entry for entry in read_table(STORED / table)[1] if all(same(entry[k], v) for k, v in wanted.items())]
    if not rows:
        raise ValueError(f"{table} has no row with {wanted}")
    return rows


def same(text, value):
    try:
        return float(text) == float(value)
    except ValueError:
        return text == value


def tabulated(problem):
    """{quantity: (value, bound)} from the table of special points, and its name."""
    table, rows, radius, factor = special_points(problem)
    lowest = min((r for r in rows if r["kind"] == "minimum"), key=lambda r: float(r["load"]))
    folds = {kind: next(iter(order([r for r in rows if r["kind"] == kind], kind)), None) for kind in ("jump_in", "jump_out")}
    found = {}
    for point, entry in {"pull_off": lowest, **folds}.items():
        if entry:
            found[f"{point}_approach"] = number(entry, "approach")
            found[f"{point}_load"] = number(entry, "load")
            value, bound = number(entry, radius)
            found[f"{point}_radius"] = value * factor, bound * factor
    value, bound = found["pull_off_load"]
    found["pull_off_force"] = -value, bound
    return found, f"{table}: Copson panels"


def order(folds, kind):
    """The fold at which loading jumps in is the first one; that from which unloading jumps out is the lowest approach."""
    return folds[:1] if kind == "jump_in" else sorted(folds, key=lambda entry: float(entry["approach"]))


def number(entry, column):
    return float(entry[column]), float(entry[column + "_uncertainty"])


def staircase(problem):
    """The force after each preload."""
    p = problem["parameters"]
    rows = matching("wavy_staircases.csv", {"tabor": p["tabor"], "amplitude": p["A"], "wavelength": p["wavelength"],
                                            "radius": p["R"], "outer_radius": p["outer_radius"]})
    found = {}
    for i in (1, 2, 3):
        preload = float(p[f"preload_{i}"])
        entry = next(r for r in rows if float(r["from_approach"]) < preload < float(r["until_approach"]))
        found[f"force_{i}"] = number(entry, "force")
    for i, entry in enumerate(rows[1:3], 1):
        found[f"step_{i}_approach"] = number(entry, "from_approach")
    return found, "wavy_staircases.csv: Copson panels; relaxation in time"


def first_route(problem, levels=None):
    """{quantity: (value, bound)} and the name of the route."""
    own = {"elastic-s-begins": sheet_points.s_begins, "elastic-spring": sheet_points.spring, SOFT: sheet_points.soft,
           ISOLATED: sheet_points.isolated}
    if problem["id"] in own:
        return own[problem["id"]](problem["parameters"], levels), "Copson panels (sheet_points.py)"
    return staircase(problem) if problem["id"] == "elastic-wavy-preload" else tabulated(problem)


# ------------------------------------------------------------------------------------------------ route 2

def words(p):
    """The options of `pulloff solve` for the parameters of a problem."""
    names = {"tabor": "--tabor", "R": "--radius", "A": "--amplitude", "wavelength": "--wavelength", "coupling": "--coupling",
             "outer_radius": "--outer-radius", "stiffness": "--stiffness", "preload_load": "--preload-load",
             "preload": "--preload"}
    out = [word for key, name in names.items() if key in p for word in (name, str(p[key]))]
    for option, word, standard in (("--law", law(p), LENNARD_JONES), ("--profile", profile(p), "sphere")):
        out += [option, word] if word != standard else []
    return out + [word for wave in waves(p) for word in ("--wave", ",".join(wave))]


def solve(program, options):
    text = subprocess.run([program, "solve", "--json", *options], check=True, capture_output=True, text=True).stdout
    return json.loads(text)


def second_route(problem, program, tolerance=TOLERANCE):
    """{quantity: (value, bound)} of the program."""
    p = problem["parameters"]
    if problem["id"] == "elastic-s-begins":
        return merging_folds(program, tolerance)
    if problem["id"] == ISOLATED:
        return isolated_folds(p, program, tolerance)
    result = solve(program, words(p) + ["--tolerance", tolerance] + wanted(problem))
    if problem["id"] == "elastic-wavy-preload":
        return steps(result, p)
    if problem["id"] == "elastic-spring":
        return base_at_jumps(result, float(p["stiffness"]))
    return points(result)


def wanted(problem):
    if problem["id"] == "elastic-wavy-preload":
        return ["--preload", "3", "--want", "preload"]
    return ["--want", "hysteresis"] if problem["id"] == "elastic-spring" else []


def points(result):
    """Pull-off and folds."""
    off, folds = result["pull_off"], result["folds"]
    found = {"pull_off_force": (off["force"], off["error_estimate"]),
             "pull_off_approach": (off["approach"], off["approach_error_estimate"]),
             "pull_off_radius": (off["contact_radius"], off["contact_radius_error_estimate"])}
    for kind in ("jump_in", "jump_out"):
        for fold in order([f for f in folds if f["kind"] == kind], kind)[:1]:
            found[f"{kind}_approach"] = fold["approach"], fold["error_estimate"]
            found[f"{kind}_load"] = fold["load"], fold["load_error_estimate"]
    return found


def steps(result, p):
    """The force after each preload, and the preloads at which it changes."""
    rows = result["staircase"]["displacement_control"]["steps"]
    found = {}
    for i in (1, 2, 3):
        step = next(s for s in reversed(rows) if s["preload"]["approach"] < float(p[f"preload_{i}"]))
        found[f"force_{i}"] = step["force"], step["error_estimate"]
    for i, step in enumerate(rows[1:3], 1):
        found[f"step_{i}_approach"] = step["preload"]["approach"], step["preload"]["error_estimate"]
    return found


def base_at_jumps(result, stiffness):
    """The position of the base of the spring at each jump. The program states no error of it: it is stationary there, so
    that the errors of a fold of this branch hold."""
    bound = max(f["error_estimate"] + f["load_error_estimate"] / stiffness for f in result["folds"])
    return {f"jump_{'in' if jump['phase'] == 'loading' else 'out'}_base":
            (jump["before"]["approach"] + jump["before"]["load"] / stiffness, bound)
            for jump in result["hysteresis"]["spring"]["jumps"]}


def merging_folds(program, tolerance):
    """Where the two folds of the smooth sphere merge. The square of the difference of their loads, and the means of loads
    and approaches, are analytic in mu: polynomials through the folds at NODES."""
    rows = []
    for tabor in NODES:
        folds = solve(program, ["--tabor", repr(float(tabor)), "--tolerance", tolerance])["folds"]
        rows.append([folds[0]["load"], folds[1]["load"], folds[0]["approach"], folds[1]["approach"]])
    first, second, *approaches = np.array(rows).T

    def fitted(degree):
        gap, load, approach = (Polynomial.fit(NODES, y, degree) for y in
                               ((first - second)**2, 0.5 * (first + second), 0.5 * sum(approaches)))
        tabor = min((x.real for x in gap.roots() if abs(x.imag) < 1e-12), key=lambda x: abs(x - NODES[0]))
        return np.array([tabor, approach(tabor), load(tabor)])

    value = fitted(6)
    bounds = np.abs(value - fitted(5))
    return dict(zip(("tabor", "approach", "load"), zip(value, bounds)))


def isolated_folds(p, program, tolerance):
    """The two folds of the isolated branch, each continued in the amplitude from where the branch is connected."""
    options = words({k: v for k, v in p.items() if k != "A"})
    text = subprocess.run([program, "follow", "--json", "--of", "folds", "--key", "amplitude", "--scale", "linear", "--points", "2",
                           "--from", repr(sheet_points.BEFORE), "--to", p["A"], "--preload", "0", "--tolerance", tolerance, *options],
                          check=True, capture_output=True, text=True).stdout
    folds = json.loads(text)["points"][-1]["folds"]
    at = next(i for i, fold in enumerate(folds) if fold["kind"] == "jump_out" and abs((fold["contact_radius"] or 0.0) - 11.45) < 0.05)
    return {f"{fold['kind']}_{name}": (fold[name], fold[error]) for fold in folds[at:at + 2]
            for name, error in (("approach", "error_estimate"), ("load", "load_error_estimate"))}


# ----------------------------------------------------------------------------------------------- the table

def certified(problem, program):
    """The rows of a problem."""
    first, name = first_route(problem)
    second = second_route(problem, program)
    rows = []
    for quantity in (q["name"] for q in problem["quantities"]):
        (one, bound), (other, limit) = first[quantity], second[quantity]
        half_width = abs(mpf(one) - mpf(other)) + max(mpf(bound), mpf(limit), FLOOR if "csv" in name else 0)
        rows.append(row(problem["id"], quantity, mpf(one), half_width, (name, FINEST)))
    return rows


def write(program, names):
    kept, rows = stored(), []
    for problem in read_problems():
        if problem["group"] == GROUP and (not names or problem["id"] in names):
            rows += certified(problem, program)
            print(problem["id"], *(f"{r[1]}: {r[3]} digits" for r in rows if r[0] == problem["id"]), sep=", ", flush=True)
        else:
            rows += [[entry[column] for column in COLUMNS] for entry in kept if entry["problem"] == problem["id"]]
    write_table(SHEET / "values.csv", header(), COLUMNS, rows)


def sample():
    """Recomputes route 1: the tables are read, and the other values computed on the first level."""
    count = 0
    for problem in (p for p in read_problems() if p["group"] == GROUP):
        if problem["id"] in (SOFT, ISOLATED):
            continue             # minutes
        first, _ = first_route(problem, sheet_points.LEVELS[:1])
        for entry in stored():
            if entry["problem"] == problem["id"]:
                value, limit = first[entry["quantity"]][0], float(entry["half_width"])
                if not abs(value - float(entry["value"])) <= limit:
                    raise ValueError(f"{problem['id']} {entry['quantity']}: {value!r}, stored {entry['value']} +- {limit}")
                count += 1
    print(f"values.csv: {count} values of elastic bodies agree with route 1")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    action = parser.add_mutually_exclusive_group(required=True)
    action.add_argument("--write", action="store_true")
    action.add_argument("--sample", action="store_true")
    parser.add_argument("--program", metavar="PULLOFF", type=Path, default=Path("build/src/cli/pulloff"))
    parser.add_argument("--only", metavar="ID", nargs="+", help="with --write: these problems")
    given = parser.parse_args()
    mp.dps = 40
    return run(lambda _: write(given.program, given.only) if given.write else sample(), given)


if __name__ == "__main__":
    sys.exit(main())
