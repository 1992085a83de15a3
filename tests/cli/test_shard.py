"""Shards of a run: merged, they equal a single run to the last bit. Shards that do not belong together are refused, and the message names
them. The campaign `merged` of tests/robust/store.py merges shards at random."""

import os
import pathlib
import re
import shutil
import sys

import conftest
import pytest
from conftest import ROOT, edit, expect, load, run
from test_interrupt import PARTS, without_times

sys.path.insert(0, str(ROOT / "tests"))
import checksum  # noqa: E402

DRAWN = PARTS.format("drawn", 81).replace("count: 6", "count: 7") + """checks:
  - {quantity: solved_share, reference: every_scene, tolerance: 0.01, kind: abs, because: all have}
"""
RINGS = """
name: {}
title: One rigid sphere, on meshes
suites: [smoke]
scene: {{tabor: 0, radius: 93, outer_radius: inf, scheme: ring}}
sweep: [{{key: nodes, values: [63, 71, 83, 97, 101]}}]
want: [pull_off, profile]
{}
"""
FOLLOWED = """
name: followed
title: Lines that are followed
suites: [smoke]
scene: {radius: 93, outer_radius: 80, scheme: panel, tolerance: 1e-4, wavelength: 21}
sweep:
  - {key: amplitude_ratio, values: [0.01, 0.015, 0.02]}
  - {key: tabor, from: 0.5, to: 0.7, count: 4, scale: log}
follow: tabor
checkpoint_every: 3
want: [pull_off]
"""
MERGE = "merge part-1 {} part-3"
ONE, TWO = "part-1/shard-1-of-3.json", "shard-2-of-3.json"


@pytest.fixture
def shards(data):
    """The shards are of three processors, as far as OpenBLAS can tell."""
    data.case("drawn", DRAWN)
    data.case("rigid", RINGS.format("rigid", "checks: [{quantity: pull_off_force, reference: bradley, tolerance: 1e-3, kind: abs, "
                                    "because: the closed form}]"))
    data.case("timed", RINGS.format("timed", "repeats: 2"))
    data.case("followed", FOLLOWED)
    for k, kind in enumerate(("Prescott", "Nehalem", None), 1):
        environment = os.environ | ({"OPENBLAS_CORETYPE": kind} if kind else {})
        expect(0, None, f"run --output part-{k} --shard {k}/3 --jobs {k}", env=environment)
    return data


def record_of(folder, name="drawn"):
    return [line for line in without_times(f"{folder}/{name}/record.json") if '"openblas"' not in line]


@pytest.mark.parametrize("code, message, words", [
    *((2, f"--shard is {shard}: expected K/N*", f"run --shard {shard}") for shard in ("0/3", "4/3", "2", "1/", "1/2/3")),
    (2, "--points and --shard are given: expected one of them", "run --shard 1/2 --points 0"),
    (2, "merge needs the folders of the shards (see pulloff merge --help)", "merge"),
    (4, "the folder empty contains no shard: expected *", "merge empty"), (4, "the folder absent cannot be read: *", "merge absent")])
def test_messages(data, code, message, words):
    os.mkdir("empty")
    expect(code, "pulloff: " + message, words)


def test_shards_are_the_whole(shards):
    expect(0, None, "run --output whole")
    assert not os.path.exists("part-1/drawn/record.json") and not os.path.exists("part-2/drawn/record.json")
    said = expect(0, None, "merge --output merged part-3 part-1 part-2").err
    assert len(re.findall("within$", said, re.M)) == 4
    for name in "drawn", "rigid", "timed", "followed":
        assert record_of("merged", name) == record_of("whole", name)
    for table in "drawn/curve-0.csv", "drawn/curve-6.csv", "rigid/profile-3.csv":
        assert pathlib.Path("merged", table).read_bytes() == pathlib.Path("whole", table).read_bytes()
    expect(0, "drawn: 7 points, 1 check: within (kept)", "run drawn --output merged")
    expect(0, None, "merge --output part-1 part-1 part-2 part-3")
    expect(0, None, "merge --output again part-1 part-2 part-3")
    assert record_of("again") == record_of("whole"), "the folder of a shard that became the complete run can be merged again"


def write_shard(folder, *changes, sealed=True):
    """A shard with another description, and the checksum of that."""
    os.makedirs(folder, exist_ok=True)
    shutil.copy(f"part-2/{TWO}", folder)
    edit(f"{folder}/{TWO}", *changes)
    if sealed:
        checksum.write(f"{folder}/{TWO}", load(f"{folder}/{TWO}"))


def test_shards_that_lack_or_are_damaged(shards):
    lacking = "expected all 3 shards, each finished; missing or not finished: {}"
    expect(4, "pulloff: * of 7 points of drawn are lacking: " + lacking.format("2/3"), "merge part-1 part-3")
    expect(4, "pulloff: *; missing or not finished: 1/3, 3/3", "merge part-2")
    shutil.copytree("part-2", "twin")
    expect(0, None, "merge --output twins part-1 part-2 part-3 twin")
    store = pathlib.Path("twin/drawn/points.jsonl")
    store.write_text("".join(store.read_text().splitlines(True)[1:]))
    expect(4, "pulloff: 1 of 7 points of drawn is lacking: " + lacking.format("2/3"), MERGE.format("twin"))
    store.write_text(store.read_text().replace("1", "2", 1))
    expect(4, "pulloff: 2 of 7 points of drawn are lacking, and stored results were altered or damaged: *: 2/3", MERGE.format("twin"))
    expect(0, None, "run --output twin --shard 2/3")
    expect(0, None, MERGE.format("twin") + " --output mended")
    assert record_of("mended") == record_of("twins"), "an interrupted shard continues"
    # A file with a wrong number of shards used to keep the program busy for ever.
    write_shard("lies", '"of": 3', '"of": 9000000000000000000')
    expect(4, "pulloff: 7 of 7 points of drawn are lacking: expected all 9000000000000000000 shards, *", "merge lies")
    write_shard("lies", '"shard": 2', '"shard": 0')
    expect(4, f"pulloff: lies/{TWO} is damaged: *", "merge lies")
    write_shard("lies", '"time_limit": null', '"time_limit": 1', sealed=False)
    expect(4, f"pulloff: lies/{TWO} was altered: it does not have its checksum", "merge lies")


def test_shards_of_other_runs(shards, monkeypatch):
    """Of another program, other cases, other scenes, another number or another time limit."""
    program = conftest.PROGRAM
    pathlib.Path("other-program").write_bytes(pathlib.Path(program).read_bytes() + b"x")  # the same numbers, but who knows
    os.chmod("other-program", 0o755)
    with monkeypatch.context() as other:
        other.setattr(conftest, "PROGRAM", os.path.abspath("other-program"))
        expect(0, None, "run --output other --shard 2/3")
        expect(2, f"pulloff: {ONE} is of a run with another program than this one: expected shards of one run", MERGE.format("part-2"))
    for words, folder, what in (("", "other", f"{TWO} is of a run with another program"),
                                ("run drawn --shard 1/2", "shared", "shard-1-of-2.json is of a run with another number of shards"),
                                ("run drawn rigid --shard 2/3", "less", "* is of a run with other cases, or other scenes, at case rigid"),
                                ("run --shard 2/3 --time-limit 600", "late", f"{TWO} is of a run with another time limit")):
        if words:
            expect(0, None, f"{words} --output {folder}")
        expect(2, f"pulloff: {folder}/{what} than {ONE}: *", MERGE.format(folder))
    for k in 1, 3:
        expect(0, None, f"run --output late --shard {k}/3 --time-limit 600")
    expect(0, None, "merge --output limited late")
    assert "--time-limit 600" in pathlib.Path("limited/drawn/record.json").read_text()
    shards.case("drawn", DRAWN.replace("nodes: 81", "nodes: 91"))
    expect(2, f"pulloff: {ONE} is of a run with other cases, or other scenes, at case drawn than this one: *", MERGE.format("part-2"))
    (shards.folder / "cases/drawn.yaml").unlink()
    expect(2, "pulloff: no case is named drawn: *", MERGE.format("part-2"))


def test_a_solve_that_fails_in_a_shard(data):
    data.case("timed", RINGS.format("timed", "repeats: 2").replace("ring}", "ring, time_limit: 1e-9}"))
    assert run("run timed --output failed --shard 1/1").code == run("merge --output failures failed").code == 3
