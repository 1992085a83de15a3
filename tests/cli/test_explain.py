"""pulloff explain prints what differs, where, which side is probably wrong, and a command that repeats the solve; and verify prints a
line a case, what does not pass with the command that explains it, and the totals."""

import os
import pty
import re
import subprocess

import pytest
from conftest import ROOT, edit, expect, run, seal, words_of

TABLE = "reference/table.csv"


def explained(code, *patterns, more=""):
    return expect(code, "*", f"explain good --output run {more}").has(*patterns)


@pytest.mark.parametrize("message, words", [
    ("explain needs the name of one case (see pulloff explain --help)", "explain"),
    ("--point is tabor=1: expected a number below 1, or words of a label such as scene", "explain good --point tabor=1")])
def test_wrong_usage(good, message, words):
    expect(2, "pulloff: " + message, words)
    assert not os.path.exists("run")


def test_checks_that_pass(good):
    explained(0, "^good pull_off_force scene: slack$", "^  fault      tolerance: .*: reduce it$")
    edit(good.file, "1e-9", "1e-12")
    explained(0, "^good: 0 of 1 check explained, the others are within$")
    explained(0, "^good pull_off_force scene: within$", more="--all")


def test_no_other_check_is_of_the_same_quantity(good):
    good.table(TABLE, "tabor,force,approach,force_uncertainty", "0,2.5,0,1e-10")
    said = explained(1, "^good pull_off_force scene: outside$", "^  obtained   2$", "^  expected   2.5$",
                     f"^  ledger     oracle: {TABLE}, with an uncertainty of 1e-10$",
                     r"^  difference -0.5, 5e\+08 times the tolerance of 1e-9 abs$", "^  where      approach .*, load -2, at minimum-1$",
                     "^  fault      program: .*no other reference covers this number", "^  tolerance  because it has a closed form$",
                     "^good: 1 of 1 check explained$")
    command = re.search("^  rerun      pulloff (.*)$", said.out, re.M)[1]
    assert command == "solve --tabor 0 --radius 100 --outer-radius inf --scheme triangle --grading uniform --nodes 101"
    expect(0, "", command).has("^pull-off force 2 ")


def test_a_published_value(good):
    """A check against a published value does not pass, but the check against an oracle does."""
    paper = good.table("reference/paper.csv", "tabor,force,approach", "0,1.9,0")
    edit(paper, "kind: oracle", "kind: published")
    seal(paper)
    good.file.write_text(good.file.read_text() + "  - {quantity: pull_off_force, reference: reference/paper.csv, tolerance: 1e-2, kind: abs, "
                         "because: read off a plot}\n")
    explained(1, f"^  fault      publication: {TABLE} .oracle. agrees with the result")


def test_a_reference_that_was_altered(good, monkeypatch):
    """After the result had been accepted."""
    monkeypatch.setenv("USER", "tester")
    expect(0, "*", "bless good --reason 'the first' --output run")
    good.table(TABLE, "tabor,force,approach", "0,2.1,0")
    explained(1, "^good pull_off_force scene: outside$",
              f"^  fault      reference: the result is the stored one to the last bit, .* see git log -- {TABLE}$")


def test_a_curve(good):
    """The place, the special points on both sides, and the JSON document."""
    edit(good.file, "pull_off_force", "curve", "1e-9", "1e-7", TABLE, "bradley", "  tabor: 0\n", "",
         "want", "sweep: [{key: tabor, values: [0, 0.01]}]\nwant")
    document = explained(1, more="--point tabor=0.01 --json").json
    assert (document["schema"], document["case"], document["verdict"], document["failed"]) == ("pulloff-explain/1", "good", "outside", [])
    [check] = document["checks"]
    wanted = {"point": "1", "label": "tabor=0.01", "quantity": "curve", "ledger": "oracle", "verdict": "outside", "passes": False,
              "fault": "program", "because": "it has a closed form", "reference": "bradley"}
    assert check | wanted == check
    assert check["error"] > 1e-7 and check["ratio"] == pytest.approx(check["error"] / 1e-7, rel=1e-12)
    assert check["where"]["special_points"] == "after minimum-1" and check["where"]["approach"] > 0
    assert check["command"].startswith("pulloff solve --tabor 0.01 ") and check["command"].endswith(" --curve curve.csv")
    explained(1, "^good: 1 of 1 check explained$", more="--point 0")


def test_a_solve_that_failed(good):
    edit(good.file, "nodes: 101", "nodes: 101\n  approach_end: 5")
    explained(3, "^good pull_off_force scene: no_result$", "^  fault      solve: ", "^good solve scene: failed$", "^  reason     approach_end is 5")


def overview(code, *lines, words=""):
    """The lines that verify prints after the head; patterns of whole lines."""
    said = expect(code, "*", f"verify {words}")
    shown = said.out.splitlines()[1:]
    assert len(shown) == len(lines) and all(re.fullmatch(line, text) for line, text in zip(lines, shown)), said.out
    return said


def row(numbers, worst):
    """The line of the case: its counts, the time, and the worst check."""
    return f"good +{numbers} +[0-9.]+ +{worst}"


def test_overview_of_what_passes(good):
    """The rigid sphere to the last bits: the tolerance says nothing, which passes and is shown."""
    overview(0, row("1 +0 +0", r"0\.000  pull_off_force, scene; 1 slack"), r"1 check passes \(1 slack\), 0 do not, 0 solves failed")
    good.table(TABLE, "tabor,force,approach", "0,2.0000000005,0")
    said = overview(0, row("1 +0 +0", r"0\.500  pull_off_force, scene"), "1 check passes, 0 do not, 0 solves failed")
    said.has(r"^case +pass +fail +unsolved +seconds +\|err\|/tol +of the worst check$")
    expect(0, "*", "verify --verbose").has("^good +pull_off_force +scene .* within$")


def test_overview_of_what_fails(good):
    """What, where, how far off, and a command that explains it, also with another folder for the records."""
    good.table(TABLE, "tabor,force,approach", "0,2.000000003,0")
    said = overview(1, row("0 +1 +0", r"3\.000  pull_off_force, scene"),
                    rf"good pull_off_force, scene: outside, 3 times the tolerance \({TABLE}\)",
                    "    pulloff explain good --point 0 --output 'a folder'", r"0 checks pass, 1 does not \(1 outside\), 0 solves failed",
                    words="--output 'a folder'")
    run(said.out.splitlines()[3].strip().removeprefix("pulloff ")).has("^good pull_off_force scene: outside$")


def test_overview_of_several_results(good):
    """Of several results of a check the worst is shown. One without a number is worse than any other."""
    good.file.write_text(good.file.read_text().replace("  radius: 100\n", "") + "sweep: [{key: radius, values: [100, 200, 300]}]\n")
    rows = ["radius,force,approach", "100,2.000000003,0", "200,2.000000005,0"]
    good.table(TABLE, *rows, "300,2,0")
    worst = "{} results of this check do not pass, this is the worst"
    overview(1, row("1 +2 +0", ".*"), rf"good pull_off_force, radius=200: outside, 5 times the tolerance \({TABLE}\); " + worst.format(2),
             "    pulloff explain good --point 1", ".*")
    good.table(TABLE, *rows)
    expect(1, "*", "verify").has(rf"^good pull_off_force, radius=300: missing_reference \({TABLE}\): the reference does not contain this scene; "
                                 "nearest is line 13: radius 200 instead of 300; " + worst.format(3) + "$")


def test_overview_of_solves_that_failed(good):
    """The first, and its command."""
    edit(good.file, "triangle", "panel", "nodes: 101", "tolerance: 1e-6", "tabor: 0", "tabor: 1", "1e-9", "1e-4",
         "want", "sweep: [{key: time_limit, values: [1e-9, 2e-9, 3600]}]\nwant")
    good.table(TABLE, "tabor,force,approach", "1,1.670664777,0")
    said = expect(3, "*", "verify").has("^good +1 +2 +2 ", "^good solve, time_limit=1e-9: failed: after 1e-09 s .*; 2 solves failed, this is the first$")
    assert said.count("^    pulloff explain good --point 0$") == 2


@pytest.mark.parametrize("words, lines", [("verify --fresh", 0), ("verify --fresh --verbose", 1)])
def test_on_a_terminal(good, words, lines):
    """The overview is all that stays; with --verbose the line of each case stays, too."""
    master, slave = pty.openpty()
    with subprocess.Popen(words_of(words), stdin=subprocess.DEVNULL, stdout=slave, stderr=slave) as process:
        os.close(slave)
        received = b""
        while True:
            try:
                received += os.read(master, 4096)
            except OSError:  # the program has ended
                break
    text = received.decode().replace("\r\n", "\n")
    shown = [line.rsplit("\r", 1)[-1] for line in text.split("\n")]
    assert sum("good: 1 point" in line for line in shown) == lines and "0/1 solve" in text and process.returncode == 0


def test_the_overview_of_the_paper_fits_a_screen(monkeypatch):
    """Of 40 lines: a line of ./reproduce before it, a head, the cases, the totals, and a line of ./reproduce after it. The list has a
    head, too."""
    monkeypatch.setenv("PULLOFF_DATA", str(ROOT))
    assert len(expect(0, "", "list --suite paper,precision,extreme").out.splitlines()) <= 37
