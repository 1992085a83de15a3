"""The pull-off of a series of scenes: the verb follow, and cases with the key `follow`. What is followed is compared with full
traces in tests/unit/test_follow.c and test_follow_folds.c."""

import fnmatch
import json
import pathlib
import re
import sys

import pytest
from conftest import ROOT, agree, document, expect, load, run

sys.path.insert(0, str(ROOT / "tests"))
import checksum  # noqa: E402

TIP = {"modulus-pa": "2e9", "work-j-per-m2": "0.05", "distance-m": "3e-10"}


def tip(*without):
    return " --from-physical " + " ".join(f"--{key} {value}" for key, value in TIP.items() if key not in without)


@pytest.mark.parametrize("message, words", [
    ("--key is not given: expected --key, --from and --to", "--from 1 --to 2"),
    ("--from is not given: expected --key, --from and --to", "--key tabor --to 2"),
    ("--to is not given: expected --key, --from and --to", "--key tabor --from 2 --scale linear"),
    ("--from is 2 and --to is 2: expected two different values > 0, or --scale linear", "--key tabor --from 2 --to 2"),
    ("--key is scheme: expected *", "--key scheme --from 1 --to 2"),
    ("--tabor is given, but its value varies (--key): *", "--key tabor --from 1 --to 2 --tabor 1"),
    ("--from is 0 and --to is 2: expected two different values > 0, or --scale linear", "--key tabor --from 0 --to 2"),
    ("--wavelength is missing: expected it beside --amplitude", "--key tabor --from 1 --to 2 --amplitude 1"),
    ("--wavelength is missing: expected it beside --amplitude", "--key amplitude --from 0 --to 1 --scale linear"),
    ("--wavelength is 0: expected a finite number > 0 beside --amplitude",
     "--key tabor --from 1 --to 2 --amplitude-ratio 0.1 --wavelength 0"),
    ("--amplitude-ratio is 0.1: expected only one of --amplitude and --amplitude-ratio", "--key amplitude --from 1 --to 2 --amplitude-ratio 0.1 --wavelength 20"),
    ("--radius is -3: *", "--key tabor --from 1 --to 2 --radius -3"),
    ("--stiffness has no effect here: the pull-off force is that of a minimum of the load, *", "--key tabor --from 1 --to 2 --stiffness 2"),
    ("--points is 1: *", "--key tabor --from 1 --to 2 --points 1"),
    ("--of is fold: expected pull-off or folds*", "--key tabor --from 1 --to 2 --of fold"),
    ("folds are not followed from scene 1 to the next: *",
     "--key amplitude --from 0 --to 1 --scale linear --points 3 --wavelength 20 --of folds"),
    ("standard output is asked for twice: *", "--key tabor --from 1 --to 2 --curve - --json"),
    ("--curve has no effect on --of folds: *", "--key tabor --from 1 --to 2 --of folds --curve a.csv"),
    ("--key is time-limit: *", "--key time-limit --from 1 --to 2"),
    ("--radius-m is 1e-07: expected it with --from-physical, *", "--key radius-m --from 1e-7 --to 2e-7"),
    ("--radius is 1: expected --radius-m, as the scene is in SI units", "--key radius --from 1 --to 2" + tip()),
    ("--modulus-pa is -1: expected *", "--from-physical --key radius-m --from 1e-7 --to 2e-7 --modulus-pa -1")])
def test_wrong_command_lines(message, words):
    expect(2, "pulloff: " + message, "follow " + words)


def test_a_smooth_sphere_needs_no_wavelength():
    series = "follow --key tabor --from 1 --to 1.1 --points 2 --tolerance 1e-3"
    assert document(series + " --amplitude 0")["digest"] == document(series)["digest"]


CASE = """
name: good
title: Lines that are followed
suites: [smoke]
scene: {{radius: 93, outer_radius: 80, scheme: panel, tolerance: 1e-4, wavelength: 21}}
sweep:
  - {{key: amplitude_ratio, values: [0.01, 0.02]}}
  - {{key: tabor, from: 0.5, to: 0.9, count: 6, scale: log}}
{}
want: [{}]
checks:
  - {{quantity: solved_share, reference: every_scene, tolerance: 0.01, kind: abs, because: all have}}
"""
AGAINST = "  - {{quantity: {}, reference: traced, tolerance: 1e-5, kind: rel, because: each is solved for 1e-4}}\n"


def write(data, more, want="pull_off", against=None):
    data.case("good", CASE.format(more, want) + (AGAINST.format(against) if against else ""))


EVERY_4 = "follow: tabor\ncheckpoint_every: 4"


@pytest.mark.parametrize("message, more, want, against", [
    ("*follow is amplitude_ratio: expected the last key of the sweep*", "follow: amplitude_ratio", "pull_off", None),
    ("*want?1? is folds: expected pull_off alone*", "follow: tabor", "folds", None),
    ("*checkpoint_every is 3: expected*beside follow", "checkpoint_every: 3", "pull_off", None),
    ("*repeats is 2: expected 1*", "follow: tabor\nrepeats: 2", "pull_off", None),
    ("*traced is*: expected a check against traced", "follow: tabor\ntraced: {seed: 7, count: 3}", "pull_off", None),
    ("*checks?2?.reference is traced: expected traced only for a pull-off, in a case with*", EVERY_4, "pull_off", "pull_off_force"),
    ("*checks?2?.reference is traced: expected every_scene*", EVERY_4 + "\ntraced: {seed: 7, count: 3}", "pull_off", "solved_share"),
    ("*traced.count is 7: expected a whole number from 1 to the number of scenes between checkpoints",
     EVERY_4 + "\ntraced: {seed: 7, count: 7}", "pull_off", "pull_off_force"),
    ("*traced.seed is -1: expected a whole number*", EVERY_4 + "\ntraced: {seed: -1, count: 3}", "pull_off", "pull_off_force")])
def test_wrong_cases(data, message, more, want, against):
    write(data, more, want, against)
    expect(2, message, "plan good")


def numbers(record):
    return [(p["id"], p["pull_off"], p["followed"], p["work"]["newton_iterations"]) for p in load(record)["points"]]


def traced_points(record):
    return [p for p in load(record)["points"] if "traced" in p]


def traces(record):
    return [(p["id"], p["traced"]["pull_off"]) for p in traced_points(record)]


def alter(record, drawn, change):
    """Changes a point in the store beside a record, and gives its line the checksum of the new content."""
    [stated] = [p["checksum"] for p in load(record)["points"] if p["id"] == drawn]
    store = pathlib.Path(record).with_name("points.jsonl")
    points = [json.loads(line) for line in store.read_text().splitlines()]
    for point in points:
        if point["checksum"] == stated:
            change(point)
    store.write_text("".join(map(checksum.line_of, points)))


def test_a_case_with_two_series(data):
    write(data, EVERY_4)
    planned = expect(0, "", "plan good")
    assert "in tabor along 2 series of 6 scenes; every 4 scenes one is traced" in planned.out
    expect(0, "good: 12 points, 1 check: within", "run good --output whole --jobs 2")
    whole, record = "whole/good/record.json", "traced/good/record.json"
    assert sum(p["followed"] for p in load(whole)["points"]) >= 6

    # A series is solved as a whole, whichever of its points are kept or selected.
    expect(0, "good: 3 of 12 points, 1 check: within", "run good --output parts --points 7-9")
    expect(0, "good: 12 points, 1 check: within (3 points kept)", "run good --output parts --jobs 1")
    assert numbers("parts/good/record.json") == numbers(whole)
    expect(0, "good: 12 points, 1 check: within (kept)", "run good --output parts")

    # With other checkpoints the results differ, so that none of them is kept.
    write(data, EVERY_4.replace("every: 4", "every: 3"))
    expect(0, "good: 12 points, 1 check: within", "run good --output parts --jobs 2")

    # Some scenes are also traced; both values must agree.
    write(data, EVERY_4 + "\ntraced: {seed: 7, count: 3}", against="pull_off_force")
    planned = expect(0, "", "plan good")
    assert "compare pull_off_force with traced at 3 of 12 points, tolerance" in planned.out
    assert "has no value" not in planned.out
    assert "trace 3 scenes between checkpoints in addition, drawn with seed 7" in planned.out
    expect(0, "good: 12 points, 4 checks: within", "run good --output traced --jobs 2")
    assert [p["followed"] for p in traced_points(record)] == 3 * [True]
    assert [p["traced"]["folds"] is None for p in traced_points(record)] == 3 * [False], "the trace is a full trace"
    assert numbers(record) == numbers(whole), "the traces do not change the followed values"
    drawn = traced_points(record)[1]["id"]
    expect(0, "good: 1 of 12 points, 2 checks: within", "run good --output one --points", drawn)
    expect(0, "good: 12 points, 4 checks: within (1 point kept)", "run good --output one --jobs 1")
    assert traces("one/good/record.json") == traces(record)

    # A difference within the errors that both values state is no fault of either.
    case = data.folder / "cases/good.yaml"
    case.write_text(case.read_text().replace("tolerance: 1e-5", "tolerance: 1e-14"))
    explained = expect(1, "*", "explain good --output one").out
    assert "fault      tolerance: the difference is within the stated errors of both values together" in explained
    assert "another pull-off" not in explained
    write(data, EVERY_4 + "\ntraced: {seed: 7, count: 3}", against="pull_off_force")

    # A difference between a followed and a traced value is an error. A missing trace is no agreement.
    alter(record, drawn, lambda p: p["traced"]["pull_off"].update(force=p["traced"]["pull_off"]["force"] * (1 + 2e-5)))
    assert expect(1, "*", "verify --verbose good --output traced").count(r"^good +pull_off_force .* oracle +outside")
    assert traces(record) != traces("one/good/record.json"), "the record is written again if a stored result is another"
    assert "the trace of the same scene finds another pull-off" in expect(1, "*", "explain good --output traced").out
    alter(record, drawn, lambda p: p["traced"].update(status="not_converged", reason="it is made so", pull_off=None))
    assert "missing_reference: the trace failed: it is made so" in expect(1, "*", "verify --verbose good --output traced").out

    # Stored results that were altered do not have their checksum: they are no results.
    store = pathlib.Path(record).with_name("points.jsonl")
    store.write_text(store.read_text().replace('"force":1', '"force":2'))
    again = run("verify good --output traced")
    assert re.search("^good: [0-9]+ stored results were altered or damaged and are solved again$", again.err, re.MULTILINE)
    assert '"force": 1' in pathlib.Path(record).read_text(), "the results are those of before"


@pytest.mark.once
@pytest.mark.parametrize("want", ["hysteresis", "preload", "diagnostics", "theories"])
def test_the_command_of_a_traced_point_repeats_it(data, want):
    write(data, "", want)
    run("run good --output whole")
    for point in load("whole/good/record.json")["points"][::5]:
        assert point["command"].startswith("pulloff solve ")
        assert document(point["command"].removeprefix("pulloff ")).get("digest") == point["digest"]


@pytest.mark.once
def test_the_command_that_explain_prints_for_a_followed_point_repeats_it(data):
    write(data, EVERY_4)
    expect(0, "*", "run good --output whole --time-limit 60")
    followed = [p for p in load("whole/good/record.json")["points"] if p["followed"]]
    write(data, EVERY_4 + "\ntraced: {seed: 7, count: 3}", against="pull_off_force")
    told = expect(0, "*", "explain good --all --output traced --time-limit 60").out
    commands = re.findall(r"^  rerun +(pulloff verify good --points ([0-9]+) .*)$", told, re.M)
    assert len(followed) > 3 and len(commands) == 3
    for command, number in commands:
        assert command == f"pulloff verify good --points {number} --time-limit 60 --fresh --verbose --output traced"
        expect(0, "*", command.removeprefix("pulloff ").replace("--output traced", "--output again"))
        [digest_of] = [p["digest"] for p in followed if p["id"] == number]
        assert f'"digest":"{digest_of}"' in pathlib.Path("again/good/points.jsonl").read_text()


def test_printed_commands_have_the_time_limit(data):
    write(data, "")
    failed = expect(3, "*", "verify good --output timed --time-limit 1e-9")
    assert failed.count(r"^ +pulloff explain good .*--time-limit 1e-09 --output timed$")
    assert load("timed/good/record.json")["command"] == "pulloff run good --time-limit 1e-09"
    told = expect(3, "*", "explain good --output timed --time-limit 1e-9")
    assert told.count(r"^  rerun +pulloff solve .* --time-limit 1e-09")
    told = expect(0, "*", "explain good --output done --all")
    assert told.count(r"^  rerun +pulloff verify good --fresh --output done$") == 1


def test_the_table_of_pull_offs():
    words = "follow --key tabor --from 1 --to 2 --points 4 --curve "
    printed = run(words + "-")
    rows = printed.out.splitlines()
    assert printed.code == 0
    assert "tabor,force,force_error,approach,approach_error,contact_radius,contact_radius_error,followed" in rows
    assert printed.count(r"^[0-9]") == 4
    assert expect(0, "", words + "file.csv").count("^work ")
    assert pathlib.Path("file.csv").read_text() == printed.out
    failed = expect(4, "pulloff: nowhere/a.csv cannot be written: *",
                    "follow --key tabor --from 1 --to 2 --points 2 --curve nowhere/a.csv")
    assert failed.count("^work "), "the result is printed although the file is not written"
    expect(3, "pulloff: the solve at tabor * failed: after 1e-06 s of processor time *",
           "follow --key tabor --from 3 --to 4 --points 2 --amplitude 1 --wavelength 20 --time-limit 1e-6")


@pytest.mark.parametrize("series", [
    "radius-m --from 1e-7 --to 3e-7 --amplitude-m 1e-10 --wavelength-m 6e-9",
    "wavelength-m --from 4e-9 --to 6e-9 --amplitude-ratio 0.03 --radius-m 1e-7",
    "amplitude-m --from 1e-10 --to 2e-10 --wavelength-m 6e-9 --radius-m 1e-7",
    "power-c --from 4e6 --to 8e6 --profile power --power-n 2"])
def test_si_units_scene_by_scene(series):
    more = " --preload-m 2e-9 --tolerance 1e-5"
    points = document(f"follow --key {series} --points 3" + tip() + more)["points"]
    assert len(points) == 3
    for point in points:
        a = point["physical"]
        given = [word for key, value in a["input"].items() if key not in ("approach_start_m", "profile_approach_m")
                 for word in ("--" + key.replace("_", "-"), value)]
        b = document("solve --from-physical" + more, *given)["physical"]
        assert a["input"] == b["input"] and a["units"] == b["units"]
        for name, error in (("force_n", "error_estimate_n"), ("approach_m", "approach_error_estimate_m")):
            agree(a["pull_off"], b["pull_off"], name, error)
            assert 0 < a["pull_off"][error] < 1e-3 * abs(a["pull_off"][name])


@pytest.mark.parametrize("key", TIP)
def test_modulus_work_and_distance_vary_with_the_tip_at_one_end(key):
    value = TIP[key]
    points = document(f"follow --key {key} --from {value} --to {1.1 * float(value)!r} --points 2 --radius-m 1e-7" + tip(key))["points"]
    solved = document("solve --radius-m 1e-7" + tip())
    assert points[0]["pull_off"]["force"] == solved["pull_off"]["force"]
    assert points[1]["physical"]["pull_off"]["force_n"] != solved["physical"]["pull_off"]["force_n"]


def test_printed_si_units():
    ended = expect(0, "", "follow --key radius-m --from 1e-7 --to 3e-7 --points 3 --curve si.csv" + tip())
    table = pathlib.Path("si.csv").read_text().splitlines()
    assert "units    lengths in nm, loads and forces in nN" in ended.out.splitlines()
    assert any(line.startswith("# units: SI, at the end of the name of each column; ") for line in table)
    assert "radius_m,force_nN,force_error_nN,approach_nm,approach_error_nm,contact_radius_nm,contact_radius_error_nm,followed" in table
    points = document("follow --key radius-m --from 1e-7 --to 3e-7 --points 3" + tip())["points"]
    printed = [line.split() for line in ended.out.splitlines() if line[:1] == " "][1:]
    rows = [line.split(",") for line in table if line[0].isdigit()]
    assert len(printed) == len(rows) == 3
    for a, b, point in zip(printed, rows, points):
        assert a[0] == "%g" % float(b[0]) and a[1] == "%.10g" % float(b[1]) and a[3] == "%.10g" % float(b[3])
        assert abs(float(b[1]) / point["physical"]["pull_off"]["force_n"] / 1e9 - 1) < 1e-14
    ended = expect(0, "", "follow --of folds --key distance-m --from 3e-10 --to 4e-10 --points 2 --radius-m 1e-7" + tip("distance-m"))
    assert ended.count(r"^jump_in +3e-10 +-0[.][0-9]* .* -[0-9.]* ")
    assert "units    lengths in nm, loads and forces in nN" in ended.out.splitlines()


@pytest.mark.parametrize("varied, given, title, axis", [
    ("radius-m --from 1e-8 --to 3e-8", "", "radius varies from 10 to 30 nm; the first scene: R = 10 nm, w = 50 mJ/m², E* = 2 GPa, ε = 0.3 nm", "radius (nm)"),
    ("modulus-pa --from 4e8 --to 1e9", "--radius-m 1e-7", "modulus varies from 0.4 to 1 GPa; the first scene: *, E* = 400 MPa, *", "modulus (GPa)"),
    ("work-j-per-m2 --from 0.05 --to 0.02", "--radius-m 1e-7", "work varies from 50 to 20 mJ/m²; the first scene: *", "work (mJ/m²)"),
    ("unload-speed-m-per-s --from 1e-7 --to 2e-7", "--radius-m 1e-9 --viscoelastic sls:0.5 --relaxation-time-s 1e-3 --tolerance 1e-3",
     "unload speed varies from 100 to 200 nm/s; the first scene: *", "unload speed (nm/s)")])
def test_figure_in_si_units(varied, given, title, axis):
    """The names of the options stood on the axis and in the title, and their values without a unit."""
    expect(0, "", f"follow --key {varied} --points 2 {given} --plot figure.svg" + tip(varied.split()[0]))
    texts = [text.strip() for text in re.findall(">([^<]+)<", pathlib.Path("figure.svg").read_text())]
    assert any(fnmatch.fnmatchcase(text, title) for text in texts), texts
    assert axis in texts and any(re.fullmatch(r"pull-off force \([pn]N\)", text) for text in texts), texts


def test_one_warning_for_a_series_that_looks_like_metres():
    ended = run("follow --key radius --from 1e-3 --to 5e-3 --points 3")
    assert ended.err.count("warning: --radius is 0.001 epsilon, which looks like metres") == 1
