"""pulloff bless writes and renews the pins of a case. It needs a reason and refuses if a check against an oracle does not pass. Altered
pins are detected."""

import os
import pathlib
import re

import pytest
from conftest import edit, expect, run, seal


@pytest.fixture
def pinned(good, monkeypatch):
    """The good case, its pins, which are those of the first time, and an author."""
    for name, value in (("GIT_CONFIG_GLOBAL", "/dev/null"), ("GIT_CONFIG_SYSTEM", "/dev/null"), ("USER", "tester")):
        monkeypatch.setenv(name, value)
    bless("the first, of a closed form").has("^cases/pins/good.csv: 1 result, 1 new$")
    good.pins = good.folder / "cases/pins/good.csv"
    return good


def bless(reason="why", case="good"):
    return expect(0, "*", f"bless {case} --output run --reason", reason)


def refused(code, pattern, case="good"):
    """bless refuses after it has solved the case. Standard error also has a line of progress."""
    ended = run(f"bless {case} --reason why --output run")
    assert ended.code == code and re.search("^pulloff: " + pattern, ended.err, re.M), ended


@pytest.mark.parametrize("message, words", [
    ("bless needs --reason TEXT (see pulloff bless --help)", "bless good --output run"),
    ("the reason is empty: expected one line that states the reason", "bless good --reason ' '"),
    ("the reason is of several lines, *", "bless good --reason 'one\ntwo'"),
    ("bless needs the name of a case (see pulloff bless --help)", "bless --reason why"),
    ("no case is named best: expected one of good", "bless best --reason why")])
def test_wrong_arguments(good, message, words):
    expect(2, "pulloff: " + message, words)
    assert not os.path.exists("run")


def test_pins(pinned):
    """What does not change is not written again."""
    first = pinned.pins.read_text()
    assert re.search(r"^# accepted: 20\d\d-[01]\d-[0-3]\d, tester, pulloff [0-9.]*: the first, of a closed form$", first, re.M)
    assert re.search("^0,[0-9a-f]{16},2(,[0-9]+){5}$", first, re.M), "digest, force and five counters"
    bless("again").has("^cases/pins/good.csv: 1 result, 0 new; nothing is written$")
    assert pinned.pins.read_text() == first


def test_altered_pins(pinned):
    """An altered pin is detected by its checksum, or, if the checksum was corrected, by its value."""
    edit(pinned.pins, ",2,", ",2.1,")
    expect(4, "pulloff: cases/pins/good.csv:*: sha256 is *: expected *, the digest of all other lines*", "verify good")
    expect(4, "pulloff: cases/pins/good.csv:*: sha256 is *", "bless good --reason why")
    pinned.pins.write_text(re.sub("(?m)^# sha256.*\n", "", re.sub("(?m)^0,[^,]*", "0,0123456789abcdef", pinned.pins.read_text())))
    expect(4, "pulloff: cases/pins/good.csv:*: the header sha256 is missing", "verify good")
    seal(pinned.pins)
    bless("the paper rounds").has(
        "^good: 1 of 1 result is not the stored ones; the pull-off force of scene differs most, by 0.048 of 2.1: table can judge it$")
    assert re.findall("(?m)^# accepted.*: (.*)$", pinned.pins.read_text()) == ["the paper rounds"], "the last reason alone"


def test_checks_that_do_not_pass(pinned):
    """A check against an oracle that does not pass is a reason to refuse, but not one against a published value."""
    first, table = pinned.pins.read_text(), pinned.folder / "reference/table.csv"
    pinned.table("reference/table.csv", "tabor,force,approach", "7,2.1,0")
    refused(1, "good is not blessed: pull_off_force/table/scene is missing_reference ")
    pinned.table("reference/table.csv", "tabor,force,approach", "0,2.1,0")
    refused(1, r"good is not blessed: pull_off_force/table/scene is outside \(see pulloff explain good\)$")
    edit(table, "# kind: oracle", "# kind: published")
    seal(table)
    bless()
    assert pinned.pins.read_text() == first


def test_solves_that_fail(pinned):
    """Nor does bless accept a solve that failed, unless the stated fraction of solves may fail; the table has no numbers of it."""
    first, case = pinned.pins.read_text(), pinned.file.read_text()
    edit(pinned.file, "radius: 100", "radius: 100\n  approach_end: 5")
    refused(3, "good is not blessed: the solve of scene failed: ")
    assert pinned.pins.read_text() == first
    pinned.file.write_text(case)
    edit(pinned.file, "want", "sweep: [{key: approach_end, values: [0.1, 0.2, 5]}]\nwant", "pull_off_force", "solved_share",
         "reference/table.csv", "every_scene", "1e-9", "0.6", "closed form", "closed form\n    when: [{key: approach_end, values: [0.2, 5]}]")
    bless("one of two may fail")
    assert re.search("^2,[0-9a-f]{16},-,-,-,-,-,-$", pinned.pins.read_text(), re.M)
    expect(0, "*", "verify good --output run --identical").has("^3 of 3 results are identical")
    edit(pinned.file, "0.6", "0.4")
    refused(3, "good is not blessed: the solve of approach_end=5 failed: ")


def test_pins_beside_a_case(pinned, monkeypatch):
    """The pins of a case are in the folder of the case file. The author is user.name of git, for which a program stands here: a machine
    need not have git. A file in place of the folder is an error."""
    for folder in "my", "bin":
        os.mkdir(folder)
    pathlib.Path("my/own.yaml").write_text(pinned.file.read_text().replace("name: good", "name: own"))
    pathlib.Path("bin/git").write_text('#!/bin/sh\n[ "$*" = "config user.name" ] && echo "A. Smith"\n')
    os.chmod("bin/git", 0o755)
    monkeypatch.setenv("PATH", os.path.abspath("bin") + ":" + os.environ["PATH"])
    bless("mine", "my/own.yaml")
    assert re.search("^# accepted: .*, A. Smith, ", pathlib.Path("my/pins/own.csv").read_text(), re.M)
    os.remove("my/pins/own.csv")
    os.rmdir("my/pins")
    pathlib.Path("my/pins").write_text("")
    refused(4, "the folder my/pins cannot be created: ", "my/own.yaml")
