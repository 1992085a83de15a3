#!/usr/bin/env python3
"""Pull-off and special points of any traction-separation law and any axisymmetric profile.

The equations of smooth_sphere.py with the laws of laws.py and the profiles of profiles.py. The elastic number is
c = w/(E* epsilon): H(r) + D - f(r) - c int G(r, s) p(H(s)) s ds = 0, lengths in epsilon, tractions in w/epsilon.

    general.py --list                       the scenes of the tables
    general.py --scene mie:4,10 cone:0.3 - 1 - inf          special points of any scene
    general.py --scene morse:1 sphere 0.4@10;0.1@3 0.1 60 30    (law profile waves coupling radius outer)
    general.py --self-test                  the solver against exact results
    general.py --sample                     recompute a sample, compare with the stored tables
    general.py --write [DIR] [--resume]     regenerate the tables; --resume keeps the rows stored in DIR
"""

import sys

import numpy as np

import general_test
from branch import NotConverged
from command_line import STORED, notes, options, run
from converged import BOUND_IN_WORDS, SAFETY
from general_scene import NO_TENSION, POLISH, Scene, solve, sphere
from landmarks import landmark_kinds, pull_off
from tables import bound, number, read_table, write_table

DATE = "2026-11-22"
PULL_OFF, SPECIAL = "general_pull_off.csv", "general_special_points.csv"
KEYS = "law profile waves coupling radius outer_radius".split()

# Each profile with its stiff coupling; SOFT is the other one.
PROFILES = {"cone:0.3": "0.5", "power:0.05;1.5": "0.5", "power:0.001;4": "2", "punch:5;20": "1", "truncated:5;20": "1"}
SOFT, CUT = "0.05", "12"
WAVES = "0.4@12;0.1@5"
SAMPLE = [("morse:1", "sphere", "-", "0.1", "100", "inf"), ("mie:4;10", "sphere", "-", "0.00316227766016838", "100", "inf"),
          ("mie:4;10", "cone:0.3", "-", "0.05", "-", "inf")]


def scenes():
    """In the order in which they are solved: what matters most first."""
    main, other = ("mie:4;10", "morse:1"), ("mie:3;9", "morse:3")

    def ladder(laws, tabors):
        return [sphere(law, tabor) for tabor in tabors.split() for law in laws]

    def profiles(laws, outer, stiff):
        return [Scene(law, profile, "-", PROFILES[profile] if stiff else SOFT, "-", outer)
                for profile in PROFILES for law in laws]

    def wavy(laws, outer, coupling):
        return [Scene(law, "sphere", WAVES, coupling, "50", outer, 6.0) for law in laws]

    out = ladder(main, "0.1 1")
    for laws in main, other:
        out += [*profiles(laws, "inf", False), *wavy(laws, "40", "0.05"), *ladder(laws, "3"),
                *profiles(laws, CUT, False), *profiles(laws, "inf", True), *wavy(laws, "40", "0.5"),
                *profiles(laws, CUT, True), *ladder(laws, "0.01 0.3 10")]
        out += ladder(other, "0.1 1") if laws == main else []
    return out + wavy(("morse:1", "morse:3"), "inf", "0.05") + ladder(main + other, "30 50")


def values(row, scene, solved):
    """Load, approach, contact radius in the units of the tables, and the same of their spread."""
    factor = solved.load / scene.unit, 1.0, solved.width
    return (np.array([row.load, row.approach, row.contact_radius]) * factor,
            np.array([row.spread[1], row.spread[0], row.spread[2]]) * factor)


def cells(row, scene, solved, sign=1.0):
    value, spread = values(row, scene, solved)
    return [number(sign * value[0]), *map(number, value[1:]), *(bound(SAFETY * s) for s in spread)]


PULL_OFF_COLUMNS = KEYS + ("tabor complete_to force approach contact_radius "
                           "force_uncertainty approach_uncertainty contact_radius_uncertainty").split()
SPECIAL_COLUMNS = KEYS + ("tabor complete_to index kind load approach contact_radius load_uncertainty "
                          "approach_uncertainty contact_radius_uncertainty").split()


def rows_of(scene, solved):
    """The row of the table of pull-off and those of the table of special points."""
    end = number(solved.complete_to)
    best = [*scene.key, scene.tabor, end, *cells(pull_off(solved.rows), scene, solved, -1.0)]
    return best, [[*scene.key, scene.tabor, end, str(i + 1), row.kind, *cells(row, scene, solved)]
                  for i, row in enumerate(solved.rows)]


def header(what, columns, rows):
    def largest(name):
        return max(float(row[columns.index(name)]) for row in rows)

    levels = "; ".join(f"level {i + 1}: {l.order} nodes a panel, {l.tail} in the mapped panel, traction resolved to "
                       f"{l.tolerance:g}, {l.kink} halvings towards a kink, edges moved or mapped panel put off by a "
                       f"factor {l.cut:g}, {l.extra} extra quadrature points" for i, l in enumerate(POLISH))
    doubts = ", ".join(f"{name} {largest(name):.1e}" for name in columns if name.endswith("_uncertainty"))
    return {
        "what": what,
        "source": "the equations of A. Papangelo, M. Ciavarella, Lubricants 8(9), 90 (2020), "
                  "doi 10.3390/lubricants8090090, Eqs 10-17, with the law and the profile of the row, solved anew",
        "kind": "oracle",
        "method": "Copson (double Abel) form of the elastic operator on adaptive spectral panels, graded to kinks of "
                  "the profile; to the cut, with a mapped panel to infinity (Mie), or to where the tension is below "
                  f"{NO_TENSION:g} w/epsilon (Morse, unbounded); Newton; arclength in (approach, load, central gap); "
                  "shares no code or method with src/",
        "laws": "mie:m;n: p = -k (x^m - x^n), x = 1/(1 + H), k = (m - 1)(n - 1)/(n - m), H = gap/epsilon - 1; "
               "morse:a: p = -2a (e^(-aH) - e^(-2aH)), H = (gap - equilibrium gap)/epsilon; p in w/epsilon",
        "profiles": "sphere: r^2/(2R), R = radius; cone:t: t r; power:C;n: C r^n; punch:b;R: 0 up to b, "
                   "(r - b)^2/(2R) beyond; truncated:b;R: 0 up to b, (r^2 - b^2)/(2R) beyond; waves A@L;...: each adds "
                   "A (1 - cos(2 pi r/L)); -: none",
        "units": "lengths in epsilon, approach > 0 pressed together; load > 0 compressive, in units of pi w R where "
                 "radius is that of a sphere, and of pi w epsilon where radius is -; force = -load; "
                 "coupling = w/(E* epsilon); tabor = (R w^2/(E*^2 epsilon^3))^(1/3) where the row was made by it; "
                 "outer_radius: the cut (inf: unbounded); contact_radius: the outermost radius where the gap is that "
                 "of the greatest tension, 0 when there is none",
        "uncertainty": BOUND_IN_WORDS,
        "convergence": f"every value solved on three levels ({levels}); largest uncertainties: {doubts}; the same "
                       "special points were found on two traces of different mesh and step",
        "generator": "reference/make/general.py",
        "command": "python3 reference/make/general.py --write",
        "date": DATE,
    }


def write_tables(folder, done):
    """done: key -> (row of pull-off, rows of special points)."""
    order = [scene.key for scene in scenes() if scene.key in done]
    best = [done[key][0] for key in order]
    special = [row for key in order for row in done[key][1]]
    write_table(folder / PULL_OFF, header(
        "pull-off (deepest minimum of the load along the branch, stable or not) until the approach first exceeds "
        "complete_to; any law, any profile", PULL_OFF_COLUMNS, best), PULL_OFF_COLUMNS, best)
    write_table(folder / SPECIAL, header(
        "folds in approach and extrema of load along the branch, in order, from far out until the approach first "
        "exceeds complete_to; any law, any profile. jump_in: local maximum of approach, jump_out: local minimum of "
        "approach, minimum and maximum: of the load along the branch", SPECIAL_COLUMNS, special),
        SPECIAL_COLUMNS, special)


def stored_rows(folder):
    """What the tables of a folder hold, as write_tables takes it."""
    if not (folder / PULL_OFF).exists():
        return {}
    done = {tuple(row[k] for k in KEYS): (list(row.values()), []) for row in read_table(folder / PULL_OFF)[1]}
    for row in read_table(folder / SPECIAL)[1]:
        done[tuple(row[k] for k in KEYS)][1].append(list(row.values()))
    return done


def write_all(folder, resume):
    """The tables are written after each scene: an interrupted run can be resumed."""
    folder.mkdir(parents=True, exist_ok=True)
    note, done = notes(), stored_rows(folder) if resume else {}
    for scene in scenes():
        if scene.key in done:
            continue
        try:
            solved = solve(scene)
        except NotConverged as problem:
            note(f"{' '.join(scene.key)}: not tabulated: {problem}")
            continue
        done[scene.key] = rows_of(scene, solved)
        write_tables(folder, done)
        note(f"{' '.join(scene.key)}: " + " ".join(landmark_kinds(solved.rows)) + "; pull-off, approach, contact "
             "radius, uncertainties: " + " ".join(done[scene.key][0][len(KEYS) + 2:]))


def sample(folder):
    """Recompute the sample on one level, without the second trace, and compare with the stored tables."""
    stored = stored_rows(folder)
    for scene in scenes():
        if scene.key in SAMPLE:
            compare(scene, rows_of(scene, solve(scene, POLISH[1:2], check=False)), stored[scene.key])


def compare(scene, new, old):
    """Raise unless two results of a scene agree within the stored uncertainties."""
    new, old = [new[0], *new[1]], [old[0], *old[1]]
    if len(new) != len(old):
        raise ValueError(f"{' '.join(scene.key)}: {len(new) - 1} special points, stored {len(old) - 1}")
    for place, (one, other) in enumerate(zip(new, old)):
        columns = SPECIAL_COLUMNS if place else PULL_OFF_COLUMNS
        doubt = dict(zip(columns, other))
        for name, value, known in zip(columns, one, other):
            limit = doubt.get(name + "_uncertainty")
            if name.endswith("_uncertainty") or value == known:
                continue
            if limit is None or not abs(float(value) - float(known)) <= float(limit):
                raise ValueError(f"{' '.join(scene.key)}: {name} recomputed {value}, stored {known}")


def show(words, check):
    scene = Scene(*words)
    if scene.waves != "-":
        scene = Scene(*words, 6.0)
    solved = solve(scene, check=check)
    for row in solved.rows:
        value, spread = values(row, scene, solved)
        print(f"{row.kind:9s} load {value[0]: .13g} approach {value[1]: .13g} contact radius {value[2]:.12g} "
              f"differences {spread[0]:.1e} {spread[1]:.1e} {spread[2]:.1e}")
    print(f"complete to approach {solved.complete_to:g}")


def act(arguments):
    if arguments.list:
        print("\n".join(" ".join(scene.key) for scene in scenes()))
    elif arguments.scene:
        show(arguments.scene, False)
    elif arguments.self_test:
        general_test.run()
    elif arguments.sample:
        sample(STORED)
        print("sample agrees with the stored tables")
    else:
        write_all(arguments.write, arguments.resume)


def main():
    parser, group = options(__doc__)
    group.add_argument("--list", action="store_true", help="print the scenes of the tables")
    group.add_argument("--self-test", action="store_true", help="test against exact results")
    group.add_argument("--scene", metavar="WORD", nargs=6,
                       help="print the special points of a scene: law profile waves coupling radius outer_radius")
    parser.add_argument("--resume", action="store_true", help="with --write: keep the rows stored there")
    return run(act, parser.parse_args(), NotConverged)


if __name__ == "__main__":
    sys.exit(main())
