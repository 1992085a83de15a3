"""Random scenes: the summary counts the failures, its commands repeat the points to the last bit, and a stated fraction of solves
may fail."""

import pathlib
import re

from conftest import expect, load, run

CASE = """
name: scenes
title: Spheres at random, every other one without the time to solve it
suites: [random]
scene: {{outer_radius: inf, scheme: panel, tolerance: 1e-4}}
sample:
  seed: 20200908
  count: 3
  keys:
    - {{key: tabor, from: 0.1, to: 1, scale: log}}
    - {{key: radius, from: 30, to: 500, scale: log}}
    - {{key: wavelength, from: 3, to: 6, times: root_radius}}
    - {{key: amplitude, from: 0, to: 0.1, times: wavelength}}
sweep: [{{key: time_limit, values: [3600, 1e-9]}}]
want: [pull_off]
checks:
  - {{quantity: solved_share, reference: every_scene, tolerance: {}, kind: abs, because: it is made so}}
"""
RECORD = "build/run/scenes/record.json"


def command_after(lines, start):
    """The words of the command below the first line with this start, and the rest of that line."""
    place = next(k for k, line in enumerate(lines) if line.startswith(start))
    return lines[place + 1].strip().removeprefix("pulloff "), lines[place].removeprefix(start)


def test_random_scenes(data):
    data.case("scenes", CASE.format(0.6))
    expect(2, "pulloff: there is no such case in *", "run")
    summary = expect(0, "*scenes: 6 points, 1 check: within", "run --suite random --jobs 0")
    for line in ("^scenes: 6 of 6 points$", "^ok +3$", "^out_of_time +3$",
                 *(f"^{what} +[0-9.e-]+ +[0-9.e+-]+ +[0-9.e+-]+$" for what in ("seconds", "points", "nodes"))):
        assert summary.count(line), line
    assert summary.count("^point [135], out_of_time: after 1e-09 s of processor time the trace has no point yet") == 3
    planned = expect(0, "", "plan scenes").out.splitlines()
    assert "  compare solved_share with every_scene at 6 of 6 points, tolerance 0.6 abs" in planned
    assert '"point": null' in pathlib.Path(RECORD).read_text(), "the check belongs to no single point"

    # The command after a failure repeats it, with the same reason and the exit code of a failed solve.
    lines = summary.out.splitlines()
    command, reason = command_after(lines, "point 3, out_of_time: ")
    expect(3, "pulloff: the solve failed: " + reason, command)
    # The command of a solved point repeats every number to the last bit. Only the slowest points have a command.
    solved = re.search(r"^point (\d+), ok, ", summary.out, re.M)[1]
    again = expect(0, "", command_after(lines, f"point {solved}, ok, ")[0] + " --json").json
    point = load(RECORD)["points"][int(solved)]
    # The command contains the default preload, so that the solve does not continue beyond it.
    assert again["input"].pop("preload_load") == 1 and point["input"].pop("preload_load") is None
    for key in "input", "status", "pull_off", "folds", "extrema":
        assert again[key] == point[key], key
    del again["work"]["seconds"], point["work"]["seconds"]
    assert again["work"] == point["work"]
    assert point["sweep"].keys() == {"time_limit", "tabor", "radius", "wavelength", "amplitude"}

    # TAP and JUnit have the fraction, not the failures that it allows; it belongs to no single point.
    assert expect(0, "scenes: 6 points, 1 check: within (kept)", "verify scenes --tap").out.splitlines()[1] == "1..1"
    expect(0, "*", "verify scenes --junit out.xml")
    assert '<testsuite name="scenes" tests="1" failures="0"' in pathlib.Path("out.xml").read_text()
    assert expect(0, "*", "explain scenes").out == "scenes: 0 of 1 check explained, the others are within\n"
    assert expect(0, "*", "explain scenes --all").count("^scenes solved_share -: within$")
    assert expect(0, "*", "verify --verbose scenes").count("^scenes +solved_share +- +0.5 +1 ")

    # Too many solves failed.
    data.case("scenes", CASE.format(0.4))
    verified = expect(3, "scenes: 6 points, 1 check: failed (kept)", "verify --verbose scenes")
    assert verified.count("outside: 3 of 6 points failed, first point 1: after 1e-09 s")
    told = expect(3, "*", "explain scenes --json").json
    (c,) = told["checks"]
    assert (c["id"], c["point"], c["label"], c["fault"]) == ("solved_share/every_scene", None, None, "solve")
    assert [f["point"] for f in told["failed"]] == ["1", "3", "5"]
    assert c["command"] == told["failed"][0]["command"] and " --time-limit 1e-09" in c["command"]
    assert expect(3, "*", "explain scenes --point 3").count("^scenes: 0 of 0 checks explained$"), "only its failure"
    expect(0, "*", "explain scenes --point 0")
    assert expect(3, "*", "verify --verbose scenes").count("time_limit=1e-9 .*failed: after") == 3, "now they count"
    assert run("run scenes").code == 3
    assert expect(0, "*", "run scenes --time-limit 3600").count("^none failed$"), "the limit of the command line applies"
    expect(0, "*(kept)", "explain scenes --time-limit 3600 --all")
