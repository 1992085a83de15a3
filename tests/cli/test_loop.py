"""The path of a test as a table: its area is the energy lost within the stated error, its jumps are two rows, and it is the
same in a file, in the document and in a run, in SI units too."""

import math
import pathlib
import re

import pytest
from conftest import document, expect, load, rows_of, run

BODY = " --from-physical --modulus-pa 1.3385e9 --work-j-per-m2 0.0537 --distance-m 3.1e-10 --radius-m 2.7e-8"
SCENES = ["--tabor 2.385", "--tabor 0.3", "--tabor 0 --radius 57", "--tabor 3 --amplitude 1 --wavelength 20 --preload 6",
          "--profile cone:0.3 --coupling 0.4 --law morse:2 --outer-radius 60", "--tabor 2 --stiffness 0.05",
          "--tabor 3 --amplitude 1 --wavelength 20 --stiffness 0.37"]


def table(path):
    """The columns of a table as lists, and its first header line."""
    lines, rows = pathlib.Path(path).read_text().splitlines(), rows_of(path)
    return {name: [row[name] if name in ("phase", "case", "status") else float(row[name]) for row in rows] for name in rows[0]}, lines[0]


def area(base, load):
    return sum(0.5 * (load[k] + load[k + 1]) * (base[k + 1] - base[k]) for k in range(len(base) - 1))


@pytest.mark.parametrize("scene", SCENES)
def test_the_area_of_the_rows_is_the_energy_lost(scene):
    found = document(f"solve {scene} --loop loop.csv")["hysteresis"]
    rows, what = table("loop.csv")
    loop = found.get("spring", found["displacement_control"])
    stiffness = loop.get("stiffness", math.inf)
    stated = loop["path"]["area_error_estimate"]
    measured = area(rows["base"], rows["load"])
    # The rows are printed with all digits: what is stated holds to rounding.
    assert abs(measured - loop["energy_lost"]) <= stated * (1 + 1e-6) + 1e-12
    assert stated <= 1e-5 * max(-load for load in rows["load"]) * 2 * (max(rows["base"]) - min(rows["base"])) + loop["work_error"] \
        if "work_error" in loop else stated < 1e-3 * max(1, loop["energy_lost"])
    assert math.isclose(sum(rows["energy_lost"]), loop["energy_lost"], rel_tol=1e-14, abs_tol=1e-15)
    assert float(re.search("lose ([-0-9.e+]*) pi", what)[1]) == pytest.approx(loop["energy_lost"], rel=1e-9)
    jumps = [k for k, jump in enumerate(rows["jump"]) if jump]
    assert len(jumps) == len(loop["jumps"])
    for k, jump in zip(jumps, loop["jumps"]):
        assert rows["phase"][k] == jump["phase"] and rows["energy_lost"][k] == jump["energy_lost"]
        assert abs(rows["base"][k] - rows["base"][k - 1]) < 1e-6 * max(1, abs(rows["base"][k]))
        for row, state in ((k - 1, jump["before"]), (k, jump["after"])):
            assert rows["approach"][row] == state["approach"] and rows["load"][row] == state["load"]
    for k in range(1, len(rows["base"])):  # the base moves forth, then back
        step = rows["base"][k] - rows["base"][k - 1]
        slack = 1e-6 * max(1, abs(rows["base"][k]))
        assert step > -slack if rows["phase"][k] == "loading" else step < slack
        assert rows["base"][k] == pytest.approx(rows["approach"][k] + rows["load"][k] / stiffness, rel=1e-14, abs=1e-14)
    # Deepest tension and reversal are rows.
    unloading = [load for load, phase in zip(rows["load"], rows["phase"]) if phase == "unloading"]
    assert min(unloading) == loop["pull_off"]["load"]
    assert max(rows["approach"]) == pytest.approx(loop["preload"]["approach"], abs=1e-12)
    assert [list(row.values()) for row in loop["path"]["rows"]] == [
        [None if isinstance(cell, float) and math.isnan(cell) else cell for cell in row] for row in zip(*rows.values())]


def test_stiffness_and_indentation():
    """The stiffness is the derivative of the load; the indentation counts from the first contact."""
    rows = document("solve --tabor 1.37 --want loop")["hysteresis"]["displacement_control"]["path"]["rows"]
    contact = next(row for row in rows if row["contact_radius"] > 0)
    assert contact["indentation"] == 0
    for row in rows:
        assert math.isclose(row["indentation"], row["approach"] - contact["approach"], abs_tol=1e-12)
    for a, b, c in zip(rows, rows[1:], rows[2:]):
        if a["phase"] == c["phase"] == "loading" and not b["jump"] and not c["jump"] and b["approach"] > 0:
            assert min(a["stiffness"], c["stiffness"]) <= b["stiffness"] <= max(a["stiffness"], c["stiffness"])
            chord = (c["load"] - a["load"]) / (c["approach"] - a["approach"])
            assert chord == pytest.approx(b["stiffness"], rel=2e-2)


def test_si_units():
    dimensionless = document("solve --stiffness-n-per-m 1.7 --loop si.csv" + BODY)
    rows, what = table("si.csv")
    found = dimensionless["hysteresis"]["spring"]["path"]["rows"]
    units = dimensionless["physical"]["units"]
    assert set(rows) == {"phase", "jump", "base_nm", "approach_nm", "indentation_nm", "load_nN", "contact_radius_nm",
                         "stiffness_N_per_m", "energy_lost_aJ"}
    assert len(found) == len(rows["phase"])
    for k, row in enumerate(found):
        assert rows["base_nm"][k] * 1e-9 == pytest.approx(row["base"] * units["length_m"], rel=1e-13)
        assert rows["load_nN"][k] * 1e-9 == pytest.approx(row["load"] * units["force_n"], rel=1e-13)
        assert rows["energy_lost_aJ"][k] * 1e-18 == pytest.approx(row["energy_lost"] * units["length_m"] * units["force_n"], rel=1e-13)
    # The base of a cantilever: approach plus deflection.
    for k in range(len(found)):
        assert rows["base_nm"][k] == pytest.approx(rows["approach_nm"][k] + rows["load_nN"][k] / 1.7, rel=1e-12, abs=1e-12)
    assert "aJ, with an error of at most" in what


def test_no_other_result_changes():
    plain = document("solve --tabor 2.385 --want hysteresis")
    with_rows = document("solve --tabor 2.385 --want loop")
    assert with_rows["hysteresis"]["displacement_control"].pop("path")["rows"]
    for key in "pull_off", "folds", "extrema", "hysteresis":
        assert with_rows[key] == plain[key], key


def test_messages():
    expect(2, "pulloff: --loop is *: expected the name of a file", "solve --tabor 1 --loop", "")
    expect(2, "pulloff: standard output is asked for twice*", "solve --tabor 1 --json --loop -")
    expect(2, "pulloff: --loop has no effect on plot*", "plot --tabor 1 --loop a.csv")
    assert expect(0, "", "solve --tabor 1 --want loop").count("^loop +[0-9]+ rows; --loop FILE or --json writes them$") == 1


CASE = """
name: {}
title: Loops
suites: [smoke]
scene: {}
sweep: [{{key: {}}}]
want: [pull_off, loop]
"""


def test_cases_write_loops_and_a_summary(data):
    data.case("spheres", CASE.format("spheres", "{radius: 100, outer_radius: inf, scheme: panel}", "tabor, values: [0.7, 2.385]"))
    data.case("tips", CASE.format(
        "tips", "{scheme: panel, physical: {modulus_pa: 2e9, work_j_per_m2: 0.05, distance_m: 3e-10, radius_m: 3e-8}}",
        "tolerance, values: [1e-5, 1e-6]"))
    assert "keep the states of loading and unloading: the case wants the loop" in expect(0, "", "plan spheres").out
    expect(0, "*", "run spheres --output run --summary spheres.csv")
    points = load("run/spheres/record.json")["points"]
    summary, _ = table("spheres.csv")
    assert summary["status"] == ["ok", "ok"] and summary["tabor"] == [0.7, 2.385] and summary["point"] == [0, 1]
    for k, point in enumerate(points):
        rows, _ = table(f"run/spheres/{point['loop']}")
        loop = point["hysteresis"]["displacement_control"]
        assert abs(area(rows["base"], rows["load"]) - loop["energy_lost"]) <= loop["path"]["area_error_estimate"] * 1.000001
        assert summary["force"][k] == point["pull_off"]["force"]
        assert summary["force_error"][k] == point["pull_off"]["error_estimate"]
        assert summary["energy_lost"][k] == loop["energy_lost"] and summary["work"][k] == loop["work"]
    # A stored result has the same tables; an altered one is noticed.
    kept = pathlib.Path("run/spheres/loop-1.csv")
    before = kept.read_bytes()
    expect(0, "*kept*", "run spheres --output run")
    kept.write_bytes(before.replace(b"loading,1", b"loading,0"))
    assert "was altered or damaged" in run("run spheres --output run").err
    assert kept.read_bytes() == before
    # In SI units, with the prefixes of the scene.
    expect(0, "*", "run tips --output run --summary tips.csv")
    points = load("run/tips/record.json")["points"]
    summary, _ = table("tips.csv")
    for k, point in enumerate(points):
        rows, _ = table(f"run/tips/{point['loop']}")
        assert "base_nm" in rows and "load_nN" in rows
        assert summary["force_nN"][k] * 1e-9 == pytest.approx(point["physical"]["pull_off"]["force_n"], rel=1e-14)
        assert summary["energy_lost_aJ"][k] * 1e-18 == pytest.approx(
            point["physical"]["hysteresis"]["displacement_control"]["energy_lost_j"], rel=1e-14)
    mixed = run("run spheres tips --output run --summary both.csv")
    assert mixed.code == 2 and "no summary is written: the case tips is in SI units and spheres is not" in mixed.err
