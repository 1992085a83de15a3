"""A case whose scene is in SI units is solved as a dimensionless scene; its results are also in newton and metre."""

import math

import pytest
from conftest import document, expect, load, matches, run

CASE = """
name: si
title: A sphere in metres
suites: [smoke]
scene:
  physical: {{{}}}
  scheme: panel
  tolerance: 1e-7
{}
{}
want: [pull_off]
checks:
  - {{quantity: pull_off_force, reference: {}, tolerance: {}, kind: abs, because: it is so good}}
"""
BODY = "work_j_per_m2: 0.05, distance_m: 3e-10, radius_m: 3e-8"
TIP = "modulus_pa: 1666666666.6666667, work_j_per_m2: 0.05, distance_m: 3e-10"


def write(data, physical, scene="", sweep="", reference="bradley", tolerance="1"):
    data.case("si", CASE.format(physical, scene, sweep, reference, tolerance))


def point():
    return load("run/si/record.json")["points"][0]


def test_a_sphere(data):
    """mu = (R w^2/(E*^2 eps^3))^(1/3) is 1 for E* = w (R/eps^3)^(1/2) = 0.05 (1e21/0.9)^(1/2) = (5/3) 1e9, and R is 100 eps;
    pi w R = 4.71238898038469e-9 N."""
    data.table("reference/table.csv", "tabor,radius,force,approach", "1,100,1.67066478,-0.8734")
    write(data, TIP + ", radius_m: 3e-8", reference="reference/table.csv", tolerance="1e-7")
    verified = expect(0, "*", "verify --verbose si --output run")
    assert verified.count("^si +pull_off_force .*oracle *within")
    assert verified.count(r"^si +pull_off +scene +7.872822[23][0-9]*e-09 N at approach -2.6201.*e-10 m$")
    p = point()
    assert abs(p["input"]["tabor"] - 1) < 1e-15 and abs(p["input"]["radius"] / 100 - 1) < 1e-15
    assert p["input"]["outer_radius"] == "inf" and "--tabor" in p["command"]
    units, found = p["physical"]["units"], p["physical"]["pull_off"]
    assert abs(units["force_n"] / 4.71238898038469e-9 - 1) < 1e-14 and units["length_m"] == 3e-10
    assert abs(found["force_n"] / 7.8728223e-9 - 1) < 1e-7
    assert abs(found["approach_m"] / (p["pull_off"]["approach"] * 3e-10) - 1) < 1e-14
    expect(0, "si: 1 point, 1 check: within (kept)", "run --output run")


def test_bradley(data):  # 2 pi w R
    write(data, "modulus_pa: inf, " + BODY, tolerance="1e-12")
    assert expect(0, "*", "verify --verbose si --output run").count(" 9.424777961e-09 N at approach ")


def test_a_wavy_sphere_on_a_cut_surface(data):
    write(data, TIP + ", radius_m: 3e-8, amplitude_m: 3e-11, wavelength_m: 3e-9, outer_radius_m: 3e-8")
    expect(1, "*", "verify --verbose si --output run")
    for key, value in (("amplitude", 0.1), ("wavelength", 10), ("outer_radius", 100)):
        assert abs(point()["input"][key] / value - 1) < 4e-15, key


def test_profile_and_waves_in_metres(data):
    """Without a radius, loads are in pi w epsilon."""
    write(data, TIP + ', profile: "punch:1.5e-9,6e-9", waves: "3e-11@3e-9;1.5e-11@6e-10"')
    expect(1, "*", "verify --verbose si --output run")
    p = point()
    i = p["input"]
    assert i["profile"] == "punch" and i["load_unit"] == "pi w epsilon" and i["radius"] == 1
    assert abs(i["punch_b"] / 5 - 1) < 4e-15 and abs(i["punch_r"] / 20 - 1) < 4e-15
    waves = [[float(x) for x in wave.split("@")] for wave in i["waves"].split(";")]
    assert all(abs(a / b - 1) < 4e-15 for w, v in zip(waves, ((0.1, 10), (0.05, 2))) for a, b in zip(w, v)), waves
    assert abs(i["tabor"] ** 1.5 / 0.1 - 1) < 1e-14
    assert abs(p["physical"]["units"]["force_n"] / (math.pi * 0.05 * 3e-10) - 1) < 1e-14


def test_load_end_and_spring_in_si_units(data):
    """The same keys as the options of solve give the same scene: digest of the case, digest of the command line."""
    keys = {"preload_m": "3e-10", "preload_load_n": "2e-9", "stiffness_n_per_m": "2", "approach_start_m": "-3e-9"}
    write(data, TIP + ", radius_m: 3e-8, " + ", ".join(f"{key}: {value}" for key, value in keys.items()), tolerance="10")
    expect(0, "*", "run si --output run")
    i = point()["input"]
    force, length = math.pi * 0.05 * 3e-8, 3e-10
    assert i["preload"] == 1 and abs(i["preload_load"] / (2e-9 / force) - 1) < 4e-15
    assert abs(i["stiffness"] / (2 / (force / length)) - 1) < 4e-15 and abs(i["approach_start"] + 10) < 4e-14
    options = " ".join(f"--{key.replace('_', '-')} {value}" for key, value in keys.items())
    tip = " ".join(f"--{key.replace('_', '-')} {value}" for key, value in (item.split(": ") for item in TIP.split(", ")))
    solved = document(f"solve --from-physical --radius-m 3e-8 --tolerance 1e-7 {tip} {options}")
    assert {key: solved["input"][key] for key in i if key in solved["input"] and key != "load_unit"} == \
        {key: i[key] for key in i if key in solved["input"] and key != "load_unit"}


# A length that is given in metres cannot also be given in epsilon.
BOTH = ("expected none of tabor, amplitude, wavelength, radius, outer_radius, the profile and waves, or a group of them, beside "
        "scene.physical")


@pytest.mark.parametrize("code, message, physical, more", [
    (2, "5: scene.physical.profile is power:1e9: expected sphere or *", TIP + ', profile: "power:1e9"', {}),
    (4, "5: scene.physical.profile_file: */cases/none.csv cannot be opened: *", TIP + ", radius_m: 3e-8, profile_file: none.csv", {}),
    (2, "5: scene.physical.waves is *: expected only one of scene.physical.amplitude_m and scene.physical.waves",
     TIP + ', profile: "cone:0.3", amplitude_m: 1e-9, wavelength_m: 1e-8, waves: "1e-9@1e-8"', {}),
    (2, "8: scene.tabor is 1: " + BOTH, "modulus_pa: 1e9, " + BODY, {"scene": "  tabor: 1"}),
    (2, "9: sweep[1].key is radius: " + BOTH, "modulus_pa: 1e9, " + BODY, {"sweep": "sweep: [{key: radius, values: [50, 100]}]"}),
    (2, "9: sweep[1].key is alpha: " + BOTH, "modulus_pa: 1e9, " + BODY, {"sweep": "sweep: [{key: alpha, values: [1]}]"}),
    (2, "5: scene.physical.modulus_pa is -1: expected a finite number > 0, or inf", "modulus_pa: -1, " + BODY, {}),
    (2, "5: scene.physical.modulus_pa is 1 GPa: expected a finite number > 0, or inf; a unit or other text follows the number", "modulus_pa: 1 GPa, " + BODY, {}),
    (2, "5: scene.physical.radius_m is missing: expected a finite number > 0, or two with a comma between; a scene in SI units has *",
     "modulus_pa: 1e9, work_j_per_m2: 0.05, distance_m: 3e-10", {}),
    (2, "8: scene.preload_load is 1: expected only this key, or that of scene.physical",
     TIP + ", radius_m: 3e-8, preload_load_n: 1e-9", {"scene": "  preload_load: 1"}),
    (2, "5: scene.physical.preload_load_n is -1: expected a finite number >= 0", TIP + ", radius_m: 3e-8, preload_load_n: -1", {}),
    (2, "5: scene.physical.radius is unknown: expected one of modulus_pa, young_pa, poisson, *", f"modulus_pa: 1e9, {BODY}, radius: 3", {})])
def test_wrong_scenes(data, code, message, physical, more):
    write(data, physical, **more)
    expect(code, "pulloff: cases/si.yaml:" + message, "plan si")


# -- Tables in SI units --

TABLE = """
name: si
title: A tip, and a table in nN and nm
suites: [smoke]
scene:
  physical: {{{}, radius_m: 3e-8}}
  scheme: panel
  tolerance: 1e-7
want: [{}]
checks:
  - {{quantity: {}, reference: reference/table.csv, tolerance: {}, kind: {}, because: it is so good}}
"""


def judge(data, code, columns, rows, quantity="pull_off_force", tolerance="1e-6", kind="rel", want="pull_off",
          uncertainty="0"):
    data.table("reference/table.csv", columns, *rows, uncertainty=uncertainty)
    data.case("si", TABLE.format(TIP, want, quantity, tolerance, kind))
    return expect(code, "*" if code < 2 else f"pulloff: {data.message}", "verify --verbose si --output run")


@pytest.mark.parametrize("column, factor", [("force_nN", 1e9), ("force_n", 1), ("force_uN", 1e6), ("force_mN", 1e3)])
def test_a_table_in_newtons(data, column, factor):
    force = 7.8728223e-9 * factor
    for code, word, value in ((0, "within", force), (1, "outside", 1.01 * force)):
        assert judge(data, code, f"radius_m,{column},approach_nm", [f"3e-8,{value!r},0"]).count(rf"^si +pull_off_force .*oracle *{word}")


def test_the_uncertainty_of_a_table_in_newtons(data):
    """An uncertainty is stated in a column, in another unit, or in the header; it is 0.16 nN/(pi w R) = 0.034."""
    for columns, row, header in (("force_nN,force_uncertainty_nN", "7.87,0.16", "0"), ("force_nN,uncertainty", "7.87,0.16", "0"),
                                 ("force_nN,force_uncertainty_pN", "7.87,160", "0"), ("force_nN", "7.87", "0.16")):
        judge(data, 0, columns, [row], uncertainty=header, tolerance="0.0340", kind="abs")
        data.message = ("cases/si.yaml:10: checks[1].tolerance is 0.0339: expected at least 0.0339530545262710*, the uncertainty of "
                        "reference/table.csv")
        judge(data, 2, columns, [row], uncertainty=header, tolerance="0.0339", kind="abs")


def test_a_curve_in_nanometres(data):
    """The table that solve writes, as a reference of the same scene."""
    tip = " ".join(f"--{key.replace('_', '-')} {value}" for key, value in (item.split(": ") for item in TIP.split(", ")))
    lines = run(f"solve --from-physical --radius-m 3e-8 --tolerance 1e-7 {tip} --curve -").out.splitlines()
    names, *rows = [line for line in lines if not line.startswith("#")]
    assert names.startswith("approach_nm,load_nN,")
    assert judge(data, 0, names, rows, "curve", "1e-9", "abs", "curve").count(r"^si +curve .*oracle *(within|slack)")
    rows = [",".join([cells[0], repr(1.001 * float(cells[1]))] + cells[2:]) for cells in (row.split(",") for row in rows)]
    assert judge(data, 1, names, rows, "curve", "1e-9", "abs", "curve").count(r"^si +curve .*oracle *outside")


def test_tables_whose_units_cannot_be_used(data):
    data.message = ("reference/table.csv:*: uncertainty has no unit, and the columns have several: expected columns such as "
                    "force_uncertainty_nN")
    judge(data, 4, "force_nN,approach_nm,uncertainty", ["7.87,-0.26,0.1"])
    data.message = data.message.replace("force_", "load_")  # a curve has no force, and the message named it
    judge(data, 4, "load_nN,approach_nm,uncertainty", ["7.87,-0.26,0.1"])
    data.message = "reference/table.csv:*: the column force is given twice, in two units"
    for columns in ("force_nN,force_n", "force,force_nN", "force_nN,force"):  # the last one was accepted
        judge(data, 4, columns, ["7.87,7.87e-9"])
    data.message = "reference/table.csv:*: force is nan: expected a finite number"
    judge(data, 4, "force_nN", ["nan"])
    data.message = ("reference/table.csv:*: the column force_nN is in SI units: expected force, or a case whose scene is in SI "
                    "units (scene.physical)")
    data.table("reference/table.csv", "tabor,force_nN", "1,7.87")
    data.case("si", TABLE.format(TIP, "pull_off", "pull_off_force", "1", "abs").replace(
        "physical: {" + TIP + ", radius_m: 3e-8}", "tabor: 1\n  radius: 100\n  outer_radius: inf"))
    expect(4, "pulloff: " + data.message, "verify si --output run")


def test_two_bodies(data):
    """Bodies as they are given, in a case as on the command line."""
    write(data, 'young_pa: "9e9,2e9", poisson: "0.22,0.4", radius_m: "2e-8,5e-8", work_j_per_m2: 0.05, distance_m: 3e-10')
    expect(0, "*", "run si --output run")
    d = document("solve --from-physical --young-pa 9e9,2e9 --poisson 0.22,0.4 --radius-m 2e-8,5e-8 --work-j-per-m2 0.05 "
                 "--distance-m 3e-10 --tolerance 1e-7 --preload-load 1"
                 .replace("--preload-load 1", f"--preload-load-n {math.pi * 0.05 / (1 / 2e-8 + 1 / 5e-8)!r}"))
    assert point()["input"]["tabor"] == d["input"]["tabor"]
    assert abs(point()["pull_off"]["force"] / d["pull_off"]["force"] - 1) < 1e-9


SWEPT = """
name: swept
title: Tips in metres
suites: [smoke]
scene:
  scheme: panel
  tolerance: 1e-5
  physical: {{{}}}
sweep: {}
want: [pull_off]
{}
"""
REST = "work_j_per_m2: 0.05, distance_m: 3e-10"


def swept(data, physical, sweep, more=""):
    data.case("swept", SWEPT.format(physical, sweep, more))


def test_sweeps_in_si_units(data):
    """Each point is that of its own scene in SI units, has its own units, and the keys as they were given."""
    swept(data, REST + ', poisson: "0.2,0.4"', "[{key: radius_m, values: [1e-8, 5e-8]}, "
          "{together: [{young_pa: '160e9,2e9', preload_load_n: 1e-8}, {young_pa: '160e9,5e9', preload_load_n: 2e-8}]}]")
    expect(0, "*", "run swept --output run --summary summary.csv")
    points = load("run/swept/record.json")["points"]
    assert [p["sweep"]["radius_m"] for p in points] == [1e-8, 1e-8, 5e-8, 5e-8]
    for p in points:
        s = p["sweep"]
        d = document(f"solve --from-physical --work-j-per-m2 0.05 --distance-m 3e-10 --poisson 0.2,0.4 --radius-m {s['radius_m']!r} "
                     f"--young-pa {s['young_pa']} --preload-load-n {s['preload_load_n']!r} --tolerance 1e-5")
        assert p["input"]["tabor"] == d["input"]["tabor"] and p["input"]["radius"] == d["input"]["radius"]
        assert p["physical"]["units"] == d["physical"]["units"]
        assert p["pull_off"] == d["pull_off"] and p["physical"]["pull_off"] == d["physical"]["pull_off"]
    rows = [line.split(",") for line in open("summary.csv") if not line.startswith("#")]
    names = rows[0]
    for p, row in zip(points, rows[1:]):
        assert float(row[names.index("force_nN")]) * 1e-9 == pytest.approx(p["physical"]["pull_off"]["force_n"], rel=1e-14)
        assert float(row[names.index("radius_m")]) == p["sweep"]["radius_m"]
    assert expect(0, "*", "verify --verbose swept --output run").out.count("N at approach") == 4


def test_a_table_of_parameter_sets(data):
    """A row is a point; semicolons stand for commas, - for a key that is not given."""
    (data.folder / "cases/sets.csv").write_text("radius_m,young_pa,amplitude_m,wavelength_m\n1e-8,160e9;2e9,-,-\n3e-8,160e9;2e9,1e-10,3e-9\n")
    swept(data, REST + ', poisson: "0.2,0.4"', "[{table: sets.csv}]")
    expect(0, "*", "run swept --output run")
    points = load("run/swept/record.json")["points"]
    assert [p["sweep"]["radius_m"] for p in points] == [1e-8, 3e-8] and points[0]["sweep"]["amplitude_m"] is None
    assert points[1]["input"]["amplitude"] == pytest.approx(1 / 3)
    (data.folder / "cases/plain.csv").write_text("tabor,radius\n1,50\n2,100\n")
    data.case("plain", "name: plain\ntitle: A\nsuites: [smoke]\nscene: {outer_radius: inf, scheme: panel, tolerance: 1e-5}\n"
              "sweep: [{table: plain.csv}]\nwant: [pull_off]\n")
    expect(0, "*", "run plain --output run")
    assert [p["sweep"] for p in load("run/plain/record.json")["points"]] == [{"tabor": 1, "radius": 50}, {"tabor": 2, "radius": 100}]


def test_a_followed_series_in_si_units(data):
    swept(data, REST + ", modulus_pa: 2e9", "[{key: radius_m, from: 2e-8, to: 3e-8, count: 5}]", "follow: radius_m\ncheckpoint_every: 4")
    expect(0, "*", "run swept --output run")
    points = load("run/swept/record.json")["points"]
    assert [p["followed"] for p in points] == [False, True, True, True, False]
    for p in points:
        d = document(f"solve --from-physical --work-j-per-m2 0.05 --distance-m 3e-10 --modulus-pa 2e9 --tolerance 1e-5 "
                     f"--radius-m {p['sweep']['radius_m']!r}")
        assert p["physical"]["pull_off"]["force_n"] == pytest.approx(d["physical"]["pull_off"]["force_n"], rel=1e-5)


@pytest.mark.parametrize("physical, sweep, message", [
    (REST + ", modulus_pa: 1e9, radius_m: 1e-8", "[{key: radius_m, values: [1e-8]}]",
     "cases/swept.yaml:8: sweep[1].key is radius_m: expected a key that scene.physical does not give"),
    (REST + ", modulus_pa: 1e9", "[{key: radius_m, values: [1e-8]}, {together: [{radius_m: 2e-8}]}]",
     "cases/swept.yaml:8: sweep[2].together is a list: expected each key swept once"),
    (REST + ", modulus_pa: 1e9", "[{key: radius_m, values: [1e-8, -1]}]", "cases/swept.yaml:8: sweep[1].values[2] is -1: expected a finite number > 0*"),
    (REST + ", modulus_pa: 1e9", "[{key: approach_m, values: [1e-8]}]", "cases/swept.yaml:8: sweep[1].key is approach_m: expected a key of the scene*"),
    (REST + ", modulus_pa: 1e9", "[{key: tabor, values: [1]}]", "cases/swept.yaml:8: sweep[1].key is tabor: expected none of *"),
    (REST + ", modulus_pa: 1e9", "[{table: no.csv}]", "*no.csv*")])
def test_wrong_sweeps_in_si_units(data, physical, sweep, message):
    swept(data, physical, sweep)
    ended = run("plan swept")
    assert ended.code in (2, 4) and matches(ended.err, "pulloff: " + message), ended.err


def test_wrong_tables_of_parameter_sets(data):
    swept(data, REST + ", modulus_pa: 1e9", "[{table: sets.csv}]")
    for text, message in (("radius_m\n1e-8\n-1\n", "*sets.csv: radius_m in row 2 is -1: expected a finite number > 0*"),
                          ("radios\n1\n", "*sets.csv:1: the column radios is unknown: expected names of keys"),
                          ("radius_m\n1e-8\n1e-8\n", "*sets.csv: row 2: expected each setting once"),
                          ("radius_m\n", "*sets.csv has no rows: expected one for each point"),
                          ("radius_m,tabor\n1e-8,1\n", "cases/swept.yaml:8: sweep[1].table is *sets.csv: expected none of tabor, *"),
                          ("radius_m\n-\n", "*sets.csv: row 1: expected keys of the scene")):
        (data.folder / "cases/sets.csv").write_text(text)
        assert matches(run("plan swept").err, "pulloff: " + message), run("plan swept").err


def test_tables_in_si_units_beside_a_sweep_of_units(data):
    data.table("reference/table.csv", "tabor,radius,force_nN,approach", "1,100,1,-0.8734")
    swept(data, REST + ", modulus_pa: 1e9", "[{key: radius_m, values: [1e-8]}]",
          "checks: [{quantity: pull_off_force, reference: reference/table.csv, tolerance: 1, kind: abs, because: b}]")
    expect(2, "pulloff: cases/swept.yaml: reference reference/table.csv is in SI units: expected a dimensionless one, as the sweep "
              "varies the units", "plan swept")
