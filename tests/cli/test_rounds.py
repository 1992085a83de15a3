"""Timed solvers: rounds that alternate with this program, the times of each round, all values of a knob."""

import json
import os
import pathlib
import re
import shutil
import signal
import statistics
import subprocess
import time

import pytest
from conftest import ROOT, expect, words_of
from solvers import SCENE, manifest, record

KNOB = "knob: {name: nodes, values: [10, 20]}"
TIMES = "process_seconds", "process_processor_seconds", "start_seconds", "start_processor_seconds"


def timed(mode, *more, **options):
    return manifest(mode, *more, scene=SCENE % 1, time_limit=60, **options)


@pytest.fixture(autouse=True)
def _case(monkeypatch):
    monkeypatch.setenv("PULLOFF_DATA", str(ROOT))
    pathlib.Path("timed.yaml").write_text("""name: timed
title: Smooth spheres
suites: [own]
scene: {radius: 100, outer_radius: inf, approach_end: -1}
sweep:
  - {key: tabor, values: [0.5, 1, 3]}
  - together: [{scheme: triangle, nodes: 31}, {scheme: panel, tolerance: 1e-3}]
repeats: 3
want: [pull_off]
measure:
  - {quantity: pull_off_force, reference: reference/feng_pull_off.csv}
""")
    timed("good", KNOB)


def run(words):
    return expect(0, None, f"run timed.yaml {words}").err


def check_times(point, count):
    """The processor time of a solve is that of the process without its start, divided among the solves."""
    timing = point["timing"]
    for cpu, whole, start in zip(point["processor_seconds_all"], timing["process_processor_seconds"], timing["start_processor_seconds"]):
        assert abs(cpu - max(whole - start, 0) / count) < 1e-12, point


def check_solver(made):
    assert [point["status"] for point in made["points"]] == 4 * ["ok"] + 2 * ["unsupported"] and len(made["measured"]) == 4
    # two questions, because pairs of points differ only in the mesh of pulloff, and three rounds of each
    assert [p["asked"] for p in made["solver"]["processes"]] == 6 * [1]
    for point in made["points"][:4]:
        timing = point["timing"]
        assert timing["interleaved"] is True and point["seconds_all"] == timing["first_seconds"] == 3 * [1e-3], point
        assert point["work"]["seconds"] == statistics.median(point["seconds_all"])
        assert all(len(timing[key]) == 3 and min(timing[key]) > 0 for key in TIMES), timing
        check_times(point, 2)
        assert made["solver"]["name"] != "slow_clock" or min(timing["process_seconds"]) > 2, timing
    assert made["points"][0]["timing"] == made["points"][1]["timing"]
    assert made["points"][5]["timing"]["process_seconds"] == 3 * [None]


def test_the_times_of_the_rounds():
    timed("slow_clock")
    run("--solver pulloff --solver good.yaml --solver slow_clock.yaml --knob all --output run --jobs 2")
    assert not any("timing" in point for point in record("run/timed/record.json")["points"])
    for name in "good@10", "good", "slow_clock":
        check_solver(record(f"run/solvers/{name}/timed/record.json"))
    assert "kept" in expect(0, None, "verify timed.yaml --solver slow_clock.yaml --output run").err
    # A run without this program, of a solver that fails.
    timed("slow_failure")
    expect(3, None, "run timed.yaml --solver slow_failure.yaml --output run")
    assert '"interleaved": false' in pathlib.Path("run/solvers/slow_failure/timed/record.json").read_text()


@pytest.mark.once
def test_a_long_solve_is_not_repeated():
    """The process is ended, and the time is that of the one solve."""
    timed("long")
    run("--points 0-1 --solver long.yaml --output run")
    point = json.loads(pathlib.Path("run/solvers/long/timed/points.jsonl").read_text().splitlines()[0])
    timing = point["timing"]
    assert point["status"] == "ok" and timing["first_seconds"] == point["seconds_all"] == 3 * [1e-3], point
    assert all(6.5 < seconds < 30 for seconds in timing["process_seconds"]), timing
    check_times(point, 1)
    assert not list(pathlib.Path("run/solvers/long").rglob("ask-*"))


def test_an_interrupted_run_keeps_what_took_long():
    """A point is stored after its last round, which for long solves is the first one, and not only at the end of all rounds."""
    timed("busy")
    words, store = "--points 0-3 --solver busy.yaml --output run", pathlib.Path("run/solvers/busy/timed/points.jsonl")
    with subprocess.Popen(words_of(f"run timed.yaml {words}"), stderr=subprocess.DEVNULL) as process:
        while process.poll() is None and not (store.exists() and store.stat().st_size):
            time.sleep(0.02)
        process.send_signal(signal.SIGKILL)
    said = run(words)
    # How many of the points that run side by side have ended by then depends on the machine.
    assert "busy:timed: 4 of 6 points, " in said and re.search(r"\([1-4] points? kept\)", said), said
    assert {len(point["seconds_all"]) for point in record("run/solvers/busy/timed/part.json")["points"][:4]} == {1}


def interleaved(name):
    return [point["timing"]["interleaved"] for point in record(f"mixed/solvers/good@10/timed/{name}.json")["points"][:4]]


def test_times_that_are_kept():
    """They were not taken in the rounds in which this program solves the points again. Nor were those of a whole record, which is written
    again with that."""
    both = "--solver pulloff --solver good.yaml@10 --output mixed"
    run("--points 0-3 " + both)
    assert interleaved("part") == 4 * [True]
    store = pathlib.Path("mixed/solvers/good@10/timed/points.jsonl")
    store.write_text("".join(store.read_text().splitlines(True)[:2]))
    os.remove("mixed/timed/points.jsonl")
    run("--points 0-3 " + both)
    assert interleaved("part") == [False, False, True, True]
    shutil.rmtree("mixed")
    run(both)
    assert interleaved("record") == 4 * [True]
    before = pathlib.Path("mixed/solvers/good@10/timed/record.json").read_bytes()
    run(both)
    assert pathlib.Path("mixed/solvers/good@10/timed/record.json").read_bytes() == before, "without new solves a record stays"
    shutil.rmtree("mixed/timed")
    assert "good@10:timed: 6 points, " in run(both) and interleaved("record") == 4 * [False]


def test_values_of_knobs_by_name():
    timed("part", KNOB, answers="good")
    run("--solver part.yaml@20 --solver part.yaml@10 --solver good.yaml@10 --output some")
    assert sorted(os.listdir("some/solvers")) == ["good@10", "part", "part@10"]


@pytest.mark.parametrize("code, message, words", [
    (2, "--solver names good twice: expected each solver once", "--solver good.yaml@20 --solver good.yaml"),
    (2, "--knob is 30: expected one of the values of the knob in the manifest", "--solver good.yaml@30"),
    (4, "absent.yaml cannot be opened: *", "--solver absent.yaml@30")])
def test_wrong_knobs(code, message, words):
    expect(code, "pulloff: " + message, f"run timed.yaml {words}")
