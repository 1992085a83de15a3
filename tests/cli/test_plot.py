"""Plots: as characters, and as figures by gnuplot in three formats."""

import html
import json
import math
import os
import pathlib
import re
import shutil

import conftest
import pytest
from conftest import ROOT, expect

FIGURES = pytest.mark.skipif(not shutil.which("gnuplot"), reason="gnuplot is not installed")
WAVY = "--tabor 3 --amplitude 1 --wavelength 20"


@pytest.fixture(autouse=True)
def _locale(monkeypatch):
    """In which gnuplot warns of characters, unless the program gives it another."""
    monkeypatch.setenv("LC_ALL", "C")


def drawn(file):
    """The bytes of an image of its kind with something in it."""
    content = pathlib.Path(file).read_bytes()
    if file.endswith(".svg"):
        assert b"</svg>" in content and content.count(b"<path") > 10
    else:
        assert content.startswith(b"\x89PNG" if file.endswith(".png") else b"%PDF-") and len(content) > 5000
    return content


def test_characters():
    plotted = expect(0, "", "plot --tabor 1").has(r"^ *equilibria \*\*\*\* *loading #### *unloading \$\$\$\$ *jump ---- *pull-off  X$")
    lines = plotted.out.splitlines()
    assert sum(line.count("X") for line in lines if "pull-off" not in line) == 1
    assert all(len(line) <= 80 for line in lines[1:]) and all(ord(c) >= 32 for line in lines for c in line)
    branch = expect(0, "", "plot --tabor 1 --want curve").has(r"^ *unstable \*\*\*\* *stable #### *fold  o *pull-off  X$")
    assert sum(line.count("o") for line in branch.out.splitlines() if "|" in line) >= 2
    expect(0, "", f"plot {WAVY} --stiffness 0.3").has("against position of the base in epsilon$", "against approach in epsilon$")
    assert expect(0, "", "plot --tabor 1 --want profile,preload").has("^ *traction in", "^ *pull-off force in").count("^ *load in") == 0
    expect(0, "", "plot --tabor 0.5 --profile cone:0.5 --preload inf").has("^ *load in pi w epsilon against")


@FIGURES
def test_figures():
    for file in "a.svg", "a.png", "a.pdf":
        assert expect(0, "", f"plot {WAVY} {file}").out == ""
        drawn(file)
    assert f"pulloff solve {WAVY}" in pathlib.Path("a.svg").read_text(), "the caption is the command"
    expect(0, "", "plot --profile cone:0.5 --coupling 0.07 cone.svg")
    assert "pulloff solve --coupling 0.07 --outer-radius inf --profile cone" in pathlib.Path("cone.svg").read_text()
    expect(0, "", "solve --tabor 1 --want profile,hysteresis,preload --plot all.svg").has("^pull-off force 1.67066")
    assert all(words in pathlib.Path("all.svg").read_text() for words in (">approach Δ/ε<", ">radius <", "preload, largest"))
    expect(4, "pulloff: nowhere/a.svg cannot be written: *", "solve --tabor 1 --plot nowhere/a.svg").has("^pull-off force 1.67066")


@FIGURES
@pytest.mark.parametrize("words", ["", "--want hysteresis", "--stiffness 0.1", "--json"])
def test_the_result_does_not_depend_on_the_figure(words):
    """What a figure needs ended the search beyond the preload, and changed the steps of the trace: another result."""
    alone, beside = ([line for line in expect(0, "", f"solve --tabor 1.7 {words} {more}").out.splitlines()
                      if not re.search('^work|"seconds"', line)] for more in ("", "--plot beside.svg"))
    assert alone == beside
    drawn("beside.svg")


@FIGURES
def test_figures_in_si_units():
    tip = "--from-physical --modulus-pa 5e9 --work-j-per-m2 0.08 --distance-m 3e-10 --radius-m 3e-8"
    expect(0, "", f"plot {tip} --amplitude-m 4e-10 --wavelength-m 6e-9 --preload-load-n 2e-9 --stiffness-n-per-m 2 tip.svg")
    text = pathlib.Path("tip.svg").read_text()
    assert all(words in text for words in ("position of the base", "(nm)", "(nN)"))
    assert "R = 30 nm, w = 80 mJ/m², E* = 5 GPa, ε = 0.3 nm, A = 0.4 nm, λ = 6 nm, preload = 2 nN, spring = 2 N/m" in text
    expect(0, "", f"compare {tip} --plot theories.svg")
    assert all(name in pathlib.Path("theories.svg").read_text() for name in ("JKR", "DMT", "Maugis-Dugdale"))


@FIGURES
def test_a_run_of_the_paper(monkeypatch):
    monkeypatch.setenv("PULLOFF_DATA", str(ROOT))
    for more, file in (("fig04.svg", "fig04.svg"), ("--plot again.svg", "again.svg")):
        expect(0, "*", f"plot --case fig04 --run run {more}")
        drawn(file)
    expect(0, "*", "plot --case fig04 --run run").has("^ *pull-off force in pi w R against tabor$")
    assert not list(pathlib.Path().rglob("figure*"))
    os.mkdir("empty")
    monkeypatch.setattr(conftest, "PROGRAM", os.path.abspath(conftest.PROGRAM))
    monkeypatch.setenv("PATH", os.path.abspath("empty"))
    expect(4, "pulloff: gnuplot was not found: *", "plot --tabor 0 b.svg")


@pytest.mark.parametrize("message, words", [
    ("--plot is a.gif: expected the name of a file that ends in .svg, .png or .pdf", "solve --plot a.gif"),
    ("fig04 is no figure: expected *; a case is given by --case", "plot fig04"),
    ("--run is given without --case: expected both", "plot --run run"), ("unknown option --run of solve *", "solve --run run"),
    # These files were not written, and the exit code was 0.
    *((f"{option} has no effect on plot: *", f"plot --tabor 0 {words}") for option, words in (
        ("--json", "--json"), ("--curve", "--curve curve.csv"), ("--profile-csv", "--profile profile.csv"), ("--staircase", "--staircase steps.csv"))),
    ("b.svg is one file too many: *", "plot --tabor 0 --plot a.svg b.svg"),
    ("b.svg is one file too many: expected only one figure", "plot --tabor 1 a.svg b.svg"),
    ("theories is no panel of a plot: *", "plot --tabor 0 --want curve,theories"),
    ("options of a scene have no effect on a case: *", "plot --case fig04 --tabor 2")])
def test_messages(message, words):
    expect(2, "pulloff: " + message, words)


def write_map(data, count, title="A map"):
    """A map of two numbers; seven of one number and eight of the other are curves."""
    data.case("good", f"""
name: good
title: |-
  {title}
suites: [smoke]
scene: {{scheme: panel, tolerance: 1e-2, wavelength: 20, radius: 100, outer_radius: inf}}
sweep:
  - {{key: amplitude_ratio, from: 0.001, to: 0.03, count: {count}, scale: log}}
  - {{key: tabor, from: 0.2, to: 0.9, count: 8, scale: linear}}
follow: tabor
want: [pull_off]
checks:
  - {{quantity: solved_share, reference: every_scene, tolerance: 0.5, kind: abs, because: all have}}
""")
    if not (data.folder / "reports").exists():
        os.symlink(ROOT / "reports", data.folder / "reports")


def test_a_map(data):
    """Every cell has the shade of its force."""
    write_map(data, 8)
    text = expect(0, "*", "plot --case good --run map").has(
        r"^ *pull-off force in pi w R, \.:-=\+\*#%@ from [0-9.]* in steps of [0-9.]*$").out
    rows = ["".join(line.split("|")[1].split()) for line in text.splitlines() if line.count("|") == 2]
    rows = [row for row in rows if row]
    points = json.loads(pathlib.Path("map/good/record.json").read_text())["points"]
    assert len(points) == 64 and len(rows) == 8 and all(len(row) == 8 for row in rows), rows
    forces = [point["pull_off"]["force"] for point in points]
    for k, force in enumerate(forces):
        level = (force - min(forces)) / (max(forces) - min(forces)) * 9
        expected = {".:-=+*#%@"[min(8, max(0, math.floor(level + by)))] for by in (-1e-6, 1e-6)}
        assert rows[7 - k // 8][k % 8] in expected, points[k]["label"]
    assert len(set("".join(rows))) > 4


@FIGURES
def test_figures_of_a_map(data):
    write_map(data, 8)
    for file in "map.svg", "map.png", "map.pdf":
        expect(0, "*", f"plot --case good --run map {file}")
        drawn(file)
    text = pathlib.Path("map.svg").read_text()
    assert len(re.findall("fill = .rgb[(]", text)) >= 64
    # Boxes that overlap the axes did not count: all forces above those of the other cells had the brightest colour.
    assert text.count("fill = 'rgb(253, 231,  37)'") <= 2
    assert all(words in text for words in ("tabor", "amplitude_ratio", "pull-off force/πwR"))
    # gnuplot ended at an apostrophe, because it stood beside a backslash or in a name; a word behind @ was a macro.
    title = r"""it's a\'\''b "q" @x a @places `id` $y #z {/:Bold b}_c^d~e %d µm"""
    write_map(data, 8, title)
    expect(0, "*", "plot --case good --run map named.svg")
    assert title in html.unescape(pathlib.Path("named.svg").read_text())
    name = r"it's \ @x.csv"
    pathlib.Path(name).write_text("r,gap\n" + "".join(f"{3 * k},{0.045 * k * k}\n" for k in range(21)))
    expect(0, "", "plot --tabor 0 file.svg --profile-file", name)
    assert r"'it'\''s \ @x.csv'" in pathlib.Path("file.svg").read_text()


def test_cases_that_are_no_map(data, good):
    write_map(data, 7)
    expect(0, "*", "plot --case good --run curves").has("^ *pull-off force in pi w R against tabor$")
    good.case("good", good.file.read_text().partition("sweep:")[0] + "want: [pull_off]\n")
    conftest.edit(good.file, "radius: 100", "radius: 100, tabor: 1, amplitude: 0.1")
    assert "pulloff: no number varies in the case good: expected" in expect(2, None, "plot --case good --run own").err
