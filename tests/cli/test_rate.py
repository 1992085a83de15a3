"""Viscoelastic bodies: the fast limit by an elastic solve, tables, SI units, cases, refusals."""

import csv
import io
import json
import math
import pathlib
import re

import pytest
from conftest import document, expect, run

SOLID = "--viscoelastic sls:0.1 --unload-speed"


def table_of(path):
    lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    return list(csv.DictReader(io.StringIO("\n".join(lines))))


def energies(point):
    return sum(point["energies"][name] for name in ("stored", "adhesive", "spring"))


@pytest.mark.parametrize("scene, preload", [("--tabor 0.3", 2.0), ("--tabor 3 --amplitude 1 --wavelength 20", 10.0)])
def test_the_fast_limit_is_an_elastic_scene(scene, preload, tmp_path):
    """The gap f' = k f + (1 - k)(H0 + D0) as a table, and the coupling k kappa; both surfaces are cut at one radius."""
    k, outer = 0.1, 60.0
    cut = f"{scene} --outer-radius {outer}"
    relaxed = document(f"solve {cut} --preload {preload} --profile-approach {preload} --tolerance 1e-8")
    amplitude, length = relaxed["input"]["amplitude"], relaxed["input"]["wavelength"]
    rows = [(0.0, None)]
    for point in relaxed["profile"]:
        r = point["radius"]
        wave = amplitude * (1.0 - math.cos(2.0 * math.pi * r / length)) if amplitude else 0.0
        rows.append((r, k * (r * r / 200.0 + wave) + (1.0 - k) * (point["gap"] + preload)))
    # the gap is even in r: the parabola through the first two rows gives that on the axis
    (r1, f1), (r2, f2) = rows[1:3]
    rows[0] = (0.0, (f1 * r2**2 - f2 * r1**2) / (r2**2 - r1**2))
    end = 2.0 * rows[-1][1] - rows[-2][1]
    rows.append((2.0 * rows[-1][0] - rows[-2][0], end))
    table = tmp_path / "gap.csv"
    table.write_text("r,gap\n" + "".join(f"{r!r},{f!r}\n" for r, f in rows))
    coupling = k * relaxed["input"]["tabor"]**1.5 / 10.0
    elastic = run(f"solve --profile-file {table} --coupling {coupling!r} --radius 100 --outer-radius {outer} "
                  f"--preload {preload - rows[0][1]!r} --json").json
    fast = document(f"solve {cut} --preload {preload} --viscoelastic sls:{k} --unload-speed inf")
    # the approach of a table is that of its axis; loading of that scene may pass other minima than unloading
    nearest = min(elastic["extrema"], key=lambda point: abs(point["approach"] + rows[0][1] - fast["pull_off"]["approach"]))
    assert nearest["kind"] == "minimum"
    assert math.isclose(fast["pull_off"]["force"], -nearest["load"], rel_tol=2e-6)
    assert math.isclose(fast["pull_off"]["approach"], nearest["approach"] + rows[0][1], abs_tol=1e-3)
    assert fast["unloading"]["end"]["energies"]["dissipated"] == pytest.approx(0.0, abs=1e-9)
    # and it is what no finite speed exceeds
    finite = document(f"solve {cut} --preload {preload} --viscoelastic gamma:{k},0.6 --unload-speed 100")
    assert finite["pull_off"]["force"] < fast["pull_off"]["force"]


def test_the_history_is_a_table(tmp_path):
    path = tmp_path / "history.csv"
    words = f"solve --tabor 0.5 --preload 3 {SOLID} 2 --stiffness 1"
    found = document(f"{words} --want history")
    expect(0, "", f"{words} --history {path}")
    rows = table_of(path)
    points = found["unloading"]["history"]
    assert len(rows) == len(points) == found["unloading"]["steps"]
    for row, point in zip(rows, points):
        assert float(row["load"]) == point["load"]
        assert float(row["work"]) == point["energies"]["work"]
        assert math.isclose(point["base"], point["approach"] + point["load"], abs_tol=1e-7)
        assert math.isclose(point["time"], point["moved"] / 2.0, rel_tol=1e-14)
        lost = point["energies"]["dissipated"] + point["energies"]["jumps"]
        assert math.isclose(point["energies"]["work"], energies(point) - energies(points[0]) + lost, abs_tol=1e-3)
    force = found["pull_off"]["force"]
    greatest = max(-point["load"] for point in points)
    assert greatest <= force + found["pull_off"]["error_estimate"]
    assert math.isclose(greatest, force, rel_tol=1e-3)


def test_the_history_is_plotted(tmp_path):
    scene = f"--tabor 0.5 --preload 3 {SOLID} 2 --tolerance 1e-4"
    printed = expect(0, "", f"plot {scene}").out
    assert "load in pi w R against approach" in printed and "energy in pi w R epsilon against approach in epsilon" in printed
    assert re.search(r"work \*+ *dissipated #+ *stored \$+", printed)
    spring = expect(0, "", f"plot {scene} --stiffness 1 --want history").out
    assert "energy in pi w R epsilon against position of the base" in spring
    expect(0, "", f"solve {scene} --plot {tmp_path / 'figure.svg'}")
    assert all(f">{word}<" in (tmp_path / "figure.svg").read_text() for word in ("unloading", "work", "dissipated", "stored"))
    expect(2, "*a result other than history, profile and theories is wanted beside viscoelastic*", f"plot {scene} --want curve")
    expect(2, "*history is wanted: expected it beside viscoelastic", "plot --tabor 1 --want history")
    expect(2, "pulloff: --history has no effect on plot: expected it to be left out", f"plot {scene} --history {tmp_path / 'history.csv'}")


def test_the_profile_is_that_of_a_state_of_unloading(tmp_path):
    table = tmp_path / "profile.csv"
    scene = f"--tabor 1 --preload 5 {SOLID} 1 --tolerance 1e-4 --profile-csv {table}"
    solved = expect(0, "", f"solve {scene} --profile-load -2").out
    assert "radii at approach 1.22" in solved and "radius,gap,traction" in table.read_text()
    table.unlink()
    expect(2, "*profile.csv is not written: unloading does not pass the approach or load of the profile", f"solve {scene} --profile-load -5")
    assert not table.exists()


def test_si_units_are_converted():
    scene = "--from-physical --modulus-pa 1e9 --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 3e-8"
    si = document(f"solve {scene} --preload-m 6e-10 --viscoelastic sls:0.2 --relaxation-time-s 1e-3 --unload-speed-m-per-s 6e-7")
    assert si["input"]["unload_speed"] == pytest.approx(2.0, rel=1e-14)
    plain = document(f"solve --tabor {si['input']['tabor']!r} --radius 100 --preload 2 --viscoelastic sls:0.2 --unload-speed 2")
    assert plain["pull_off"]["force"] == pytest.approx(si["pull_off"]["force"], rel=1e-6)
    unit = math.pi * 0.05 * 3e-8
    assert si["physical"]["pull_off"]["force_n"] == pytest.approx(unit * si["pull_off"]["force"], rel=1e-12)
    work = si["unloading"]["end"]["energies"]["work"]
    assert si["physical"]["unloading"]["end"]["energies"]["work_j"] == pytest.approx(unit * 3e-10 * work, rel=1e-12)


LOADED = "solve --tabor 0.5 --preload 3 --viscoelastic sls:0.1 --unload-speed 2 --load-speed 4 --dwell 0.5 --tolerance 1e-4"


def test_loading_and_dwell_come_before_unloading(tmp_path):
    path = tmp_path / "history.csv"
    found = document(f"{LOADED} --want history --history {path}")
    assert found["input"]["load_speed"] == 4.0 and found["input"]["dwell"] == 0.5
    loading, rows = found["unloading"]["loading"], table_of(path)
    times = [float(row["time"]) for row in rows]
    assert times == sorted(times) and times[0] == loading["start"]["time"] == pytest.approx(-0.5 - 13.0 / 4.0, rel=1e-9)
    dwell = [row for row, time in zip(rows, times) if -0.5 <= time <= 0.0]
    assert all(float(row["approach"]) == pytest.approx(3.0, abs=1e-8) for row in dwell)
    assert float(dwell[0]["load"]) > float(dwell[-1]["load"]) == found["unloading"]["begin"]["load"]
    assert len(rows) == found["unloading"]["steps"]
    printed = expect(0, "", LOADED).out
    assert "loaded   at speed 4 epsilon/tau_0 from approach -10, with 0 jumps of the contact; then held for 0.5 tau_0" in printed
    slow = expect(0, "", LOADED.replace("--unload-speed 2", "--unload-speed 0")).out
    assert "then held for infinitely many tau_0" in slow  # slow unloading starts at the relaxed contact, whatever the dwell
    assert "loading" not in document("solve --tabor 0.5 --preload 3 --viscoelastic sls:0.1 --unload-speed 2 --tolerance 1e-4")["unloading"]


@pytest.mark.once
def test_theories_of_a_body_that_is_not_relaxed_are_undecided():
    scene = "solve --tabor 6 --preload 3 --viscoelastic sls:0.5 --unload-speed 0.05 --tolerance 1e-3 --want theories"
    for words, expected in ("", "yes"), ("--load-speed 1 --dwell 1", "unknown"):
        rows = document(f"{scene} {words}")["theories"]
        assert next(row["assumptions"] for row in rows if row["theory"] == "persson-brener") == expected


def test_speed_of_loading_and_dwell_have_si_units():
    scene = "--from-physical --modulus-pa 1e9 --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 3e-8 --preload-m 6e-10 --viscoelastic sls:0.2"
    times = "--relaxation-time-s 1e-3 --unload-speed-m-per-s 6e-7 --load-speed-m-per-s 3e-7 --dwell-s 2e-3"
    si = document(f"solve {scene} {times} --tolerance 1e-4")
    assert si["input"]["load_speed"] == pytest.approx(1.0, rel=1e-14) and si["input"]["dwell"] == pytest.approx(2.0, rel=1e-14)
    expect(2, "*--dwell is 2: expected --dwell-s, as the scene is in SI units", f"solve {scene} {times.replace('--dwell-s 2e-3', '--dwell 2')}")


@pytest.mark.parametrize("words, message", [
    ("--load-speed 1", "*--load-speed is 1: expected it beside viscoelastic"),
    ("--dwell 1", "*--dwell is 1: expected it beside viscoelastic"),
    (f"{SOLID} 1 --load-speed -1", "*--load-speed is -1: expected *"),
    (f"{SOLID} 1 --dwell nan", "*--dwell is nan: expected *"),
])
def test_loading_is_refused(words, message):
    expect(2, message, f"solve --tabor 1 {words}")


def test_the_preload_may_be_a_load():
    by_load = document(f"solve --tabor 1 --preload-load 2 {SOLID} 1")
    begin = by_load["unloading"]["begin"]
    assert begin["load"] == pytest.approx(2.0, abs=1e-8)
    by_approach = document(f"solve --tabor 1 --preload {begin['approach']!r} {SOLID} 1")
    assert by_approach["pull_off"]["force"] == pytest.approx(by_load["pull_off"]["force"], rel=1e-6)


def test_many_times_cost_no_newton_iterations():
    """Steps with a spectrum of some fifty terms take as many Newton iterations as with one."""
    per_step = []
    for material in ("sls:0.1", "gamma:0.1,1"):
        found = document(f"solve --tabor 1 --preload 4 --viscoelastic {material} --unload-speed 1e3")
        per_step.append(found["work"]["newton_iterations"] / found["unloading"]["steps"])
    assert found["unloading"]["terms"] > 40
    assert per_step[1] < 1.1 * per_step[0]


def test_a_case_has_speeds(tmp_path):
    elastic = document("solve --tabor 1 --preload 3")["pull_off"]["force"]
    fast = document("solve --tabor 1 --preload 3 --viscoelastic sls:0.2 --unload-speed inf")["pull_off"]["force"]
    table = tmp_path / "forces.csv"
    table.write_text(f"viscoelastic,unload_speed,force\nsls:0.2,0,{elastic!r}\nsls:0.2,inf,{fast!r}\n")
    expect(0, "", f"seal {table} --what forces --units 'epsilon, pi w R' --source solves --kind oracle --method 'elastic solves' --uncertainty 1e-6")
    case = tmp_path / "rate.yaml"
    case.write_text("""name: rate
title: Pull-off against speed
suites: [own]
want: [pull_off]
scene: {tabor: 1, radius: 100, outer_radius: .inf, scheme: panel, preload: 3, viscoelastic: 'sls:0.2'}
sweep:
  - {key: unload_speed, values: [0, .inf]}
checks:
  - {quantity: pull_off_force, reference: forces.csv, tolerance: 1e-5, kind: abs, because: both limits are elastic}
""")
    expect(0, "*", f"run {case} --output {tmp_path / 'out'} --summary {tmp_path / 'summary.csv'}")
    ended = run(f"verify {case} --output {tmp_path / 'out'}")
    assert ended.code == 0, ended.err + ended.out
    plan = run(f"plan {case}").out
    assert "solve 2 viscoelastic scenes: each loaded slowly to the preload" in plan
    assert "no steps in time for 2 of these" in plan and "find on each branch" not in plan and "end each branch" not in plan
    for speed, row in zip(("0", "inf"), table_of(tmp_path / "summary.csv")):
        found = document(f"solve --tabor 1 --preload 3 --viscoelastic sls:0.2 --unload-speed {speed}")["unloading"]
        for name, energy in (("unloading_work", "work"), ("dissipated", "dissipated"), ("lost_in_jumps", "jumps")):
            assert float(row[name]) == found["end"]["energies"][energy]
            assert float(row[f"{name}_error"]) == found["error_estimate"][energy]


def test_a_series_of_speeds_is_what_solves_give(tmp_path):
    words, path = "--tabor 1 --preload 3 --viscoelastic sls:0.1", tmp_path / "speeds.csv"
    expect(0, "", f"follow --key unload-speed --from 1e-4 --to 1e4 --points 3 {words} --curve {path}")
    rows = table_of(path)
    assert [float(row["unload_speed"]) for row in rows] == pytest.approx([1e-4, 1.0, 1e4])
    for row in rows:
        found = document(f"solve {words} --unload-speed {row['unload_speed']}")
        unloading = found["unloading"]
        assert float(row["force"]) == found["pull_off"]["force"] and float(row["time"]) == unloading["time"]
        assert float(row["dissipated"]) == unloading["end"]["energies"]["dissipated"]
        assert float(row["lost_in_jumps_error"]) == unloading["error_estimate"]["jumps"]
    expect(2, "*folds are not followed from scene 1 to the next: *no viscoelastic body",
           f"follow --key unload-speed --from 1 --to 2 --points 2 --of folds {words}")


def test_a_series_of_speeds_in_si_units():
    scene = "--from-physical --modulus-pa 1e9 --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 3e-8 --preload-m 6e-10"
    ends = document(f"follow --key unload-speed-m-per-s --from 3e-9 --to 3e-5 --points 2 {scene} --viscoelastic sls:0.2 "
                    "--relaxation-time-s 1e-3")["points"]
    assert [point["input"]["unload_speed"] for point in ends] == pytest.approx([0.01, 100.0], rel=1e-12)
    assert ends[1]["pull_off"]["force"] > 2.0 * ends[0]["pull_off"]["force"]


def test_a_table_has_elastic_and_viscoelastic_bodies(tmp_path):
    """The record of a body without a speed has null for it."""
    (tmp_path / "bodies.csv").write_text("tabor,viscoelastic,unload_speed\n1,-,-\n1,sls:0.5,1\n")
    case = tmp_path / "mixed.yaml"
    case.write_text("""name: mixed
title: Elastic and viscoelastic bodies
suites: [own]
want: [pull_off]
scene: {radius: 100, outer_radius: .inf, scheme: panel, preload: 1}
sweep: [{table: bodies.csv}]
""")
    expect(0, "*", f"run {case} --output {tmp_path / 'out'}")
    points = json.loads((tmp_path / "out" / "mixed" / "record.json").read_text())["points"]
    assert [point["sweep"]["unload_speed"] for point in points] == [None, 1]
    assert [point["sweep"]["viscoelastic"] for point in points] == [None, "sls:0.5"]


@pytest.mark.once
@pytest.mark.parametrize("scene, held", [("--tabor 10 --preload 10 --unload-speed 0 --viscoelastic sls:0.1", ["jkr", "persson-brener"]),
                                         ("--tabor 6 --preload 50 --unload-speed 2.5 --viscoelastic gamma:0.45,1.1", ["persson-brener"]),
                                         ("--tabor 7 --preload 50 --unload-speed inf --viscoelastic sls:0.3", ["jkr-at-once"]),
                                         ("--tabor 0.05 --preload 60 --unload-speed inf --viscoelastic sls:0.3", ["rigid-at-once"])])
def test_theories_that_hold_are_near(scene, held):
    rows = document(f"compare {scene} --tolerance 1e-4")["theories"]
    assert [row["theory"] for row in rows] == ["jkr", "persson-brener", "jkr-at-once", "rigid-at-once"]
    assert [row["theory"] for row in rows if row["assumptions"] == "yes"] == held
    assert all(abs(row["deviation"]) < 0.05 for row in rows if row["assumptions"] == "yes")


def test_theories_of_other_bodies_are_refused():
    expect(2, "*theory maugis cannot be evaluated: it is one of elastic bodies", f"compare --preload 3 {SOLID} 1 --theory maugis")
    expect(2, "*theory persson-brener cannot be evaluated: it is one of viscoelastic bodies", "compare --tabor 1 --theory persson-brener")
    expect(2, "*viscoelastic is given: expected elastic particles*", f"contact-law {SOLID} 1")
    wavy = document(f"compare --tabor 3 --amplitude 1 --wavelength 20 --preload 10 {SOLID} 1 --tolerance 1e-3")["theories"]
    assert wavy[3]["reason"] == "the surface has waves" and wavy[3]["force"] is None and wavy[1]["force"] > 1.5


BODY = "time_ms,modulus_mpa\n0.1,5\n10,4\ninf,1\n"


IN_SI = "solve --from-physical --work-j-per-m2 1e-3 --distance-m 1e-9 --radius-m 1e-9 --unload-speed-m-per-s inf --tolerance 1e-3 --viscoelastic prony:body.csv"


@pytest.mark.parametrize("table, relaxed, modulus", [
    (BODY, 1e6, 1e6), (BODY, 1e6, 2e9), (BODY, 1e6, 1e3), (BODY.replace("mpa", "kPa"), 1e3, 2e6), (BODY.replace("mpa", "GPa"), 1e9, 1e6),
    ("time_s,compliance_per_mpa\n0,1e-3\n1,0.999\n", 1e6, 5e6), ("time_s,compliance_per_gpa\n0,1\n1,999\n", 1e6, 1e6)])
def test_moduli_of_a_table_beside_that_of_the_scene(tmp_path, monkeypatch, table, relaxed, modulus):
    """Of the table only ratios are used. One in another unit, or of another material, was taken silently. Young's modulus, the
    shear modulus and two bodies of the material are from 1/4 to 2 times the contact modulus."""
    monkeypatch.chdir(tmp_path)
    pathlib.Path("body.csv").write_text(table)
    if relaxed == modulus:
        document(f"{IN_SI} --modulus-pa {modulus!r}")
        return
    expect(2, f"pulloff: --viscoelastic is prony:body.csv: expected a relaxed modulus from 1/4 to 2 times the contact modulus of the scene, "
           f"{modulus:.4g} Pa; in the table it is {relaxed:.4g} Pa. A column without a unit has ratios alone", f"{IN_SI} --modulus-pa {modulus!r}")
    pathlib.Path("own.yaml").write_text("name: own\ntitle: A table\nsuites: [own]\nwant: [pull_off]\nscene: {scheme: panel, viscoelastic: 'prony:body.csv', "
                                        f"unload_speed: .inf, physical: {{modulus_pa: {modulus!r}, work_j_per_m2: 1e-3, distance_m: 1e-9, radius_m: 1e-9}}}}\n")
    expect(2, "*own.yaml:*viscoelastic is *: expected a relaxed modulus from 1/4 to 2 times *", "plan own.yaml")
    pathlib.Path("body.csv").write_text(re.sub("(modulus|compliance)_[a-zA-Z_]+", r"\1", table))  # ratios alone
    expect(0, "", "plan own.yaml")


@pytest.mark.once
def test_a_table_of_a_material_is_known_by_its_content(tmp_path):
    """The digest does not depend on the path; a case names the table relative to its folder."""
    folder = tmp_path / "cases"
    folder.mkdir()
    for path in (tmp_path / "a b.csv", folder / "body.csv"):
        path.write_text(BODY)
    words = "--tabor 1 --preload 3 --tolerance 1e-4 --unload-speed 100"
    first = document(f"solve {words} --viscoelastic 'prony:{tmp_path / 'a b.csv'}'")
    second = document(f"solve {words} --viscoelastic prony:{folder / 'body.csv'}")
    assert first["digest"] == second["digest"] and first["unloading"]["terms"] == 2
    (folder / "body.csv").write_text(BODY.replace("4", "3.9"))
    other = document(f"solve {words} --viscoelastic prony:{folder / 'body.csv'}")
    assert other["digest"] != first["digest"] and other["pull_off"]["force"] != first["pull_off"]["force"]
    (folder / "body.csv").write_text(BODY)
    (folder / "bodies.csv").write_text("viscoelastic,unload_speed\nprony:body.csv,100\nsls:0.5,1\n")
    case = folder / "own.yaml"
    for name, lines in {"scene": "scene: {%s, viscoelastic: 'prony:body.csv', unload_speed: 100}",
                        "axis": "scene: {%s, unload_speed: 100}\nsweep: [{key: viscoelastic, values: ['prony:body.csv', 'sls:0.5']}]",
                        "table": "scene: {%s}\nsweep: [{table: bodies.csv}]"}.items():
        case.write_text("name: own\ntitle: Tables of materials\nsuites: [own]\nwant: [pull_off]\n"
                        + lines % "tabor: 1, radius: 100, outer_radius: .inf, scheme: panel, preload: 3, tolerance: 1e-4" + "\n")
        expect(0, "*", f"run {case} --output {tmp_path / name}")
        record = json.loads((tmp_path / name / "own" / "record.json").read_text())
        assert record["points"][0]["input"]["viscoelastic"] == "prony:body.csv"
        assert "--viscoelastic prony:body.csv " in record["points"][0]["command"]
        assert record["points"][0]["pull_off"]["force"] == second["pull_off"]["force"]
    case.write_text(case.read_text().replace("bodies.csv", "body.csv"))
    expect(2, "*the column time_ms is unknown: expected names of keys", f"run {case} --output {tmp_path / 'bad'}")


def test_times_in_seconds_need_no_relaxation_time(tmp_path):
    """tau_0 is then 1 s; a table without a unit is the same body with tau_0 in s."""
    (tmp_path / "s.csv").write_text(BODY.replace("mpa", "gpa"))
    (tmp_path / "own.csv").write_text("time,modulus\n1,5\n100,4\ninf,1\n")
    scene = ("solve --from-physical --modulus-pa 1e9 --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 3e-8 --preload-m 6e-10 "
             "--tolerance 1e-4 --unload-speed-m-per-s 3e-8 --viscoelastic")
    found = document(f"{scene} prony:{tmp_path / 's.csv'}")
    assert found["input"]["unload_speed"] == pytest.approx(100.0, rel=1e-12)
    assert document(f"{scene} prony:{tmp_path / 's.csv'} --relaxation-time-s 1")["digest"] == found["digest"]
    expect(2, "*--relaxation-time-s is 2: expected 1 or nothing, as the times of the material are in s",
           f"{scene} prony:{tmp_path / 's.csv'} --relaxation-time-s 2")
    own = document(f"{scene} prony:{tmp_path / 'own.csv'} --relaxation-time-s 1e-4")
    assert own["pull_off"]["force"] == pytest.approx(found["pull_off"]["force"], rel=1e-6)
    case = tmp_path / "own.yaml"
    case.write_text("""name: own
title: A table in SI units
suites: [own]
want: [pull_off]
scene:
  physical: {modulus_pa: 1e9, work_j_per_m2: 0.05, distance_m: 3e-10, radius_m: 3e-8, preload_m: 6e-10, unload_speed_m_per_s: 3e-8}
  scheme: panel
  tolerance: 1e-4
  viscoelastic: "prony:s.csv"
""")
    expect(0, "*", f"run {case} --output {tmp_path / 'out'}")
    record = json.loads((tmp_path / "out" / "own" / "record.json").read_text())
    assert record["points"][0]["input"]["unload_speed"] == pytest.approx(100.0, rel=1e-12)


@pytest.mark.parametrize("content, message", [
    ("time,gap\n1,2\n", ":1: the columns are time | gap: expected one time*and one of modulus and compliance*"),
    ("time,modulus,compliance\n1,0.1,0.1\n", ":1: the columns are time | modulus | compliance: expected one time*"),
    ("time,modulus\n1,-2\n", ":2: the modulus is -2: expected a number > 0"),
    ("time,compliance\n0.1,0.2\n1,0\n", ":3: the compliance is 0: expected a number > 0"),
    ("time,modulus\n2,0.1\n1,0.1\n", ":3: the time is 1: expected more than in the row before"),
    ("time,modulus\n1,1\n", ": the sum of the weights is 1: expected less than 1, or the relaxed modulus*"),
    ("time,modulus_pa\n1,5\n", ": the relaxed modulus (time inf, in the last row) is missing: expected it, as the weights have a unit"),
    ("time,compliance\n1,1.5\n", ": the sum of the weights is 1.5: expected less than 1, or the instantaneous compliance*"),
    ("time,modulus\n0,1\n", ":2: the time is 0: expected 1e-12 to 1e12 tau_0, or inf*"),
    ("time,compliance\n1,0.1\ninf,1\n", ":3: the time is inf: expected 1e-12 to 1e12 tau_0, or 0*"),
    ("time,modulus\ninf,1\n", ": the table has no finite time > 0: expected at least one"),
    ("time,modulus\n1,x\n", ":2: modulus is x: expected a finite number"),
    ("time,modulus\n1,1e-300\n2,1e300\ninf,1\n", ": the weights differ too much to be converted*"),
    ("time,modulus\n" + "".join(f"{k + 1},0.001\n" for k in range(161)), ":162: the number of times is 161: expected at most 160"),
])
def test_tables_of_materials_that_are_refused(content, message, tmp_path):
    (tmp_path / "body.csv").write_text(content)
    expect(4, f"pulloff: *body.csv{message}", f"solve --viscoelastic prony:{tmp_path / 'body.csv'} --unload-speed 1")


@pytest.mark.parametrize("words, message", [
    ("--viscoelastic prony:", "*--viscoelastic is prony:: expected sls:K or gamma:K,N*"),
    ("--viscoelastic sls:0", "*--viscoelastic is sls:0: expected sls:K or gamma:K,N*"),
    ("--viscoelastic sls:1.5 --unload-speed 1", "*--viscoelastic is sls:1.5: expected*"),
    ("--viscoelastic gamma:0.1 --unload-speed 1", "*--viscoelastic is gamma:0.1: expected*"),
    ("--viscoelastic sls:0.1", "*--unload-speed is missing: expected a number >= 0, or inf, beside viscoelastic"),
    ("--unload-speed 1", "*--unload-speed is 1: expected it beside viscoelastic"),
    (f"{SOLID} -1", "*--unload-speed is -1: expected a finite number >= 0, or inf"),
    (f"--tabor 0 {SOLID} 1", "*viscoelastic is given for a rigid scene: expected tabor > 0"),
    (f"--scheme ring {SOLID} 1", "*viscoelastic is given with the scheme ring: expected panel"),
    (f"--preload inf {SOLID} 1", "*preload is inf beside viscoelastic: expected a finite number"),
    (f"--want curve {SOLID} 1", "*a result other than history, profile and theories is wanted beside viscoelastic*"),
    ("--viscoelastic sls:0.1+-0.01 --unload-speed 1", "*--viscoelastic is sls:0.1+-0.01: expected sls:K or gamma:K,N*"),
    ("--want history", "*history is wanted: expected it beside viscoelastic"),
    ("--unload-speed-m-per-s 1 --viscoelastic sls:0.1", "*--unload-speed-m-per-s is 1: expected it with --from-physical*"),
])
def test_messages(words, message):
    expect(2, message, f"solve {words}")


def test_messages_of_si_units():
    scene = "--from-physical --modulus-pa 1e9 --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 3e-8 --viscoelastic sls:0.2"
    expect(2, "*--relaxation-time-s is missing: expected a finite number > 0, as the speed is in m/s",
           f"solve {scene} --unload-speed-m-per-s 1e-6")
    expect(2, "*--relaxation-time-s is 1: expected it beside a speed in m/s or a time in s",
           f"solve {scene} --relaxation-time-s 1")
