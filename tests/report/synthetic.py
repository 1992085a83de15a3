"""A run and its reference data of the documented format, made up: for testing the report alone.

The curves are Bradley's law behind a linear spring: they have a minimum of the load, and folds where
the spring is soft, which is all a drawing needs. Nothing here is a solution of the real problem.
"""

import csv
import hashlib
import json
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))

import checksum  # noqa: E402

TABORS = (0.01, 0.015, 0.02, 0.03, 0.05, 0.07, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 1,
          1.25, 1.5, 1.75, 2, 2.5, 3, 3.5, 4, 5)


def bradley(approach):
    x = 1 - approach
    return -2 * (4 * x ** 6 - 1) / (3 * x ** 8)


def spring_branch(tabor, step):
    """(approach, load) along the branch: the gap runs, the spring adds its own deflection."""
    soft = 0.62 * tabor
    rows = []
    count = int(8.42 / step)
    for place in range(count + 1):
        rigid = -8 + 8.42 * place / count
        load = bradley(rigid) * (1 - 0.09 * min(tabor, 2) / 2)
        rows.append((rigid + soft * load, load))
    return rows


def pull_off(tabor):
    approach, load = min(spring_branch(tabor, 0.01), key=lambda row: row[1])
    return -load, approach


def write_reference(folder, name, header, columns, rows, digest=True):
    lines = [",".join(columns)] + [",".join(f"{cell:.12g}" if isinstance(cell, float) else str(cell)
                                            for cell in row) for row in rows]
    data = "\n".join(lines) + "\n"
    head = "".join(f"# {key}: {value}\n" for key, value in header.items())
    seal = f"# sha256: {hashlib.sha256((head + data).encode()).hexdigest()}\n" if digest else ""
    with open(os.path.join(folder, name), "w", encoding="utf-8") as stream:
        stream.write(head + seal + data)


def header(what, kind="oracle"):
    return {"what": what, "source": "made up for testing; Feng (2000), Eqs 10-17", "kind": kind,
            "method": "Bradley's law behind a spring", "units": "lengths in epsilon, load in pi w R",
            "uncertainty": "1e-9", "generator": "reference/make/smooth_sphere.py",
            "command": "python3 reference/make/smooth_sphere.py", "date": "2026-01-02"}


def make_references(folder):
    os.makedirs(folder, exist_ok=True)
    write_reference(folder, "feng_pull_off.csv", header("pull-off of the smooth sphere"),
                    ["tabor", "force", "approach", "force_uncertainty", "approach_uncertainty"],
                    [(tabor, *pull_off(tabor), 1e-9, 3e-9) for tabor in TABORS])
    write_reference(folder, "feng_curves.csv", header("loading curves of the smooth sphere"),
                    ["tabor", "index", "approach", "load", "uncertainty"],
                    [(tabor, place, *row, 1e-9) for tabor in (0.01, 1, 2, 3)
                     for place, row in enumerate(spring_branch(tabor, 0.033))])
    write_reference(folder, "feng_landmarks.csv", header("folds of the smooth sphere"),
                    ["tabor", "index", "kind", "approach", "load"],
                    [(tabor, 0, "jump_in", -1.629 * tabor, -0.5) for tabor in (1, 2, 3)])
    write_reference(folder, "guduru_limit.csv", header("the JKR limit"), ["tabor", "force"],
                    [(tabor, 1.5) for tabor in (10, 20, 40)])
    write_reference(folder, "bradley.csv", header("Bradley's rigid sphere"), ["approach", "load"],
                    [(-8 + 0.05 * place, bradley(-8 + 0.05 * place)) for place in range(169)])


def check(point, quantity, obtained, expected, tolerance, reference, because, **more):
    error = None if obtained is None else obtained - expected
    ratio = None if error is None else abs(error) / tolerance
    verdict = "no_result" if error is None else "within" if ratio <= 1 else "outside"
    made = {"id": f"{quantity}/{reference.split('.')[0]}/{point['label']}", "point": point["id"],
            "quantity": quantity, "obtained": obtained, "expected": expected, "error": error,
            "kind": "abs", "tolerance": tolerance, "reference_uncertainty": 1e-9, "ratio": ratio,
            "ledger": "oracle", "verdict": verdict, "note": "", "because": because,
            "reference": "reference/" + reference, "command": "pulloff verify"}
    made.update(more)
    return made


def point(place, sweep, found, curve=None, status="ok", seconds=0.4):
    force, approach = found
    label = " ".join(f"{key}={value}" for key, value in sweep.items())
    flags = " ".join(f"--{key} {value}" for key, value in sweep.items())
    failed = status != "ok"
    return {"id": str(place), "label": label, "sweep": sweep,
            "input": dict({"radius": 100, "outer_radius": "inf", "scheme": "triangle", "nodes": 501}, **sweep),
            "status": status, "failed": failed, "rigid": False,
            "reason": "the step fell below 1e-8 near approach -1.7" if failed else "",
            "pull_off": None if failed else {"force": force, "approach": approach,
                                             "contact_radius": 8.1, "error_estimate": None},
            "folds": [{"approach": -1.62, "load": -0.8, "kind": "jump_in", "contact_radius": 1.0,
                       "unstable_modes": 1}] if sweep.get("tabor", 0) >= 1 and not failed else [],
            "extrema": [], "curve": curve, "profile": None,
            "work": {"points": 210, "newton_iterations": 640, "factorizations": 655,
                     "kernel_evaluations": 251001, "nodes": sweep.get("nodes", 501),
                     "factorized_nodes": sweep.get("nodes", 501), "seconds": seconds},
            "command": f"pulloff solve {flags} --radius 100 --outer-radius inf"}


def record(name, title, figure, points, checks, suites):
    outside = any(item["verdict"] == "outside" for item in checks)
    failed = any(item["status"] != "ok" for item in points)
    return {"schema": "pulloff-record/1", "case": name, "title": title, "figure": figure,
            "equations": "10-17, 23", "suites": suites, "file": f"cases/{name}.yaml",
            "key": hashlib.sha256(name.encode()).hexdigest(), "figure_script": name,
            "command": f"pulloff run {name}",
            "versions": {"pulloff": "0.1.0", "compiler": "gcc 12.2.0", "gsl": "2.7.1",
                         "openblas": "0.3.21", "lapacke": "3.11.0", "jansson": "2.14",
                         "libyaml": "0.2.5"},
            "environment": {"system": "Linux 6.1.0", "machine": "x86_64",
                            "processor": "a processor", "cores": 2, "jobs": 2,
                            "date": "2026-01-02T10:00:00Z"},
            "plan": ["one surface of 501 nodes for every point: triangle",
                     "no waviness: the sphere is smooth", "no profiles: none is asked for"],
            "points": points, "checks": checks, "seconds": sum(p["work"]["seconds"] for p in points),
            "verdict": "failed" if failed else "outside" if outside else "within"}


def save(run, made, curves=()):
    folder = os.path.join(run, made["case"])
    os.makedirs(folder, exist_ok=True)
    for name, rows in curves:
        with open(os.path.join(folder, name), "w", encoding="utf-8", newline="") as stream:
            writer = csv.writer(stream)
            writer.writerow(["position", "approach", "load", "energy", "contact_radius",
                             "approach_rate", "load_rate", "unstable_modes"])
            writer.writerows((0.02 * place, *row, 0, 0, 0, 0, 0) for place, row in enumerate(rows))
    state_tables(folder, made)
    checksum.write(os.path.join(folder, "record.json"), made)


def state_tables(folder, made):
    """Writes the checksums of all tables into a record."""
    for entry in made["points"] + made.get("lines", []):
        for key in ("curve", "profile", "table"):
            path = os.path.join(folder, entry.get(key) or "")
            if os.path.isfile(path):
                with open(path, "rb") as stream:
                    lines = [line for line in stream if not line.startswith(b"# sha256:")]
                entry[key + "_sha256"] = hashlib.sha256(b"".join(lines)).hexdigest()


def change(path, edit):
    """Edits a record, or a table beside it, and writes the checksums anew."""
    folder = os.path.dirname(path)
    record_path = os.path.join(folder, "record.json")
    with open(record_path, encoding="utf-8") as stream:
        made = json.load(stream)
    if path == record_path:
        edit(made)
    else:
        edit(path)
    state_tables(folder, made)
    checksum.write(record_path, made)


PUBLISHED = "published/feng_fig3.csv"


def make_published(folder):
    """Markers near the curves, as if somebody had digitised a figure."""
    os.makedirs(os.path.join(folder, "published"), exist_ok=True)
    write_reference(folder, PUBLISHED, dict(header("markers of a figure", "published"),
                                            method="digitised by nobody"),
                    ["tabor", "index", "approach", "load", "uncertainty"],
                    [(tabor, place, approach + 0.01, load - 0.01, 0.02) for tabor in (1, 2, 3)
                     for place, (approach, load) in enumerate(spring_branch(tabor, 0.3))])


def make_fig03_left_out(run):
    make_fig03(run, left_out=[{"quantity": "curve", "reference": "reference/" + PUBLISHED,
                               "stand_in": "reference/feng_curves.csv"}])


def make_fig03_published(run):
    make_fig03(run, published=True)


def coarser(name):
    """How much larger the errors of a case by the paper's discretisation are."""
    return 100 if name.endswith("_paper") else 1


def make_fig03_twice(run):
    """With the discretisation of the paper beside it, and a sphere softer than those of the figure."""
    for name in ("fig03", "fig03_paper"):
        make_fig03(run, tabors=(1, 0.01, 5), name=name)


def make_fig03(run, left_out=(), published=False, tabors=(1, 2, 3, 0.01), name="fig03"):
    points, checks, curves = [], [], []
    for place, tabor in enumerate(tabors):
        file = f"curve-{place}.csv"
        found = point(place, {"tabor": tabor}, pull_off(tabor), curve=file)
        points.append(found)
        shift = 3e-6 * (1 + tabor) * coarser(name)
        curves.append((file, [(a + shift, w - shift / 3) for a, w in spring_branch(tabor, 0.02)]))
        distance = check(found, "curve", shift, 0.0, 1e-4, "feng_curves.csv",
                         "second-order elements of 0.2 epsilon: about 3e-5 at mu = 3")
        distance.update(obtained=None, expected=None)
        checks.append(distance)
        if tabor >= 1 and published:
            marker = check(found, "curve", 0.014, 0.0, 0.1, PUBLISHED, "read off a printed figure",
                           ledger="published")
            marker.update(obtained=None, expected=None)
            checks.append(marker)
        if tabor >= 1:
            fold = check(found, "fold_approach", -1.629 * tabor + shift, -1.629 * tabor, 2e-3,
                         "feng_landmarks.csv", "folds are located to 1e-10 on each mesh")
            fold["id"] = f"folds/feng_landmarks/{found['label']}/jump_in-1/approach"
            checks.append(fold)
    made = record(name, "Loading curves of the smooth sphere", "3", points, checks,
                  ["smoke", "paper"])
    save(run, dict(made, figure_script="fig03", left_out=list(left_out)), curves)


def make_fig04_twice(run):
    for name in ("fig04", "fig04_paper"):
        make_fig04(run, name=name)


def make_fig04(run, outside=False, failed=False, name="fig04"):
    points, checks = [], []
    because = "the triangle scheme with 501 nodes has an error of about 2e-5 at mu = 5"
    for place, tabor in enumerate(TABORS):
        force, approach = pull_off(tabor)
        slip = 4e-7 * (1 + tabor ** 2) * (100 if outside and tabor == 5 else 1) * coarser(name)
        status = "step_too_small" if failed and tabor == 2.5 else "ok"
        found = point(place, {"tabor": tabor}, (force + slip, approach - slip), status=status)
        points.append(found)
        if name.endswith("_paper") and tabor == 5:
            found["folds"] *= 12
        got = found["pull_off"] or {"force": None, "approach": None}
        checks.append(check(found, "pull_off_force", got["force"], force, 5e-5,
                            "feng_pull_off.csv", because))
        checks.append(check(found, "pull_off_approach", got["approach"], approach, 2e-4,
                            "feng_pull_off.csv", because))
    made = record(name, "Pull-off of the smooth sphere", "4", points, checks, ["paper"])
    save(run, dict(made, figure_script="fig04"))


MESHES = [(scheme, grading, nodes) for nodes in (63, 125, 251, 501, 1001)
          for scheme in ("ring", "triangle") for grading in ("uniform", "graded")]
ORDERS = {"ring": 1.0, "triangle": 2.0}
SCENES = ({"tabor": 1, "amplitude": 0, "outer_radius": "inf"},
          {"tabor": 3, "amplitude": 1, "wavelength": 20, "outer_radius": 100})


def measured(found, quantity, error, outcome="measured", note=""):
    return {"id": f"{quantity}/made_up/{found['label']}", "point": found["id"], "quantity": quantity,
            "subject": quantity, "obtained": None, "expected": None, "error": error,
            "reference_uncertainty": 1e-10, "outcome": outcome, "note": note,
            "reference": "reference/made_up.csv"}


def measure_all(found, error, misfit):
    """The four errors, each another multiple; with misfit one fold too many."""
    told = [("pull_off_force", error), ("pull_off_approach", -2 * error), ("curve", 5 * error)]
    items = [measured(found, quantity, value) for quantity, value in told]
    if misfit:
        items[-1]["outcome"] = "no_correspondence"
        items.append(measured(found, "fold_count", 1.0, "no_correspondence", "spurious jump_in"))
    else:
        items += [measured(found, "fold_count", 0.0), measured(found, "fold_approach", -2 * error),
                  measured(found, "fold_approach", 3 * error), measured(found, "fold_load", 9 * error)]
    if found["status"] != "ok":
        items = [dict(item, error=None, outcome="no_result") for item in items[:3]]
    return items


def make_precision(run, failed=True):
    """Rings of first order, triangles of second, and panels whose error is their tolerance."""
    points, items = [], []

    def add(scene, mesh, error, seconds, misfit=False, status="ok"):
        found = point(len(points), {**scene, **mesh}, (1.5 + error, -0.9), status=status,
                      seconds=seconds)
        found["seconds_all"] = [2 * seconds, seconds, 0.9 * seconds]
        found["processor_seconds_all"] = [1.1 * seconds, seconds, 0.95 * seconds]
        points.append(found)
        items.extend(measure_all(found, error, misfit))

    for scene in SCENES:
        for scheme, grading, nodes in MESHES:
            status = "step_too_small" if failed and scene["tabor"] == 3 and (
                scheme, grading, nodes) == ("ring", "graded", 63) else "ok"
            add(scene, {"scheme": scheme, "grading": grading, "nodes": nodes},
                scene["tabor"] * 0.4 * (10 / nodes) ** ORDERS[scheme], 2e-7 * nodes ** 2.3,
                misfit=scene["tabor"] == 3 and nodes < 200, status=status)
        for k in range(3, 10):
            add(scene, {"scheme": "panel", "tolerance": 10.0 ** -k}, 10.0 ** -k, 0.004 * k)
    last = points[-1]
    judged = check(last, "pull_off_force", last["pull_off"]["force"], 1.5, 1e-8,
                   "feng_pull_off.csv", "it is made so")
    made = record("precision", "What a digit costs", None, points, [judged], ["precision"])
    made["figure_script"] = None
    made["measured"] = items
    made["not_solved"] = [{"when": [{"key": "nodes", "values": ["2001"]}], "points": 2,
                           "because": "it would take all day"}]
    save(run, made)


WAVY = ({"tabor": 3, "amplitude": 1, "wavelength": 20, "outer_radius": 100},
        {"tabor": 4, "amplitude": 0.4, "wavelength": 10, "outer_radius": 100})


def timed(found, seconds, external):
    """Three rounds; those of an external solver with all that its processes took."""
    found["seconds_all"] = [1.5 * seconds, seconds, seconds] if seconds else [None] * 3
    found["processor_seconds_all"] = [1.1 * seconds, seconds, 0.9 * seconds] if seconds else [None] * 3
    if external:
        whole = [2 * seconds + 0.4] * 3 if seconds else [None] * 3
        found["timing"] = {"first_seconds": found["seconds_all"], "reported_seconds": whole, "process_seconds": whole,
                           "process_processor_seconds": whole, "start_seconds": [0.4] * 3,
                           "start_processor_seconds": [0.3] * 3, "interleaved": True}
    return found


def save_timed(run, points, solver=None):
    """The case solver_times of this program, or of an external solver: relative errors as made, forces of 1."""
    made = record("solver_times", "Error against run time of all solvers", None, points, [check(
        found, "pull_off_force", found["pull_off"] and found["pull_off"]["force"], 1.0, 1e-3, "feng_pull_off.csv",
        "it is made so") for found in points], ["solvers"])
    made["measured"] = [measured(found, "pull_off_force", found["pull_off"]["force"] - 1, "measured")
                        for found in points if found["pull_off"]]
    made["solver"] = solver
    save(run, dict(made, figure_script=None))


def make_solvers(run):
    """Panels whose error is their tolerance, in 10 ms a digit; a solver of second order, which is a hundred times
    slower and has no result for the second scene; and one that is quick and exact."""
    panels = [timed(point(place, {**scene, "scheme": "panel", "tolerance": 10.0 ** -k}, (1 + 10.0 ** -k, -1)), 0.01 * k, False)
              for place, (scene, k) in enumerate((scene, k) for scene in WAVY for k in (3, 5, 7))]
    save_timed(run, panels)

    def external(name, knob, value, error, seconds, fails):
        points = []
        for place, (scene, tolerance) in enumerate((scene, k) for scene in WAVY for k in (1e-3, 1e-5, 1e-7)):
            failed = fails and scene["tabor"] == 4
            found = point(place, {**scene, "scheme": "panel", "tolerance": tolerance}, (1 + error, -1),
                          status="timed_out" if failed else "ok")
            points.append(timed(found, None if failed else seconds, True))
        about = {"name": name, "manifest": "m.yaml", "knob": knob, "knob_value": value, "command": ["x"], "unstable": True,
                 "sha256": "0" * 64, "processes": [],
                 "coverage": {"points": 6, "asked": 6, "checks": 6, "made": 6, "not_reachable": 0}}
        save_timed(os.path.join(run, "solvers", name), points, about)

    external("second@126", "nodes", "126", 2e-4, 5.0, True)
    external("second", "nodes", "251", 5e-5, 40.0, True)
    external("quick", None, None, 1e-9, 1e-3, False)


def fault_cell(*by, caught=True):
    return {"by": list(by), "failing": 2 if by else 0, "seconds": 0.3, "caught": bool(by) and caught}


def make_faults(folder, missed=False):
    """A matrix of planted faults beside a run; missed: one that nobody caught."""
    detectors = [("smoke", "case", "case smoke"), ("tables_math", "table", "tables of the kernel"),
                 ("compare", "test", "test of the comparison")]
    faults = [("kernel-sign", "physics", "the kernel has the wrong sign", "src/core/math/po_kernel.c",
               {"smoke": fault_cell("oracle", "pin"), "tables_math": fault_cell("test")}),
              ("law-slope", "physics", "the law of interaction is too steep", "src/core/scene/po_law.c",
               {"smoke": fault_cell("no_result", "refused"), "tables_math": fault_cell()}),
              ("one-sided", "harness", "only what is too large is outside", "src/harness/po_result.c",
               {"compare": fault_cell("test")})]
    if missed:
        faults.append(("jacobian", "physics", "the Jacobian is off", "src/core/equilibrium/po_equilibrium.c",
                       {"smoke": fault_cell("pin", caught=False), "tables_math": fault_cell()}))
    rows = [{"name": name, "kind": kind, "what": what, "file": file, "cells": cells, "problem": "",
             "caught": any(cell["caught"] for cell in cells.values())} for name, kind, what, file, cells in faults]
    os.makedirs(os.path.join(folder, "mutation"), exist_ok=True)
    with open(os.path.join(folder, "mutation", "matrix.json"), "w", encoding="utf-8") as stream:
        json.dump({"schema": "pulloff-faults/1", "key": "0" * 64, "seconds": 100.0, "passes": not missed,
                   "detectors": [{"name": name, "kind": kind, "title": title, "seconds": 0.3, "passes": True,
                                  "catches": sum(row["cells"].get(name, {}).get("caught", False) for row in rows)}
                                 for name, kind, title in detectors], "faults": rows}, stream)


def diagnostics(tabor):
    state = {"approach": -0.7, "load": -1.5, "nodes": 96, "residual": 3e-13, "rounding": 4e-16,
             "condition": 680.0 * tabor, "bordered_condition": 5e3}
    return {"residual": 3e-13, "rounding": 4e-16, "undiagnosed": 0,
            "states": [dict(state, at="pull_off"), dict(state, at="fold", condition=1e15)],
            "sensitivity": None, "energy_defect": 2.4e-5, "energy_defect_at": -0.3, "seconds": 0.2,
            "reverse_trace": {"status": "ok", "reason": "", "points": 40, "folds": 2, "extrema": 1, "same": tabor < 40,
                         "fold_approach_change": 1e-9, "fold_load_change": 2e-9, "extremum_approach_change": 1e-7,
                         "extremum_load_change": 1e-11, "excess": 0.037},
            "moved": {"solves": 4, "failed": 0, "force_change": 2e-14, "force_excess": 1e-3, "force_change_predicted": 3e-15,
                      "digits_kept": 13.7, "digits_predicted": 14.5, "fold_change": 1e-13}}


def make_extreme(run):
    """Differences from the limits as powers 1.5 and -1.6 of tabor."""
    points, checks = [], []
    for tabor in (1e-4, 1e-3, 1e-2, 10, 20, 40):
        rigid = tabor < 1
        force = 2 - 1.03 * tabor ** 1.5 if rigid else 1.5 + 0.4 * tabor ** -1.6
        found = point(len(points), {"tabor": tabor}, (force, -0.77 * tabor))
        found["diagnostics"] = diagnostics(tabor)
        points.append(found)
        made = check(found, "pull_off_force", force, 2 if rigid else 1.5, 2e-2,
                     "bradley.csv" if rigid else "guduru_limit.csv", "as the rate has it")
        checks.append(dict(made, reference="bradley") if rigid else made)
    save(run, record("extreme_tabor", "From rigid to JKR", None, points, checks, ["extreme"]))


def make_map(run, outside=False):
    """A map of five by six scenes, two of which are traced beside being followed."""
    ratios, tabors = (0.001, 0.01, 0.05, 0.2, 1), (0.1, 0.3, 0.7, 1.4, 2.6, 5)
    points, checks = [], []
    for place, (ratio, tabor) in enumerate((r, t) for r in ratios for t in tabors):
        found = point(place, {"amplitude_ratio": ratio, "tabor": tabor}, (2 - 1.2 * ratio + 0.3 * tabor, -0.7))
        found["pull_off"]["error_estimate"] = 1e-6
        found.update(folds=None, followed=place % 6 not in (0, 5))
        found["input"].update(wavelength=20, outer_radius=100)
        points.append(found)
    for place, error in ((8, 3e-8), (22, 4e-3 if outside else -2e-9)):
        force = points[place]["pull_off"]["force"]
        made = check(points[place], "pull_off_force", force, force - error, 1e-6, "traced", "it is made so")
        checks.append(dict(made, reference="traced"))
    made = record("fig14", "Map of the pull-off force", "14", points, checks, ["paper"])
    os.makedirs(os.path.join(run, "fig14"), exist_ok=True)
    rigid = write_line(run, "fig14", "rigid", ["amplitude_ratio", "pull_off_force"], [(0.001, 2.0), (0.1, 1.3), (1, 0.4)])
    save(run, dict(made, lines=[rigid]))


def step(force, approach):
    """A step of a staircase that holds for all preloads beyond an approach, or half of it as a load."""
    return {"force": force, "preload": {"approach": approach, "load": approach / 2},
            "until": {"approach": 50.0, "load": 25.0}, "open": True}


def make_map_at_any_preload(run):
    """The same map at any preload, with the smooth spheres: the one scene at A/λ = 0.2, μ = 5 takes Δ† = 6 to double."""
    make_map(run)
    points = []
    for place, (ratio, tabor) in enumerate((r, t) for r in (0, 0.001, 0.01, 0.05, 0.2, 1) for t in (0.1, 0.7, 5)):
        found = point(place, {"amplitude_ratio": ratio, "tabor": tabor}, (1.5, -0.7))
        most = 3.5 if (ratio, tabor) == (0.2, 5) else 1.4
        found["input"].update(wavelength=20, outer_radius=100)
        found["pull_off_any"] = {"force": most, "complete": ratio < 1}
        found["staircase"] = {control: {"steps": [step(1.4, -1.0)] + ([step(3.5, 6.0)] if most > 2 else [])}
                              for control in ("displacement_control", "load_control")}
        found["staircase"]["jkr"] = None
        points.append(found)
    save(run, dict(record("fig14_any", "Map at any preload", "14", points, [], ["paper"]), figure_script="fig14"))
    steep = [dict(found, sweep=dict(found["sweep"], amplitude=4)) for found in points if found["pull_off_any"]["force"] > 2]
    save(run, dict(record("preload", "Pull-off against preload", None, steep, [], ["paper"]), figure_script="staircase"))


MIE = {"law": "mie", "mie_m": 4.0, "mie_n": 10.0, "morse_a": None}
CONE = {"profile": "cone", "cone_t": 0.3, "power_c": None, "waves": None}


def of_law(place, tabor, found, **more):
    """A scene of the Mie law, with two folds."""
    made = point(place, {"law": "mie", "tabor": tabor}, found, **more)
    made["input"].update(MIE)
    made["folds"] = [{"approach": approach, "load": -0.5, "kind": kind, "contact_radius": 1.0, "unstable_modes": 1}
                     for approach, kind in ((-1.62, "jump_in"), (-1.9, "jump_out"))]
    return made


def write_line(run, case, name, columns, rows):
    write_reference(os.path.join(run, case), f"line-{name}.csv", {"what": name}, columns, rows)
    return {"name": name, "theory": name, "table": f"line-{name}.csv"}


def make_general(run):
    """Four cases of the suite general: a law, its curve, a profile, and a staircase that was not traced to its end."""
    def keep(name, points, checks, script, lines=(), curves=()):
        made = dict(record(name, f"The case {name}", None, points, checks, ["general"]), figure_script=script)
        os.makedirs(os.path.join(run, name), exist_ok=True)
        save(run, dict(made, lines=[write_line(run, name, *line) for line in lines]), curves)

    forces = [(tabor, 2 - tabor ** 1.5 if tabor < 1 else 1.5 + 0.2 / tabor ** 2) for tabor in (0.01, 0.1, 1.0, 10.0)]
    points = [of_law(place, tabor, (force, -0.7)) for place, (tabor, force) in enumerate(forces)]
    judged = check(points[1], "pull_off_force", forces[1][1], forces[1][1], 1e-8, "general_pull_off.csv", "it is made so")
    keep("general_laws", points, [judged], "laws", lines=[("maugis", ["tabor", "pull_off_force"], [
        (tabor, 2 - 2 * tabor ** 1.5) for tabor in (0.01, 0.1)])])
    keep("general_curves", [of_law(0, 1.0, (1.7, -0.7), curve="curve-0.csv")], [], "law_curves",
         lines=[("jkr", ["tabor", "contact_radius", "approach", "load"], [(1, 1, -0.5, -0.4), (1, 2, -0.7, -1.5)])],
         curves=[("curve-0.csv", spring_branch(1, 0.1))])
    coupled = [point(place, {"coupling": coupling}, (force, 1.0)) for place, (coupling, force) in enumerate(((0.1, 30.0), (1, 250.0)))]
    for one in coupled:
        one["input"].update(CONE)
    keep("general_profiles", coupled, [], "profiles")
    wavy = point(0, {"coupling": 0.5}, (1.4, 1.0))
    wavy["input"].update(CONE, waves="1@12")
    wavy["pull_off_any"] = {"force": 1.4, "complete": False}
    wavy["staircase"] = {control: {"steps": [step(1.4, -1.0)]} for control in ("displacement_control", "load_control")}
    wavy["staircase"]["jkr"] = None
    keep("general_stairs", [wavy], [], "general_stairs")
    write_reference(os.path.join(os.path.dirname(run), "reference"), "jkr_pull_off.csv", header("JKR pull-off"),
                    ["profile", "waves", "coupling", "radius", "contact_radius", "approach", "force"],
                    [("cone:0.3", "-", 0.1, "-", 6.37, 1.0, 20.0), ("cone:0.3", "-", 1, "-", 63.7, 10.0, 200.0)])


def cost_document(compressed, dense, waves):
    """A document whose times are powers of the nodes: of compressed and of dense equilibria; and of the waves: of solves."""
    nodes = [250 * 2 ** k for k in range(6)]

    def way(n, power):
        part = {"seconds": 1e-9 * n ** power, "flops": 10.0 * n ** power, "bytes": 5.0 * n ** power}
        return {"seconds": 1e-8 * n ** power, "newton_iterations": 4, "active": n, "product": part, "factors": part, "solve": part}

    trace = {"seconds": 1.0, "points": 100, "newton_iterations": 400, "factorizations": 50, "nodes": 300, "factorized_nodes": 301}
    return {"schema": "pulloff-cost/1", "scene": {"tabor": 3.0, "amplitude": 1.0, "wavelength": 20.0},
            "machine": {"flops_double": 5e10, "flops_single": 1e11, "bytes": 1e10, "library": "made up"},
            "meshes": [{"radius": float(n), "nodes": n, "hierarchical": way(n, compressed), "dense": way(n, dense) if n < 5000 else None,
                        "trace": {**trace, "seconds": 1e-6 * n}} for n in nodes],
            "waves": [{"radius": 100.0 * 4 ** k, "waves": 2.0 ** k, "trace": {**trace, "seconds": 0.1 * 2.0 ** (k * waves)}}
                      for k in range(5)]}


def make_cost(folder):
    """The cost of equilibria beside a run."""
    os.makedirs(os.path.join(folder, "cost"), exist_ok=True)
    with open(os.path.join(folder, "cost", "cost.json"), "w", encoding="utf-8") as stream:
        json.dump(cost_document(1.25, 2.75, 1.5), stream)


def make_run(folder, **how):
    """All four cases; how: outside=True, failed=True."""
    make_fig03(folder)
    make_fig04(folder, **how)
    make_extreme(folder)
    make_precision(folder, failed=how.get("failed", False))


if __name__ == "__main__":
    import argparse
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", help="run/ and reference/ are made in it")
    parser.add_argument("--outside", action="store_true", help="one check outside its tolerance")
    parser.add_argument("--failed", action="store_true", help="some failed solves")
    wanted = parser.parse_args()
    make_references(os.path.join(wanted.folder, "reference"))
    make_run(os.path.join(wanted.folder, "run"), outside=wanted.outside, failed=wanted.failed)
    make_faults(wanted.folder, missed=wanted.outside)
    make_cost(wanted.folder)
