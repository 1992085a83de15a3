"""Points are solved again if their scenes change, results compared again if checks or references change, and nothing is done if nothing
changed. Each point is kept as soon as it is solved, also if the case is run in parts on one or several machines. The campaigns `altered`
and `killed` of tests/robust/store.py alter stores and interrupt runs at random."""

import os
import pathlib
import shutil

import pytest
from conftest import edit, expect, load, run
from test_interrupt import PARTS, without_times

RECORD, STORE, CURVE = "run/good/record.json", "run/good/points.jsonl", "run/good/curve-0.csv"
KEPT = "good: 1 point, 1 check: within (kept)"
REWRITTEN = "good: the record or a table beside it was altered or damaged; the stored results are intact, and it is written again"


def read(path):
    return pathlib.Path(path).read_bytes()


def solve_again():
    expect(0, "good: 1 point, 1 check: within", "run --output run")


def rewritten():
    """The record and the tables beside it are written again from the store, whatever was altered."""
    assert run("run --output run").err.splitlines() == [REWRITTEN, KEPT]


def test_nothing_is_done_if_nothing_changed(good):
    solve_again()
    first = read(RECORD)
    expect(0, KEPT, "run --output run")
    assert read(RECORD) == first
    expect(0, "good: 1 point, 1 check: within", "run --output run --fresh")
    edit(good.file, "want", "repeats: 3\nwant")
    solve_again()
    assert len(load(RECORD)["points"][0]["seconds_all"]) == 3
    ended = expect(0, "*kept*", "verify good --output run --junit out.xml")
    assert '<testsuite name="good" tests="1" failures="0"' in pathlib.Path("out.xml").read_text() and ended.out


def test_altered_results(good):
    """A stored force that was altered used to be compared, and pinned. Now the point is solved again, and bless refuses."""
    solve_again()
    first = without_times(RECORD)
    edit(STORE, '"force":2.0', '"force":2.1')
    assert run("run --output run").err.splitlines() == ["good: 1 stored result was altered or damaged and is solved again",
                                                        "good: 1 point, 1 check: within"]
    assert without_times(RECORD) == first and read(STORE).count(b"\n") == 1
    edit(STORE, '"points":', '"points":1')
    ended = run("bless good --output run --reason none")
    assert ended.code == 1 and "pulloff: good is not blessed: 1 stored result was altered or damaged; " in ended.err
    assert not (good.folder / "cases/pins").exists(), "an altered counter is not pinned"
    edit(RECORD, '"verdict": "within"', '"verdict": "outside"')
    rewritten()
    assert b'"outside"' not in read(RECORD)


def test_results_are_compared_again(good):
    solve_again()
    edit(good.file, "1e-9", "1e-8")
    expect(0, KEPT, "run --output run")
    assert load(RECORD)["checks"][0]["tolerance"] == 1e-8
    good.table("reference/table.csv", "tabor,force,approach", "0,2.5,0")
    expect(0, "good: 1 point, 1 check: outside (kept)", "run --output run")
    assert load(RECORD)["checks"][0]["expected"] == 2.5 and load(RECORD)["verdict"] == "outside"
    good.table("reference/table.csv", "tabor,force,approach", "0,2,0")
    edit(good.file, "nodes: 101", "nodes: 101\n  approach_end: 0.1")
    solve_again()


def test_tables_beside_a_record(good):
    solve_again()
    edit(good.file, "[pull_off]", "[pull_off, curve, profile]")
    solve_again()
    curve = read(CURVE)
    assert read("run/good/profile-0.csv")
    os.remove(CURVE)
    rewritten()
    edit(CURVE, curve.splitlines()[-1].decode(), "0,7,7,7,7,7,7,7,7")
    rewritten()
    assert read(CURVE) == curve


PART = "parts: {} points, 0 checks: within"


def store_of(output):
    return pathlib.Path(output, "parts/points.jsonl")


@pytest.fixture
def parts(data):
    data.case("parts", PARTS.format("parts", 81))
    expect(0, PART.format("6"), "run --output whole")
    expect(0, PART.format("3 of 6"), "run --output run --points 0-2")
    return data


def test_parts_of_a_case(parts):
    assert len(read(store_of("whole")).splitlines()) == 6 and not os.path.exists("run/parts/record.json")
    expect(0, PART.format("3 of 6") + " (3 points kept)", "run --output run --points 0-2")
    assert len(read(store_of("run")).splitlines()) == 3, "no point is solved twice"
    expect(0, "parts: 1 of 6 points, 0 checks: within", "run --output run --points 2 --fresh")
    assert len(read(store_of("run")).splitlines()) == 4
    # Two machines: their stores are combined. Which points come first does not matter.
    expect(0, PART.format("3 of 6"), "run --output two --points 3-99")
    store_of("run").write_bytes(read(store_of("run")) + read(store_of("two")))
    expect(0, PART.format("6") + " (kept)", "run --output run")
    assert without_times("run/parts/record.json") == without_times("whole/parts/record.json")
    assert len(read(store_of("run")).splitlines()) == 6, "superseded lines are removed"
    assert read("run/parts/curve-3.csv") == read("whole/parts/curve-3.csv")


def test_a_point_is_found_by_its_key(parts):
    """Scenes can be added anywhere. If the mesh changes, no point is kept."""
    shutil.copytree("run", "mesh")
    parts.case("parts", PARTS.format("parts", 81).replace("count: 6", "count: 8"))
    expect(0, PART.format("8") + " (3 points kept)", "run --output run")
    parts.case("parts", PARTS.format("parts", 91))
    expect(0, PART.format("6"), "run --output mesh")
    swept = parts.case("swept", """
name: swept
title: A sphere on meshes
suites: [smoke]
scene: {tabor: 0, radius: 93, outer_radius: inf, scheme: ring}
sweep: [{key: nodes, values: [63, 83]}]
want: [pull_off, profile]
""")
    expect(0, "swept: 2 points, 0 checks: within", "run swept --output refined")
    before = read("refined/swept/profile-1.csv")
    edit(swept, "63, 83", "57, 63, 71, 83")
    expect(0, "swept: 4 points, 0 checks: within (2 points kept)", "run swept --output refined")
    assert read("refined/swept/profile-3.csv") == before
