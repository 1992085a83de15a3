#!/usr/bin/env python3
"""JKR contact of a wavy sphere with open grooves: the path of loading and unloading, and the pull-off.

    jkr_grooves.py --scene ALPHA BETA PRELOAD   the path of a scene (a minute)
    jkr_grooves.py --write [DIR]                regenerate jkr_grooves.csv and jkr_grooves_path.csv (half an hour)
    jkr_grooves.py --sample                     known limits, every stored state by both routes, one path; exit 1 on disagreement

The limit of a vanishing range of the attraction: a rigid sphere with the waviness of Eq 2 on an elastic half-space, in contact
on a disc and any number of annuli, where every edge of the contact has the energy release rate w. Eq 5 has the outer edge
alone. With radii in lambda and heights in lambda^2/R the scene has the two groups of Guduru (Eqs 5 and 6)

    alpha = A R/lambda^2,   beta = lambda^3 E*/(2 pi w R^2).

Routes: the tractions in the contacts by collocation (groove_tractions.py) and the gap in the grooves by least squares
(groove_gaps.py). groove_paths.py follows the equilibria at given approach.
"""

import sys
from pathlib import Path

import numpy as np
from scipy.optimize import minimize_scalar
from scipy.special import struve

from command_line import STORED, options, run
from groove_gaps import Gaps, abel_of_profile
from groove_paths import APART, Scene, State
from groove_tractions import Contact
from tables import read_table, write_table

SCENES = [(0.5, 1.0, 1.2), (0.5, 1.0, 2.0), (0.3, 2.0, 1.0), (0.8, 1.0, 2.0), (0.5, 4.0, 2.0), (0.5, 4.0, 4.0), (1.0, 0.3, 3.0),
          (1.0, 0.3, 5.0), (1.5, 0.1, 5.0), (1.5, 0.1, 8.0), (0.7, 0.15, 5.0), (4.0, 0.02, 8.0)]
QUICK = SCENES[0]         # recomputed by --sample
FLOOR = 1e-10             # of a stored uncertainty
FACTOR = 3.0              # of the observed differences in a stored uncertainty
AGREE = 1e-8              # of v at a stored state
PATH_COLUMNS = "alpha beta preload index phase kind approach load grooves edges uncertainty edge_uncertainty".split()
PULL_OFF_COLUMNS = ("alpha beta preload grooves force approach contact_radius edges eq5_force "
                    "force_uncertainty approach_uncertainty edge_uncertainty").split()


def events(scene, preload):
    """(phase, kind, State) from first contact to the separation of the bodies."""
    state = scene.first()
    yield "loading", "jump", state
    for kind, state in scene.follow(state, preload):
        yield "loading", kind, state
    for kind, state in scene.follow(state, -1e3):
        yield "unloading", kind, state


def certified(scene, kind, state):
    """The event on the first route with more digits, and the differences to it of approach and load, and of the edges, on
    the second route and of the state given."""
    if state is APART:
        return state, FLOOR, FLOOR
    value = Scene(scene.alpha, scene.beta, 14).exact(kind, state, scene)
    other = Scene(scene.alpha, scene.beta, 11, Gaps).exact(kind, value, scene)

    def far(a, b):
        return np.max(np.abs(np.subtract(a, b)))

    numbers = far((other.approach, other.load), (value.approach, value.load))
    edges = far(other.edges, value.edges)
    if not max(numbers, edges) < 1e-8:
        raise ValueError(f"{scene.alpha} {scene.beta} {kind}: the routes give {value} and {other}")
    # the state given is within the tolerance of the search for an event: only what is stationary there converges further
    still = abs(state.load - value.load) if kind in ("minimum", "maximum") else abs(state.approach - value.approach)
    return value, max(FLOOR, FACTOR * max(numbers, still)), max(FLOOR, FACTOR * edges)


def path_of(alpha, beta, preload, known, note=lambda text: None):
    """(phase, kind, State, uncertainty, edge uncertainty) of every event. `known` has those of other preloads."""
    scene, rows, last = Scene(alpha, beta), [], None
    for phase, kind, state in events(scene, preload):
        if kind == "jump" and state is not APART and last:
            state = State(state.edges, last.approach, state.load)        # from the event to all its digits
        key = (alpha, beta, kind, *(f"{x:.5f}" for x in (state.approach, *state.edges)))
        value, uncertainty, edges = known[key] = known.get(key) or certified(scene, kind, state)
        last = value
        rows.append((phase, kind, value, uncertainty, edges))
        note(f"{alpha:g} {beta:g} {preload:g} {phase} {kind} " + describe(value))
    return rows


def describe(state):
    return "apart" if state is APART else f"approach {state.approach:.10f} load {state.load:.10f} edges {joined(state.edges)}"


def joined(edges):
    return ";".join(f"{x:.12g}" for x in edges) or "-"


def pull_off(rows):
    """The event of the greatest tension in unloading."""
    return min((row for row in rows if row[0] == "unloading" and row[1] in ("minimum", "jump") and row[2] is not APART),
               key=lambda row: row[2].load)


def eq5_force(alpha, beta, preload):
    """The greatest tension of Eq 5 on its own path: a disc that is loaded from a = 0 to the preload and unloaded."""
    k = 1.0 / np.sqrt(np.pi * beta)

    def approach_at(a):
        return abel_of_profile(alpha, a) - k * np.sqrt(np.pi * a)

    def load_at(a):
        x = 2.0 * np.pi * a
        press = 2.0 * a**3 / 3.0 + 0.5 * np.pi * alpha * a * (x * struve(0, x) - struve(1, x))
        return 4.0 * beta * press - 4.0 * np.sqrt(beta * a**3)

    step, end = 1e-3, None
    a = step * np.arange(1, 4001)
    while not end:                                             # up to the contact radius at the preload
        end = next(iter(np.flatnonzero(approach_at(a) >= preload)), None)
        a = a if end else step * np.arange(1, 2 * len(a) + 1)
    approach = approach_at(a[:end + 1])
    later = np.append(np.minimum.accumulate(approach[::-1])[::-1][1:], np.inf)
    reached = np.flatnonzero(approach < later)                 # in unloading
    least = a[reached[np.argmin(load_at(a[reached]))]]
    return -minimize_scalar(load_at, bounds=(least - step, min(least + step, a[end])), method="bounded",
                            options={"xatol": 1e-9}).fun


def tables(note):
    """Rows of both tables."""
    path_rows, pull_off_rows, known = [], [], {}
    for alpha, beta, preload in SCENES:
        rows = path_of(alpha, beta, preload, known, note)
        names = [f"{alpha:g}", f"{beta:g}", f"{preload:g}"]
        approach = 0.0
        for index, (phase, kind, state, uncertainty, edges) in enumerate(rows, 1):
            approach = approach if state is APART else state.approach       # jumps are at given approach
            numbers = [f"{approach:.12g}", "0" if state is APART else f"{state.load:.12g}"]
            path_rows.append([*names, str(index), phase, kind, *numbers, str(state.grooves), joined(state.edges),
                              f"{uncertainty:.1e}", f"{edges:.1e}"])
        _, _, state, uncertainty, edges = pull_off(rows)
        pull_off_rows.append([*names, str(state.grooves), f"{-state.load:.12g}", f"{state.approach:.12g}",
                              f"{state.edges[-1]:.12g}", joined(state.edges), f"{eq5_force(alpha, beta, preload):.10g}",
                              f"{uncertainty:.1e}", f"{uncertainty:.1e}", f"{edges:.1e}"])
    return path_rows, pull_off_rows


def header(what, evidence):
    return {
        "what": what,
        "source": "K. L. Johnson, K. Kendall, A. D. Roberts (1971) with the condition of its edge at every edge of the contact; "
                  "groups alpha and beta of P. R. Guduru, J. Mech. Phys. Solids 55, 445 (2007); derived anew",
        "kind": "oracle",
        "method": "tractions of the contacts by Chebyshev and Legendre series and collocation; events along an arclength from "
                  "seven equilibria about each; shares no code or method with src/",
        "units": "alpha = A R/lambda^2, beta = lambda^3 E*/(2 pi w R^2); radii in lambda, approach in lambda^2/R and > 0 pressed "
                 "together, load in pi w R and > 0 compressive, force = -load; edges: low and high radius of each contact, "
                 "joined by ;",
        "uncertainty": f"column by column: {FACTOR:g} times the differences that evidence names, at least {FLOOR:g}",
        "evidence": evidence,
        "generator": "reference/make/jkr_grooves.py",
        "command": "python3 reference/make/jkr_grooves.py --write",
        "date": "2026-11-26",
    }


def write(folder, note):
    known_limits()
    path_rows, pull_off_rows = tables(note)
    largest = [max(float(row[i]) for row in path_rows) for i in (-2, -1)]
    evidence = ("each state on a second route (the gap in the grooves by least squares), and on the first with fewer nodes; the "
                f"largest uncertainty is {largest[0]:.1e}, of edges {largest[1]:.1e}")
    write_table(folder / "jkr_grooves.csv", header(
        "pull-off of a wavy sphere in the JKR limit with open grooves, after loading and unloading at given approach: the "
        "greatest tension in unloading, grooves that are open then, and the greatest tension of Eq 5 on its own path (a disc)",
        evidence),
        PULL_OFF_COLUMNS, pull_off_rows)
    write_table(folder / "jkr_grooves_path.csv", header(
        "the paths of jkr_grooves.csv: every jump (the state that it reaches), fold of the approach, extremum of the load, touch "
        "of the surfaces outside of the contact, and the preload (end), in order", evidence),
        PATH_COLUMNS, path_rows)


def known_limits():
    """Both routes against limits in closed form; raises an exception if they differ."""
    def agree(what, value, exact, tolerance):
        if not abs(value - exact) <= tolerance:
            raise ValueError(f"{what}: {value:.15g}, not {exact:.15g}")

    for a in (0.4, 1.7, 4.1):                                 # Eq 5
        x, approach, press = 2.0 * np.pi * a, abel_of_profile(0.3, a) - 0.37, 2.0 * a**3 / 3.0
        press += 0.15 * np.pi * a * (x * struve(0, x) - struve(1, x))
        for route in (Contact, Gaps):
            contact = route(0.3, [0.0, a])
            agree(f"{route.__name__}, disc, load", np.pi * contact.load_at(approach), press - 0.37 * a, 1e-11)
            agree(f"{route.__name__}, disc, intensity", contact.intensities(approach)[0], 0.37 / np.sqrt(np.pi * a), 1e-11)
    for inner in (0.02, 0.05, 0.1):                            # flat annular punch, force over that of the disc (Collins 1963)
        series = 1.0 - 4.0 * inner**3 / (3.0 * np.pi**2) - 8.0 * inner**5 / (15.0 * np.pi**2) \
            - 16.0 * inner**6 / (27.0 * np.pi**4)
        for route in (Contact, Gaps):
            agree(f"{route.__name__}, annular punch", np.pi * route(0.0, [inner, 1.0]).load[1], series, 0.2 * inner**7)
    for r in (0.45, 0.8):                                      # a narrow groove: a crack in the tension p of the disc
        for route in (Contact, Gaps):
            half, disc = 1e-3, 1.0
            k = route(0.0, [0.0, r - half, r + half, disc]).intensity[1]
            tension = -np.sqrt(np.pi * half) / (np.pi * np.sqrt(disc**2 - r * r))
            agree(f"{route.__name__}, narrow groove at {r}", 0.5 * (k[0] + k[1]), tension, 4e-5 * abs(tension))
    edges, step = np.array([0.0, 0.3, 0.7, 1.2, 1.6, 1.75]), 1e-4   # the energy release rate: d load/d edge = +-edge K dK/dD
    for route in (Contact, Gaps):
        k = route(0.5, edges, 13).intensity
        for i in range(1, 6):
            moved = [route(0.5, edges + way * step * (np.arange(6) == i), 13).load for way in (1.0, -1.0)]
            exact = (1.0 if i % 2 else -1.0) * edges[i] * np.array([k[0][i - 1] * k[1][i - 1], k[1][i - 1]**2])
            agree(f"{route.__name__}, release rate at edge {i}", (moved[0] - moved[1])[0] / (2.0 * step), exact[0], 1e-6)
            agree(f"{route.__name__}, release rate at edge {i}", (moved[0] - moved[1])[1] / (2.0 * step), exact[1], 1e-6)


def sample():
    known_limits()
    paths, pulls = (read_table(STORED / name)[1] for name in ("jkr_grooves_path.csv", "jkr_grooves.csv"))
    for row in paths + pulls:
        if row["edges"] == "-":
            continue
        edges, approach = [float(x) for x in row["edges"].split(";")], float(row["approach"])
        load = -float(row["force"]) if "force" in row else float(row["load"])
        for route, digits in ((Contact, 14), (Gaps, 11)):
            scene = Scene(row["alpha"], row["beta"], digits, route)
            disc = int(edges[0] == 0.0)
            v, loads = scene.linear(np.array(edges[disc:]), disc)
            worst = max(np.max(np.abs(v[0] + approach * v[1])), abs(loads[0] + approach * loads[1] - load))
            if not worst < AGREE:
                raise ValueError(f"{route.__name__}: {row}: off by {worst:.2g}")
    for row in pulls:
        eq5 = eq5_force(*(float(row[key]) for key in ("alpha", "beta", "preload")))
        if not abs(eq5 - float(row["eq5_force"])) < AGREE * eq5:
            raise ValueError(f"{row}: Eq 5 gives {eq5:.10g}")
    stored = [row for row in paths if tuple(float(row[key]) for key in ("alpha", "beta", "preload")) == QUICK]
    found = list(events(Scene(*QUICK[:2]), QUICK[2]))
    if [row["kind"] for row in stored] != [kind for _, kind, _ in found]:
        raise ValueError(f"{QUICK}: other events than stored")
    for row, (_, kind, state) in zip(stored, found):
        stored_state = State((), *(float(row[key]) for key in ("approach", "load"))) if row["edges"] != "-" else APART
        if not max(abs(stored_state.approach - state.approach), abs(stored_state.load - state.load)) < 1e-7:
            raise ValueError(f"{QUICK}: {row}, recomputed {describe(state)}")
    print(f"{len(paths) + len(pulls)} states agree on both routes; the path of {QUICK} recomputed")


def main():
    parser, group = options(__doc__)
    group.add_argument("--scene", nargs=3, type=float, metavar=("ALPHA", "BETA", "PRELOAD"), help="print the path of a scene")

    def note(text):
        print(text, file=sys.stderr, flush=True)

    def act(arguments):
        if arguments.scene:
            alpha, beta, preload = arguments.scene
            if not (alpha >= 0.0 and 0.0 < beta < np.inf and 0.0 <= preload < np.inf):
                raise ValueError(f"{alpha:g} {beta:g} {preload:g}: expected ALPHA >= 0, BETA > 0, PRELOAD >= 0")
            rows = path_of(alpha, beta, preload, {})
            for phase, kind, state, uncertainty, _ in rows:
                print(f"{phase:9} {kind:8} {describe(state)} +- {uncertainty:.1e}")
            print(f"pull-off {-pull_off(rows)[2].load:.10f}, Eq 5 {eq5_force(alpha, beta, preload):.10f}")
        elif arguments.sample:
            sample()
        else:
            write(Path(arguments.write), note)

    return run(act, parser.parse_args(), failure=ArithmeticError)


if __name__ == "__main__":
    sys.exit(main())
