#!/usr/bin/env python3
"""Pull-off of viscoelastic spheres at a constant speed of unloading, from the relaxed contact at a preload or after loading
at a speed and a dwell.

The equations and the method are those of unloading.py; the spectra and the theory of Persson and Brener of creep.py.

    viscoelastic.py --list                                        the tests of the table
    viscoelastic.py --scene 1 0 20 100 inf 'gamma:0.1;0.6' 5 1 - - -  one test (some seconds; tabor amplitude wavelength
                                                                  radius outer_radius viscoelastic preload unload_speed
                                                                  stiffness load_speed dwell)
    viscoelastic.py --published FILE ROW...                       rows (from 1) of a table of ML4Adhesion beside this solver
    viscoelastic.py --sample                                      known limits, a sample compared with the stored table
    viscoelastic.py --write [DIR] [--resume]                      regenerate the table (half an hour); --resume keeps the
                                                                  rows that DIR has
"""

import csv
import hashlib
import sys
from dataclasses import replace

import numpy as np

from branch import NotConverged, smooth_sphere
from command_line import STORED, notes, options, run
from creep import measured, persson_brener, series
from tables import bound, number, read_table, write_table
from unloading import A, B, C, Accuracy, Loading, Test
from wavy_sphere import Scene

TABLE, FENG, DATE = "viscoelastic.csv", "feng_pull_off.csv", "2026-11-28"
MATERIALS = STORED.parent / "cases/materials"
KEYS = "tabor amplitude wavelength radius outer_radius viscoelastic preload unload_speed stiffness load_speed dwell".split()
NAMES = "force approach contact_radius time work dissipated jump_loss end_approach".split()
SCENES = [tuple(line.split() + ["-"] * (len(KEYS) - len(line.split()))) for line in """
    1 0 20 100 inf sls:0.1 5 1 -
    1 0 20 100 inf gamma:0.1;0.6 2.16524 1 -
    1 0 20 100 100 gamma:0.1;0.6 2.16524 1 -
    0.1 0 20 100 inf sls:0.1 2 1 -
    1 0 20 100 inf sls:0.1 5 0.1 -
    1 0 20 100 inf sls:0.1 5 10 -
    1 0 20 100 inf sls:0.1 5 1000 -
    1 0 20 100 inf sls:0.5 2 1 -
    1 0 20 100 inf sls:0.9 2 1 -
    1 0 20 100 inf sls:0.01 5 10 -
    0.1 0 20 100 inf sls:0.1 2 100 -
    0.3 0 20 100 inf sls:0.01 2 10 -
    0.1 0 20 100 inf gamma:0.1;0.2 5 1000 -
    1 0 20 100 inf gamma:0.1;1.5 5 10 -
    0.16 0 20 100 100 gamma:0.1;0.2 15 1000 -
    1 0.5 20 100 100 sls:0.1 5 1 -
    1 1 20 100 100 gamma:0.1;0.6 5 10 -
    2 0 20 100 inf sls:0.1 3 1 -
    2 0 20 100 inf gamma:0.01;0.4 3 100 -
    3 0 20 100 inf sls:0.1 5 1 -
    3 0 20 100 inf sls:0.1 5 1000 -
    2 0.3 20 100 100 sls:0.1 5 10 -
    3 1 20 100 100 sls:0.1 8 100 -
    3 0 20 100 inf gamma:0.1;0.6 5 1 -
    3 0 20 100 inf sls:0.5 2 10 -
    1 0 20 100 inf sls:0.1 5 0.001 -
    2 0 20 100 inf sls:0.3 3 0.1 -
    1 0 20 100 inf sls:0.1 5 1 0.3
    2 0 20 100 100 gamma:0.1;0.6 3 100 1
    1 0.5 20 100 100 sls:0.1 5 10 0.3
    5 0 20 100 inf sls:0.1 2 10 -
    1 0 20 100 inf sls:0.1 5 1 - 1 0
    1 0 20 100 inf sls:0.1 5 1 - 10 1
    1 0 20 100 inf gamma:0.1;0.6 3 10 - 10 0.5
    0.3 0 20 100 inf sls:0.01 2 10 - 100 0
    1 0 20 100 inf sls:0.1 3 1 0.3 1 0.5
    1 0 20 100 inf prony:creep 5 1 -
    1 0.5 20 100 100 prony:relaxation 5 10 -
    1 0 20 100 inf prony:creep 5 1 0.3
""".strip().splitlines()]
SAMPLE = [*SCENES[:4], SCENES[-3]]

# Panels: their width over the length of the relaxed edge is halved until UNRESOLVED bounds the last two Legendre
# coefficients of the traction, over the largest traction, at all times.
WIDTHS, SLOW_SPEED, UNRESOLVED = (2.4, 1.2, 0.6), 0.2, 1e-2
FINE = Accuracy(order=10, tail=14, width=WIDTHS[0], step=1e-6, traction=1e-5)
COARSE_SPACE = {"order": 8, "tail": 12, "traction": 1e-4, "cut": 1.21}
COARSE_TIME = {"step": 1e-5, "spectrum": 0.9}


def material(text):
    """The spectrum, as creep takes it, and k of `sls:k`, `gamma:k;n`, `terms:k;tau_1@w_1;...` or `prony:NAME`, a table of
    cases/materials."""
    name, _, rest = text.partition(":")
    if name == "prony":
        return measured(MATERIALS / f"{rest}.csv")
    if name == "terms":
        k, _, terms = rest.partition(";")
        return f"terms:{terms}", float(k)
    numbers = rest.replace(";", ",").split(",")
    if name not in ("sls", "gamma") or len(numbers) != (1 if name == "sls" else 2):
        raise ValueError(f"material {text}: expected sls:k, gamma:k;n, terms:k;tau@w;... or prony:NAME")
    return name if name == "sls" else f"gamma:{numbers[1]}", float(numbers[0])


def stored(key):
    """The keys of a row as the table has them: of a material its digest."""
    name, _, rest = key[5].partition(":")
    digest = hashlib.sha256((MATERIALS / f"{rest}.csv").read_bytes()).hexdigest() if name == "prony" else rest
    return (*key[:5], f"{name}:{digest}", *key[6:])


def test_of(key, accuracy):
    """The test of a row."""
    scene = Scene(*key[:5], 0.0, 0.0)
    smooth = float(scene.amplitude) == 0.0 and scene.outer_radius == "inf"
    problem = smooth_sphere(float(scene.tabor)) if smooth else scene.problem()
    stiffness = np.inf if key[8] == "-" else float(key[8])
    loading = None if key[9] == "-" else Loading(float(key[9]), float(key[10]))
    return Test(problem, float(key[6]), *material(key[5]), float(key[7]), accuracy, stiffness, loading), scene.width


def measure(key, accuracy):
    """The numbers of a row, and the test and its result."""
    test, width = test_of(key, accuracy)
    result = test.run()
    values = np.array([getattr(result, name) for name in NAMES])
    values[NAMES.index("contact_radius")] *= width
    return values, test, result


def fine(key):
    """The numbers on panels that resolve the traction at all times, and their accuracy."""
    slow = float(key[7]) < SLOW_SPEED or material(key[5])[1] == 1.0
    for width in WIDTHS[slow:]:
        accuracy = replace(FINE, width=width)
        values, test, result = measure(key, accuracy)
        if test.unresolved < UNRESOLVED:
            break
    return values, accuracy, test, result


def solve(key):
    """The numbers of a row, their uncertainties, the imbalance of energy and the number of jumps."""
    values, accuracy, _, result = fine(key)
    in_space = measure(key, replace(accuracy, **COARSE_SPACE))[0]
    in_time = measure(key, replace(accuracy, **COARSE_TIME))[0]
    return values, abs(values - in_space) + abs(values - in_time), result


def cells(key, values, doubt, result):
    return [*stored(key), *map(number, values), *(f"{d:.1e}" for d in np.maximum(doubt, 1e-9)), str(len(result.jumps)),
            f"{result.imbalance:.1e}"]


COLUMNS = [*KEYS, *NAMES, *(name + "_uncertainty" for name in NAMES), "jumps", "imbalance"]


def header(rows):
    largest = max(float(row[COLUMNS.index("force_uncertainty")]) / float(row[COLUMNS.index("force")]) for row in rows)
    balance = max(abs(float(row[-1])) for row in rows)
    return {
        "what": "unloading of a viscoelastic half-space at a constant speed, from the relaxed contact at the preload (an "
                "approach, reached by slow loading), or after loading at load_speed from the approach -10, where the body has "
                "not crept, and holding the approach of the preload for the time dwell: the greatest tension with its approach, contact radius and time, and up to "
                "the end of contact the work of the base, the energy dissipated in the solid, the energy lost in jumps",
        "source": "A. Papangelo, M. Ciavarella, Lubricants 8(9), 90 (2020), doi 10.3390/lubricants8090090, Eqs 10-17, with the "
                  "traction in the deflection replaced by its hereditary integral with the compliance over the relaxed one, "
                  "1 - (1 - k) phi(t); solved anew",
        "kind": "oracle",
        "method": "Copson (double Abel) form of the elastic operator on spectral panels that are fixed in time; tractions of "
                  "Kelvin elements; diagonally implicit Runge-Kutta method of order 4 with an embedded error; jumps at frozen "
                  "history by relaxation against a local damping; shares no code or method with src/",
        "units": "lengths in epsilon, approach > 0 pressed together; force, the greatest tension, in pi w R; energies in "
                 "pi w R epsilon; stiffness of the spring, whose base moves at the speed, in pi w R/epsilon (-: none); time, dwell and "
                 "relaxation times in tau_0, speeds in epsilon/tau_0 (load_speed -: slow loading); "
                 "tabor = (R w^2/(E*^2 epsilon^3))^(1/3) with the relaxed E*; viscoelastic: sls:k, phi = exp(-t), gamma:k;n, "
                 "phi = (1/Gamma(n)) int tau^(n-1) exp(-tau) exp(-t/tau) dtau, k the relaxed over the glassy modulus, or "
                 "prony:SHA256, of a table in cases/materials; "
                 "end_approach: where the gap first exceeds that of the greatest tension, H = 3^(1/6) - 1, everywhere; "
                 "imbalance: work less change of energy, dissipation and losses in jumps",
        "uncertainty": "the differences from two coarser solutions, one in space and one in time, added; not below 1e-9",
        "convergence": f"order of panels {FINE.order} and {COARSE_SPACE['order']}, other panels; tolerance of a step "
                       f"{FINE.step:g} and {COARSE_TIME['step']:g} epsilon, other terms of the spectrum; largest relative "
                       f"uncertainty of a force {largest:.1e}, largest imbalance of energy {balance:.1e}",
        "generator": "reference/make/viscoelastic.py",
        "command": "python3 reference/make/viscoelastic.py --write",
        "date": DATE,
    }


def write_all(folder, resume):
    """The table is written after each row: an interrupted run can be resumed."""
    folder.mkdir(parents=True, exist_ok=True)
    note, path, done = notes(), folder / TABLE, {}
    if resume and path.exists():
        done = {tuple(row[k] for k in KEYS): list(row.values()) for row in read_table(path)[1]}
    for key in SCENES:
        if stored(key) in done:
            continue
        try:
            done[stored(key)] = cells(key, *solve(key))
        except NotConverged as problem:
            note(f"{' '.join(key)}: not tabulated: {problem}")
            continue
        rows = [done[k] for k in map(stored, SCENES) if k in done]
        write_table(path, header(rows), COLUMNS, rows)
        note(" ".join(done[stored(key)]))


# What is known


def known_limits():
    """The method in time has order 4; k = 1 is Feng's problem at any speed; a speed that the history cannot follow has no
    influence; a series of the modulus is converted; the theory of Persson and Brener has its limits."""
    moments = [B.sum() - 1.0, *(B @ C**j - 1.0 / (j + 1.0) for j in (1, 2, 3)), B @ A @ C - 1.0 / 6.0,
               B @ A @ A @ C - 1.0 / 24.0, (B * C) @ A @ C - 0.125, B @ A @ C**2 - 1.0 / 12.0, *(A.sum(axis=1) - C)]
    if not np.max(np.abs(moments)) < 1e-14:
        raise ValueError(f"conditions of order 4: {moments}")
    spectrum, k = measured(MATERIALS / "relaxation.csv")
    for frequency in 0.1, 3.0, 200.0:       # the complex modulus times the complex compliance
        modulus, compliance = (1.0 + sum(part * 1j * frequency * time / (1.0 + 1j * frequency * time) for time, part in parts)
                               for parts in (((0.02, 6.0), (0.5, 3.0)), ((t, -(1.0 - k) * w) for t, w in zip(*series(spectrum[6:])))))
        if not abs(modulus * compliance - 1.0) < 1e-14:
            raise ValueError(f"relaxation.csv as a series of the compliance: {modulus * compliance} at the frequency {frequency}")
    elastic = next(row for row in read_table(STORED / FENG)[1] if row["tabor"] == "1")
    values = fine(("1", "0", "20", "100", "inf", "sls:1", "2", "3", "-", "-", "-"))[0]
    for name, value, limit in ("force", values[0], 1e-7), ("approach", values[1], 1e-4):
        if not abs(value - float(elastic[name])) < limit:
            raise ValueError(f"k = 1: {name} {number(value)}, {FENG} {elastic[name]}")
    fast = [measure(("1", "0", "20", "100", "inf", "sls:0.1", "2", speed, "-", "-", "-"), FINE)[0] for speed in ("1e7", "1e9")]
    if not max(abs(fast[0] - fast[1])[[0, 1, 2, 4, 7]]) < 2e-6:
        raise ValueError(f"the fast limit depends on the speed: {fast[0]}, {fast[1]}")
    for spectrum in "sls", "gamma:0.6", "gamma:1":
        gains = [persson_brener(spectrum, 0.1, speed) for speed in (1e-6, 1e-2, 1.0, 1e2, 1e9)]
        if not (np.all(np.diff(gains) > 0.0) and gains[0] < 1.001 and gains[-1] > 9.99):
            raise ValueError(f"Persson and Brener, {spectrum}: {gains}")


def sample(folder):
    """Known limits, and the sample compared with the stored table."""
    known_limits()
    table = {tuple(row[k] for k in KEYS): row for row in read_table(folder / TABLE)[1]}
    for key in SAMPLE:
        values, _, _, result = fine(key)
        row = table[stored(key)]
        for name, value in zip(NAMES, values):
            known, doubt = float(row[name]), float(row[name + "_uncertainty"])
            if not abs(value - known) <= doubt:
                raise ValueError(f"{' '.join(key)}: {name} recomputed {number(value)}, stored {known!r}, uncertainty "
                                 f"{doubt}")
        if not abs(result.imbalance) < 1e-5 * abs(result.work):
            raise ValueError(f"{' '.join(key)}: energy is not balanced: {result.imbalance:.1e} of {result.work:g}")


def show(key):
    values, doubt, result = solve(key)
    for name, value, wrong in zip(NAMES, values, doubt):
        print(f"{name:15s} {number(value):20s} uncertainty {bound(wrong)}")
    if key[9] != "-":
        print(f"loading and dwell: work {result.loading_work:.9g}, dissipated {result.loading_dissipated:.9g}, lost in jumps "
              f"{result.loading_loss:.9g}, imbalance {result.loading_imbalance:.1e}")
    print(f"imbalance of energy {result.imbalance:.1e}, steps {result.steps}, nodes {result.nodes}")
    for time, approach, lost in result.jumps:
        print(f"jump at time {time:.8g}, approach {approach:.8g}, energy lost {lost:.6g}")


def published(path, rows):
    """Rows of comb_1to9.csv and the like beside this solver, on the half-space and on a surface cut at r = R = 100."""
    with open(path, encoding="utf-8") as stream:
        table = list(csv.DictReader(stream))
    for index in map(int, rows):
        row = table[index - 1]
        words = f"gamma:{row['k']};{row['n']}", row["alphaload"], str(-float(row["runload"]))
        theirs = 1.5 * float(row["outputAmplification"])
        for outer in "inf", "100":
            ours = fine((row["mu"], "0", "20", "100", outer, *words, "-", "-", "-"))[0][0]
            print(f"row {index}, tabor {row['mu']}, {' '.join(words)}, outer radius {outer}: force {ours:.7g}, theirs "
                  f"{theirs:.7g}, {100.0 * (theirs / ours - 1.0):+.3f} %", flush=True)


def act(arguments):
    if arguments.list:
        print("\n".join(" ".join(key) for key in SCENES))
    elif arguments.scene:
        show(tuple(arguments.scene))
    elif arguments.published:
        published(arguments.published[0], arguments.published[1:])
    elif arguments.sample:
        sample(STORED)
        print("sample agrees with the stored table")
    else:
        write_all(arguments.write, arguments.resume)


def main():
    parser, group = options(__doc__)
    group.add_argument("--list", action="store_true", help="print the tests of the table")
    group.add_argument("--scene", nargs=len(KEYS), metavar="WORD", help="one test: " + " ".join(KEYS))
    group.add_argument("--published", nargs="+", metavar="WORD", help="FILE ROW...: rows of a published table")
    parser.add_argument("--resume", action="store_true", help="with --write: keep the rows stored there")
    return run(act, parser.parse_args(), NotConverged)


if __name__ == "__main__":
    sys.exit(main())
