#!/usr/bin/env python3
"""Scores of programs on the adhesion sheet: each is run on the problems that it can be asked, one process a problem.

    sheet_scores.py --write                       run every program that is found, write sheet/scoreboard.csv (a quarter of an hour)
    sheet_scores.py --only NAME ...               these programs; the rows of the others stay
    sheet_scores.py --table                       the stored scores as a table of Markdown
    --program PULLOFF                             the program of this project (default build/src/cli/pulloff)
    --adhesion FOLDER                             a checkout of ContactEngineering/Adhesion

Programs: NumPy, Octave and Fortran with the equal triangular elements of the paper, and a relaxation in time
(reference/solvers); the formulas of JKR and Maugis of ContactEngineering/Adhesion; two particles with the JKR contact of
LAMMPS (sheet_lammps.py); pulloff at its default tolerance. Digits are those of sheet/score.py, the least of the quantities
that were answered; seconds are of processor time, of one run.
"""

import argparse
import csv
import importlib.util
import json
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from numpy.polynomial import Chebyshev
from scipy.optimize import brentq, minimize_scalar

import sheet_elastic
import sheet_lammps
from command_line import STORED, run
from sheet_lammps import NotAsked
from tables import read_table, write_table

SOLVERS, SHEET = STORED / "solvers", STORED / "sheet"
LIMIT = 30                 # seconds of processor time of a run; longer ones are stopped
COLUMNS = "program version command problem level asked answered force digits certified seconds".split()
WAVY, SMOOTH = {"tabor", "A", "wavelength", "R", "outer_radius", "preload"}, {"tabor", "R"}

HEADER = {
    "what": "scores of programs on adhesion-sheet-1", "source": "each program was run on the problems that it can be asked",
    "kind": "oracle", "method": "reference/make/sheet_scores.py",
    "units": "force and digits: the correct digits of score.py, of the pull-off force and of the worst quantity that was answered; "
             f"seconds: processor time of one run, nan if it failed or was stopped after {LIMIT} seconds",
    "uncertainty": "seconds: a factor of two between machines; digits: none", "generator": "reference/make/sheet_scores.py",
    "command": "python3 reference/make/sheet_scores.py --write --adhesion FOLDER", "date": "2026-11-27"}

specification = importlib.util.spec_from_file_location("score", SHEET / "score.py")
score = importlib.util.module_from_spec(specification)
specification.loader.exec_module(score)


def stopped_later():
    resource.setrlimit(resource.RLIMIT_CPU, (LIMIT, LIMIT))


def processor(words, **options):
    """Runs a command. Returns its output, and seconds of processor time."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(words, check=True, capture_output=True, text=True, preexec_fn=stopped_later, **options)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return done.stdout, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


# ------------------------------------------------------------------- solvers that answer the protocol

def request(problem, nodes):
    """The point that a solver is asked (doc/solvers.md)."""
    if problem["group"] != sheet_elastic.GROUP or not SMOOTH <= set(problem["parameters"]) <= WAVY:
        raise NotAsked
    p = {key: float(value) for key, value in problem["parameters"].items()}
    scene = {"tabor": p["tabor"], "radius": p["R"], "outer_radius": p.get("outer_radius", "inf")}
    if "A" in p:
        scene |= {"amplitude": p["A"], "wavelength": p["wavelength"]}
    preload = {"approach": p.get("preload"), "load": None if "preload" in p else 1.0}
    return {"id": "1", "scene": scene, "knob": {"nodes": nodes}, "preload": preload, "approach_start": None, "approach_end": None}


def as_table(point):
    """The request as a table."""
    columns = {"id": point["id"], "preload_approach": point["preload"]["approach"], "preload_load": point["preload"]["load"],
               "nodes": point["knob"]["nodes"], **point["scene"]}
    return "\n".join([",".join(columns), ",".join("-" if v is None else str(v) for v in columns.values())]) + "\n"


def ask(command, point):
    """The answer to one point, and the seconds."""
    with tempfile.TemporaryDirectory() as folder:
        files = {name: str(Path(folder) / name) for name in ("request", "table", "response")}
        Path(files["request"]).write_text(json.dumps({"protocol": "pulloff-ask/1", "repeats": 1, "points": [point]}))
        Path(files["table"]).write_text(as_table(point))
        _, seconds = processor([word.format(here=SOLVERS, **files) for word in command], cwd=folder,
                               env={"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "PATH": "/usr/bin:/bin"})
        answer = json.loads(Path(files["response"]).read_text().splitlines()[0])
    if answer["status"] != "ok":
        raise RuntimeError(answer.get("reason", answer["status"]))
    return answer, seconds


def branch_solver(command, nodes):
    """A solver that follows the branch: pull-off and folds."""
    def solve(problem):
        answer, seconds = ask(command, request(problem, nodes))
        off = answer["pull_off"]
        found = {"pull_off_force": off["force"], "pull_off_approach": off["approach"], "pull_off_radius": off["contact_radius"]}
        for kind in ("jump_in", "jump_out"):
            for fold in sheet_elastic.order([f for f in answer["folds"] if f["kind"] == kind], kind)[:1]:
                found |= {f"{kind}_approach": fold["approach"], f"{kind}_load": fold["load"]}
        return found, seconds
    return solve


def relaxation(problem):
    """Loading and unloading of the relaxation in time, once for each preload."""
    p = problem["parameters"]
    if problem["id"] != "elastic-wavy-preload":
        raise NotAsked
    found, total = {}, 0.0
    for i in (1, 2, 3):
        point = request({**problem, "parameters": {k: v for k, v in p.items() if "preload" not in k}}, 251)
        point["preload"] = {"approach": p[f"preload_{i}"], "load": None}
        answer, seconds = ask(["/usr/bin/python3", "{here}/relax.py", "{request}", "{response}"], point)
        found[f"force_{i}"], total = answer["hysteresis"]["force"], total + seconds
        loading = [jump["approach"] for jump in answer["hysteresis"]["jumps"] if jump["phase"] == "loading"]
    found |= {f"step_{i}_approach": approach for i, approach in enumerate(loading[-2:], 1)}
    return found, total


# ------------------------------------------------------------------------------- closed forms of others

def lowest(function, low, high):
    """Where a function is lowest: of a polynomial near the minimum that SciPy finds."""
    near = minimize_scalar(function, bounds=(low, high), method="bounded").x
    nodes = near * (1.0 + 0.03 * np.cos(np.pi * (np.arange(12) + 0.5) / 12))
    polynomial = Chebyshev.fit(nodes, [function(a) for a in nodes], 11)
    return min((x.real for x in polynomial.deriv().roots() if abs(x.imag) < 1e-9), key=lambda x: abs(x - near))


def adhesion_theories(folder):
    """JKR and Maugis of ContactEngineering/Adhesion, with the minimisers and roots of SciPy."""
    def module(name):
        path = Path(folder) / "Adhesion" / "ReferenceSolutions" / f"{name}.py"
        spec = importlib.util.spec_from_file_location(name, path)
        found = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(found)
        return found

    def states(problem):
        """Load and approach as functions of the contact radius, and the units of contact radius, approach and load."""
        if problem["id"] != "law-jkr" and not problem["id"].startswith("law-maugis"):
            raise NotAsked
        p = {key: float(value) for key, value in problem["parameters"].items()}
        if problem["id"] != "law-jkr":
            maugis = module("MaugisDugdale")
            return (lambda a: maugis._load_and_displacement(a, p["lambda"])), 1.0, 1.0, 1.0
        modulus = 1.0 / sum((1.0 - p[f"nu{i}"]**2) / p[f"E{i}"] for i in (1, 2))
        radius, work = 1.0 / (1.0 / p["R1"] + 1.0 / p["R2"]), p["gamma1"] + p["gamma2"] - p["gamma12"]
        jkr, units = module("JKR"), (radius, modulus, work)
        return ((lambda a: (jkr.force(contact_radius=a), jkr.penetration(contact_radius=a))), jkr.radius_unit(*units),
                jkr.height_unit(*units), jkr.load_unit(radius, work))

    def solve(problem):
        before = resource.getrusage(resource.RUSAGE_SELF).ru_utime
        state, across, height, load = states(problem)
        off = lowest(lambda a: state(a)[0], 0.1, 4.0)
        zero = brentq(lambda a: state(a)[0], off, 6.0, xtol=1e-15)
        found = {"pull_off_force": -state(off)[0] * load, "pull_off_radius": off * across, "pull_off_approach": state(off)[1] * height,
                 "zero_load_radius": zero * across, "zero_load_approach": state(zero)[1] * height}
        if any(quantity["name"] == "grips_radius" for quantity in problem["quantities"]):     # others end without contact
            grips = lowest(lambda a: state(a)[1], 0.05, off)
            found |= {"grips_force": -state(grips)[0] * load, "grips_radius": grips * across, "grips_approach": state(grips)[1] * height}
        if "D1" in problem["parameters"]:
            target = float(problem["parameters"]["D1"]) / height
            found["load_at_approach"] = state(brentq(lambda a: state(a)[1] - target, off, 8.0, xtol=1e-15))[0] * load
        return found, resource.getrusage(resource.RUSAGE_SELF).ru_utime - before
    return solve


# --------------------------------------------------------------------------------------- this program

def pulloff(program):
    def solve(problem):
        if problem["group"] != sheet_elastic.GROUP:
            raise NotAsked
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        found = {name: value for name, (value, _) in sheet_elastic.second_route(problem, program, "1e-6").items()}
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return found, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return solve


def version(*words):
    """The first line that a program prints."""
    done = subprocess.run(words, check=True, capture_output=True, text=True)
    return (done.stdout or done.stderr).splitlines()[0].replace(",", "")


def programs(given):
    """(name, version, command, solve) of the programs that can be run."""
    numpy = f"NumPy {np.__version__}"
    python, here = "/usr/bin/python3", "reference/solvers"
    fortran = ["sh", "-c", 'gfortran -O2 -o triangles "$0" -lopenblas && exec ./triangles "$1" "$2"', "{here}/triangles.f90",
               "{table}", "{response}"]
    yield ("NumPy: 500 triangles", numpy, f"{here}/newton.py; nodes 501",
           branch_solver([python, "{here}/newton.py", "{request}", "{response}"], 501))
    yield ("Octave: 250 triangles", version("octave-cli", "--version"), f"{here}/paper.m; nodes 251",
           branch_solver(["octave-cli", "--no-gui", "--quiet", "{here}/paper.m", "{request}", "{response}"], 251))
    yield ("Fortran: 500 triangles", version("gfortran", "--version"), f"{here}/triangles.f90; nodes 501", branch_solver(fortran, 501))
    yield ("NumPy: relaxation, 250 triangles", numpy, f"{here}/relax.py; nodes 251", relaxation)
    if given.adhesion:
        yield ("Adhesion: JKR and Maugis", "Adhesion " + version("grep", "-m1", "-o", "v[0-9][0-9.]*", str(given.adhesion / "Adhesion/CHANGELOG.md")),
               "Adhesion.ReferenceSolutions with SciPy", adhesion_theories(given.adhesion))
    if sheet_lammps.found():
        yield "LAMMPS: pair granular jkr", sheet_lammps.version(), "reference/make/sheet_lammps.py", sheet_lammps.solve
    yield ("pulloff", version(str(given.program), "--version"), "pulloff solve; tolerance 1e-6", pulloff(given.program))


def rows_of(name, versions, command, solve, problems, values):
    """The rows of a program."""
    for problem in problems:
        try:
            found, seconds = solve(problem)
        except NotAsked:
            continue
        except (RuntimeError, subprocess.SubprocessError, ValueError) as why:
            print(f"{name}, {problem['id']}: {why}", file=sys.stderr, flush=True)
            found, seconds = {}, float("nan")
        names = [quantity["name"] for quantity in problem["quantities"]]
        each = {q: score.digits(float(found[q]), values[problem["id"], q]) for q in names if q in found}
        certified = min(int(values[problem["id"], q]["digits"]) for q in names)
        yield [name, versions, command, problem["id"], problem["level"], str(len(names)), str(len(each)),
               f"{each['pull_off_force']:.1f}" if "pull_off_force" in each else "-", f"{min(each.values(), default=0.0):.1f}",
               str(certified), f"{seconds:.2g}"]


def write(given):
    path, problems, (values, _) = SHEET / "scoreboard.csv", sheet_elastic.read_problems(), score.read_values()
    rows = [list(entry.values()) for entry in read_table(path)[1]] if path.exists() and given.only else []
    rows = [row for row in rows if not any(word in row[0] for word in given.only)]
    for program in programs(given):
        if not given.only or any(word in program[0] for word in given.only):
            for row in rows_of(*program, problems, values):
                rows.append(row)
                print(*row[:1], *row[3:], sep=", ", flush=True)
            write_table(path, HEADER, COLUMNS, rows)


def table():
    """The stored scores, a line a problem that another program than pulloff was asked, and a column a program."""
    rows = read_table(SHEET / "scoreboard.csv")[1]
    names = list(dict.fromkeys(row["program"] for row in rows))
    cells = {(row["problem"], row["program"]): row for row in rows}
    print("| problem | " + " | ".join(names) + " |\n|---|" + "---|" * len(names))
    for problem in dict.fromkeys(p["id"] for p in sheet_elastic.read_problems()):
        line = [cell(cells.get((problem, name))) for name in names]
        if any(of for of, name in zip(line, names) if name != "pulloff"):
            print(f"| {problem} | " + " | ".join(line) + " |")


def cell(row):
    if row is None:
        return ""
    if row["seconds"] == "nan":
        return "stopped"
    part = "" if row["answered"] == row["asked"] else f" ({row['answered']} of {row['asked']})"
    force = "" if row["force"] in ("-", row["digits"]) else f"{row['force']}, "
    return f"{force}{row['digits']}{part}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    action = parser.add_mutually_exclusive_group(required=True)
    action.add_argument("--write", action="store_true")
    action.add_argument("--table", action="store_true")
    parser.add_argument("--only", nargs="+", default=[])
    parser.add_argument("--program", type=Path, default=Path("build/src/cli/pulloff"))
    parser.add_argument("--adhesion", type=Path)
    given = parser.parse_args()
    return run(lambda _: write(given) if given.write else table(), given)


if __name__ == "__main__":
    sys.exit(main())
