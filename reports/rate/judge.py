#!/usr/bin/python3
"""Judges the published table of viscoelastic pull-offs, row by row, and looks for the causes of what is off.

    judge.py PROGRAM FOLDER OUTPUT [--sample N --seed S] [--coarse N] [--jobs N] [--seconds S]

Solves the rows (solve_rows.py, which keeps results) and writes OUTPUT/table.json for the report. A row is off if its
force differs by more than 0.1 % from ours and by more than our stated error. Each row that is off has the first cause
that is shown for it:

    repeated    the table has the same inputs again, with a force that differs by more than 0.1 %
    falls       the table has a smaller force at a greater speed, or a greater one at a smaller speed, by more than
                0.1 %, and otherwise equal inputs; ours do not
    cut         the relaxed contact reaches R, or our surface, cut at R, halves the difference
    none shown  nothing of this

Of the rows without a cause --coarse N are drawn, and solved by an independent march of first order with constant steps
(reference/make/coarse_steps.py): whether some step from 0.05 to 0.4 epsilon leads to the force of the table.

Exit code: 0 judged, 2 wrong usage, 3 a solve failed."""

import argparse
import collections
import json
import multiprocessing
import os
import pathlib
import random
import statistics
import sys

from solve_rows import RADIUS, drawn, read_table, scene, solve_all, store_of

LIMITS = (1e-3, 1e-2, 3e-2)  # of the verdicts, relative
HERTZ = 1.5  # the unit of the force in the table, over pi w R
ANY = 1e300  # an upper edge: JSON has no infinity
NEAR_THE_END = 0.7  # of R: contacts that are wider are solved again on a surface that is cut at R
CAUSES = ("repeated", "falls", "cut", "none shown")
STEPS = (0.1, 0.2, 0.05, 0.3, 0.4)  # of the coarse marches, epsilon, in the order in which they are made
SAME = 1e-3  # of a force that a step leads to


def force_of(row):
    return HERTZ * float(row["outputAmplification"])


def family(row):
    return tuple(row[name] for name in ("alphaload", "mu", "k", "n"))


class Table:
    """The rows of the table beside our results."""

    def __init__(self, rows, known, everything):
        self.rows, self.known = rows, known
        self.repeats, self.speeds = collections.defaultdict(list), collections.defaultdict(list)
        for row in everything:
            self.repeats[scene(row)].append(force_of(row))
            self.speeds[family(row)].append((-float(row["runload"]), force_of(row), scene(row)))

    def ours(self, row, outer="inf"):
        found = self.known.get(scene(row, outer))
        return found if found and found["status"] == "ok" else None

    def difference(self, row, outer="inf"):
        found = self.ours(row, outer)
        return force_of(row) / float(found["force"]) - 1.0 if found else None

    def is_off(self, row):
        found = self.ours(row)
        return abs(self.difference(row)) > LIMITS[0] + float(found["error"]) / float(found["force"])

    def falls(self, row):
        """Whether another speed contradicts the row, and our forces, where both are known, do not."""
        speed, force, mine = -float(row["runload"]), force_of(row), float(self.ours(row)["force"])
        for other_speed, other_force, key in self.speeds[family(row)]:
            found = self.known.get(key)
            if other_speed == speed or found is None or found["status"] != "ok":
                continue
            faster = 1.0 if other_speed > speed else -1.0
            if faster * (other_force / force - 1.0) < -LIMITS[0] < faster * (float(found["force"]) / mine - 1.0):
                return True
        return False

    def cause(self, row):
        values = self.repeats[scene(row)]
        if max(values) > (1.0 + LIMITS[0]) * min(values):
            return "repeated"
        if self.falls(row):
            return "falls"
        if float(self.ours(row)["preload_radius"]) >= RADIUS:
            return "cut"
        cut = self.difference(row, f"{RADIUS:g}")
        return "cut" if cut is not None and abs(cut) < 0.5 * abs(self.difference(row)) else "none shown"


def coarse_force(row_and_step):
    """The force of a row by a march with a coarse step; None: it does not converge."""
    row, step = row_and_step
    os.environ["OPENBLAS_NUM_THREADS"] = "1"
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "reference" / "make"))
    import coarse_steps  # numpy and scipy are needed for this alone
    try:
        test = coarse_steps.smooth(row["mu"], f"gamma:{row['k']};{row['n']}", row["alphaload"], repr(-float(row["runload"])))
        return coarse_steps.greatest_tension(test, step)
    except coarse_steps.NotConverged:
        return None


def coarse_step(steps, forces, ours, wanted):
    """The step that leads to a force, by straight lines between the steps that were made and our force at the step 0; None: there
    is none between them. A step that does not converge ends the lines."""
    made = sorted(zip(steps, forces))
    points = [(0.0, ours)] + made[:next((k for k, (_, force) in enumerate(made) if force is None), len(made))]
    for (low, first), (high, last) in zip(points, points[1:]):
        if min(first, last) <= wanted <= max(first, last):
            return low if first == last else low + (high - low) * (wanted - first) / (last - first)
    near = min(points[1:], key=lambda point: abs(point[1] / wanted - 1.0), default=None)
    return near[0] if near and abs(near[1] / wanted - 1.0) <= SAME else None


def march_coarsely(table, rows, jobs):
    """What coarse marches of some rows show: how many rows have a step that leads to their force, of those above and below ours; the
    median step of those above."""
    forces, found = {index: [] for index in range(len(rows))}, {}
    with multiprocessing.Pool(jobs) as pool:
        for k, step in enumerate(STEPS):
            left = [index for index in forces if index not in found]
            for index, force in zip(left, pool.imap(coarse_force, [(rows[index], step) for index in left])):
                forces[index].append(force)
                at = coarse_step(STEPS[:k + 1], forces[index], float(table.ours(rows[index])["force"]), force_of(rows[index]))
                if at is not None:
                    found[index] = at
    above = [index for index, row in enumerate(rows) if table.difference(row) > 0.0]
    steps = [found[index] for index in above if index in found]
    return {"rows": len(rows), "shown": len(found), "above": len(above), "above_shown": len(steps),
            "step": statistics.median(steps) if steps else None}


def shares(differences):
    """Number of rows, the parts within each limit, median and extremes of the differences."""
    found = {"rows": len(differences)}
    if differences:
        found["within"] = [sum(abs(d) <= limit for d in differences) / len(differences) for limit in LIMITS]
        found |= {"median": statistics.median(differences), "least": min(differences), "greatest": max(differences)}
    return found


def by(rows, table, number, edges):
    """The shares of the rows in each range [edge, next edge) of a number."""
    ranges = []
    for low, high in zip(edges, edges[1:]):
        inside = [table.difference(row) for row in rows if low <= number(row) < high]
        if inside:
            ranges.append({"from": low, "to": high, **shares(inside)})
    return ranges


def judge(table, coarse, seed, jobs):
    solved = [row for row in table.rows if table.ours(row)]
    off = [row for row in solved if table.is_off(row)]
    causes = {name: [] for name in CAUSES}
    for row in off:
        causes[table.cause(row)].append(row)
    seconds = [float(found["seconds"]) for found in table.known.values() if found["seconds"]]
    left = causes["none shown"]
    narrow = [row for row in solved if float(table.ours(row)["preload_radius"]) < NEAR_THE_END * RADIUS]

    def way(row):
        return float(row["alphaload"]) - float(table.ours(row)["approach"])

    asked = random.Random(seed).sample(left, min(coarse, len(left)))
    worst = sorted(off, key=lambda row: -abs(table.difference(row)))[:12]
    return {
        "schema": "pulloff-rate/1", "rows": len(table.rows), "solved": len(solved), "limits": LIMITS, "off": len(off),
        "all": shares([table.difference(row) for row in solved]),
        "causes": {name: {"above": sum(table.difference(row) > 0.0 for row in of),
                          **shares([table.difference(row) for row in of])} for name, of in causes.items()},
        "coarse_steps": march_coarsely(table, asked, jobs),
        "none_shown_beyond": [sum(abs(table.difference(row)) > limit for row in left) for limit in LIMITS],
        "by_radius": by(solved, table, lambda row: float(table.ours(row)["preload_radius"]) / RADIUS,
                        (0.0, 0.2, 0.4, 0.7, 1.0, ANY)),
        "by_way": by(narrow, table, way, (0.0, 1.0, 3.0, 10.0, 30.0, ANY)),
        "by_speed": by(narrow, table, lambda row: -float(row["runload"]), (0.0, 1.0, 1e2, 1e4, 1e6, 1e8, ANY)),
        "seconds": {"median": statistics.median(seconds), "greatest": max(seconds), "sum": sum(seconds)} if seconds else None,
        "worst": [{name: row[name] for name in ("file", "line", "runload", "alphaload", "mu", "k", "n")} |
                  {"table": force_of(row), "ours": float(table.ours(row)["force"]), "error": float(table.ours(row)["error"]),
                   "difference": table.difference(row), "cause": table.cause(row)} for row in worst],
    }


def percent(part):
    return f"{100.0 * part:.1f} %"


def describe(found):
    """The lines that are printed."""
    yield f"{found['solved']} of {found['rows']} rows solved"
    if not found["solved"]:
        return
    yield "differences of the table from ours, relative to ours"
    yield f"{'':34} {'rows':>6} {'0.1 %':>8} {'1 %':>8} {'3 %':>8} {'median':>9} {'least':>9} {'greatest':>9}"

    def line(name, of):
        if not of["rows"]:
            return f"{name:34} {0:6}"
        within = " ".join(f"{percent(part):>8}" for part in of["within"])
        return f"{name:34} {of['rows']:6} {within} {of['median']:9.1e} {of['least']:9.1e} {of['greatest']:9.1e}"

    yield line("all", found["all"])
    def range_of(of):
        return f"{of['from']:g} or more" if of["to"] == ANY else f"{of['from']:g} to {of['to']:g}"

    for key, words in (("by_radius", "relaxed contact radius/R"), ("by_way", "way to the pull-off, eps"),
                       ("by_speed", "speed, eps/tau_0")):
        for of in found[key]:
            yield line(f"{words} {range_of(of)}", of)
    yield f"{found['off']} rows are off; first cause that is shown:"
    for name, of in found["causes"].items():
        yield line(f"  {name}, {of['above']} of them above", of)
    beyond = found["none_shown_beyond"]
    yield f"no cause is shown for {beyond[0]} rows beyond 0.1 %, {beyond[1]} beyond 1 %, {beyond[2]} beyond 3 %"
    coarse = found["coarse_steps"]
    if coarse["rows"]:
        below, below_shown = coarse["rows"] - coarse["above"], coarse["shown"] - coarse["above_shown"]
        yield (f"{coarse['rows']} of these were marched with constant steps of 0.05 to 0.4 eps: one of them leads to the force of "
               f"{coarse['above_shown']} of {coarse['above']} rows above ours"
               + (f" ({coarse['step']:.2g} eps in the median)" if coarse["step"] else "") + f" and of {below_shown} of {below} below")
    seconds = found["seconds"]
    yield f"{seconds['sum']:.0f} s in all; a row {seconds['median']:.2f} s in the median, {seconds['greatest']:.1f} s at most"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("folder")
    parser.add_argument("output")
    parser.add_argument("--sample", type=int, help="number of rows that are drawn (default: all)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--coarse", type=int, default=100, help="number of rows without a cause that are marched with coarse steps (100)")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seconds", type=float, default=float("inf"), help="time after which no further row is begun")
    given = parser.parse_args()
    everything = read_table(given.folder)
    rows = drawn(everything, given.sample, given.seed)
    store = store_of(given.program, given.output)
    known = solve_all(given.program, [scene(row) for row in rows], store, given.jobs, given.seconds)
    table = Table(rows, known, everything)
    wide = [row for row in rows if table.ours(row) and table.is_off(row) and
            NEAR_THE_END * RADIUS <= float(table.ours(row)["preload_radius"]) < RADIUS]
    table.known = solve_all(given.program, [scene(row, f"{RADIUS:g}") for row in wide], store, given.jobs, given.seconds)
    found = judge(table, given.coarse, given.seed, given.jobs)
    pathlib.Path(given.output, "table.json").write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    for line in describe(found):
        print(line)
    failed = [row for row in rows if scene(row) in table.known and not table.ours(row)]
    for row in failed[:10]:
        print(f"{row['file']}:{row['line']}: {table.known[scene(row)]['reason']}")
    return 3 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
