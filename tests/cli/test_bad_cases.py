"""Wrong case files: the message is one line with file, line, path, value and what was expected. The exit code is 2, and nothing is
written."""

import os
import re

import pytest
from conftest import ROOT, edit, expect, run

FINITE = "expected a finite number > 0"
CHECK = "checks[1].{} is {}: expected {}"
SHARE = ("pull_off_force", "solved_share", "reference/table.csv", "every_scene")


def refused(good, message, changes):
    edit(good.file, *changes)
    expect(2, f"pulloff: cases/good.yaml:{message}", "run --output out")
    assert not os.path.exists("out")


@pytest.mark.parametrize("message, words", [
    ("no case is named nobody: expected one of good", "run nobody"),
    ("cases and --suite are given: expected one of them", "run good --suite smoke"),
    ("no case belongs to the suite extreme: expected one of smoke", "run --suite extreme"),
    ("no case belongs to the suite empty: expected one of smoke", "list --suite smoke,,smoke")])
def test_wrong_names(good, message, words):
    expect(2, "pulloff: " + message, words)
    expect(4, "pulloff: absent.yaml cannot be opened: No such file or directory", "run absent.yaml")


def test_infinity_and_byte_order_mark(good):
    """Infinity as YAML spells it was refused where it is meant, and a byte order mark is no text."""
    text = good.file.read_text()
    for infinity in "inf", ".inf", ".Inf", "+.inf":
        good.file.write_text("\ufeff" + text.replace("outer_radius: inf", "outer_radius: " + infinity))
        expect(0, "*good: 1 point, 1 check: within*", "run --output out")


def test_every_quantity_is_offered(good):
    """The message named a quantity that does not exist. Those of the table in doc/cases.md exist and are offered."""
    edit(good.file, "pull_off_force", "nothing")
    offered = run("plan good").err.rpartition("expected ")[2].strip().replace(" or ", ", ").split(", ")
    rows = re.findall(r"^\| (`[^|]*`) \|", (ROOT / "doc" / "cases.md").read_text().partition("| quantity |")[2].partition("\n\n")[0], re.MULTILINE)
    assert sorted(offered) == sorted(name for row in rows for name in re.findall("`(.*?)`", row))
    for name in offered:
        edit(good.file, "nothing" if name == offered[0] else previous, name)
        previous = name
        assert "quantity is" not in run("plan good").err


# message, and pairs of what is replaced and by what
SCENE = [
    *((f"8: scene.outer_radius is {said}: {FINITE}, or inf", "outer_radius: inf", "outer_radius: " + value)
      for said, value in (("-.inf", "-.inf"), (".nan", ".nan"), (".inf", '".inf"'))),
    *((f"7: scene.radius is {said}: {FINITE}", "radius: 100", "radius: " + value)
      for said, value in (("-3", "-3"), (".inf", ".inf"), ("wide", "wide"), ("a list", "[100]"), ("empty", ""))),
    ("8: scene.morse_a is 3: expected a parameter of the law or the profile of a point or a line", "radius: 100", "radius: 100\n  morse_a: 3"),
    ("4: sweep[1] is *: expected a parameter of the law or the profile of a point or a line",
     "scene:", "sweep: [{key: cone_t, values: [1, 2]}]\nscene:"),
    ("10: scene.nodes is 3.5: expected a whole number > 0", "101", "3.5"),
    ("9: scene.scheme is cube: expected ring, triangle or panel", "triangle", "cube"),
    ("7: scene.radios is unknown: expected one of tabor, amplitude, wavelength, radius, *; did you mean radius?", "  radius:", "  radios:"),
    (f"4: scene.radius is missing: {FINITE}, here, in the sweep or in the sample", "  radius: 100\n", ""),
    (f"4: scene.wavelength is missing: {FINITE}, here, in the sweep or in the sample", "amplitude: 0", "amplitude: 1"),
    ("8: radius is given twice, first on line 7: expected it once", "radius: 100", "radius: 100\n  radius: 50"),
    ("4: scene is 3: expected a mapping of scene keys", "scene:", "scene: 3\nscenery:"),
]
WANTED = "pull_off, folds, extrema, curve, profile, hysteresis, diagnostics, preload, theories"
KEYS = [
    ("2: name is given twice, first on line 1: expected it once", "name: good", "name: good\nname: bad"),
    ("1: name is missing: expected letters, digits, _ and -", "name: good\n", ""),
    ("1: name is ../good: expected letters, digits, _ and -", "good", "../good"),
    ("1: name is solvers: expected another name: records of external solvers are in this folder", "good", "solvers"),
    (f"*: want is missing: expected a list of {WANTED}, loop, history", "want: [pull_off]\n", ""),
    ("11: want is pull_off: expected a list of pull_off, *", "[pull_off]", "pull_off"),
    (f"11: want[1] is pudding: expected {WANTED}, loop or history", "[pull_off]", "[pudding]"),
    ("11: want is a list: expected a list of pull_off, *", "[pull_off]", "[]"),
    ("11: want[2] is a list: expected a list of pull_off, *", "[pull_off]", "[pull_off, [folds]]"),
    ("3: suites[2] is des,sert: expected letters, digits, _ and -", "[smoke]", '[smoke, "des,sert"]'),
    ("3: a.b[1] is unknown: expected one of name, *", "A rigid sphere", 'A\n"a.b[1]": 3'),
    ("3: '' is unknown: expected one of name, *", "A rigid sphere", 'A\n"": 3'),
    ("2: flavour is unknown: expected one of name, title, figure, *", "title: A rigid sphere", "flavour: sweet"),
    ("11: repeats is 0: expected a whole number from 1 to 1000", "want", "repeats: 0\nwant"),
]
SWEEP = [(message, "want", f"sweep:\n  - key: {key}\nwant") for message, key in (
    ("12: sweep[1].key is colour: expected a key of the scene: tabor, amplitude, *, coupling", "colour\n    values: [1]"),
    ("12: sweep[1].key is tabor: expected a key that the scene does not give", "tabor\n    values: [1]"),
    ("13: sweep[1].values[2] is nan: expected a finite number", "approach_end\n    values: [1, nan]"),
    ("13: sweep[1].values[2] is 0.10: expected each value once", "approach_end\n    values: [0.1, 0.10]"),
    ("12: sweep[1].values is missing: expected a list of values, or from, to and count", "approach_end"))]
CHECKS = [
    ("13: " + CHECK.format("quantity", "pull_on", "pull_off_force, *"), "pull_off_force", "pull_on"),
    *((f"15: checks[1].tolerance is {value}: {FINITE}", "1e-9", value) for value in ("0", ".nan")),
    ("16: " + CHECK.format("kind", "roughly", "abs, rel or ulp"), "abs", "roughly"),
    *(("14: " + CHECK.format("reference", reference, expected), "pull_off_force", quantity, "reference/table.csv", reference)
      for quantity, reference, expected in (
          ("solved_share", "reference/table.csv", "every_scene, *"),
          ("pull_off_force", "every_scene", "bradley or the path of a CSV file"),
          ("jumps", "bradley", "the path of a CSV file, as only tables contain hysteresis"),
          ("residual", "reference/table.csv", "zero, *"),
          ("pull_off_force", "zero", "bradley or the path of a CSV file"))),
    ("16: " + CHECK.format("kind", "rel", "abs, as a share is absolute"), *SHARE, "abs", "rel"),
    ("15: " + CHECK.format("tolerance", "1", "the share that may fail, below 1"), *SHARE, "1e-9", "1"),
    ("16: " + CHECK.format("kind", "rel", "abs, as the reference is zero"), "pull_off_force", "moved_force", "reference/table.csv", "zero",
     "abs", "rel"),
    ("*: checks[1].because is missing: expected the reason for the tolerance", "    because: it has a closed form\n", ""),
    *((f"17: checks[1].because is {said}: expected the reason for the tolerance", "it has a closed form", value)
      for said, value in (("empty", '""'), ("  ", '"  "'))),
    ("18: checks[1].when is a list: expected a condition that holds for at least one point",
     "closed form", "closed form\n    when: [{key: tabor, values: [3]}]"),
    ("18: checks[1].whence is unknown: expected one of *", "closed form", "closed form\n    whence: 3"),
]
YAML = [
    ("*: not YAML: found character that cannot start any token", "  tabor: 0", "\ttabor: 0"),
    ("*: not YAML: *", "[pull_off]", "[pull_off"),
    ("5: an alias refers to this value: expected none", "tabor: 0", "tabor: &x 0\n  grading: *x"),
    ("*: a second document begins: expected one case a file", "closed form\n", "closed form\n---\nname: more\n"),
]


@pytest.mark.parametrize("message, changes", [(row[0], row[1:]) for row in [*SCENE, *KEYS, *SWEEP, *CHECKS, *YAML]])
def test_wrong_cases(good, message, changes):
    refused(good, message, changes)


DEEP = "the file has more than 64 levels of lists and mappings"


@pytest.mark.parametrize("message, content", [
    ("1: the file is empty: expected a case", b""),
    ("1: the file is not text, it contains a zero byte, as UTF-16 does: expected a case in UTF-8", b"\x7fELF\2\1\0\0\0"),
    ("1: not YAML: *", b"\xff\xfe\xfdname"), ("1: not a case: expected key: value", b"- a\n- b\n"),
    # libyaml read 100,000 open brackets for two minutes, as many anchors for more, and an unknown key was printed in full.
    (f"18: {DEEP}: expected a case", "extra: " + 100000 * "["), (f"18: {DEEP}: expected a case", "extra: " + 100000 * "{a: "),
    (f"19: {DEEP}: expected a case", "extra:\n  " + 100000 * "- "),
    ("18: the file has more than 64 anchors: expected a case", "extra: [" + "".join(f"&a{k} x, " for k in range(100000))),
    ("82: the file has more than 64 lines that begin with %: expected a case", "".join(f"%TAG !a{k}! b:\n" for k in range(100000))),
    ("18: keykey*... is unknown: expected one of *", "? " + 100000 * "key" + "\n: 1")], ids=range(10))
def test_hostile_files(good, message, content):
    """Bytes in place of the case, or a text after it."""
    good.file.write_bytes(content if isinstance(content, bytes) else good.file.read_bytes() + content.encode() + b"\n")
    assert len(expect(2, "pulloff: cases/good.yaml:" + message, "list").err) < 2000


def test_the_folder_of_cases(good):
    twin = good.file.with_name("twin.yaml")
    twin.write_text(good.file.read_text())
    expect(2, "pulloff: cases/twin.yaml: name is good: expected another name, as cases/good.yaml has this one", "run good")
    (good.folder / "cases").rename(good.folder / "elsewhere")
    expect(4, "pulloff: the folder */cases cannot be read: No such file or directory", "list")


SAMPLE = """
name: good
title: Spheres at random
suites: [random]
scene:
  outer_radius: inf
  scheme: panel
sample:
  seed: 17
  count: 3
  keys:
    - {key: tabor, from: 0, to: 1e-6}
    - {key: radius, from: 30, to: 500, scale: log}
    - {key: wavelength, from: 1, to: 3, scale: log, times: root_radius}
    - {key: amplitude, from: 0, to: 0.2, times: wavelength}
want: [pull_off]
"""
TABOR, RADIUS, WAVELENGTH, AMPLITUDE = (line + "\n" for line in SAMPLE.splitlines() if "{key" in line)
ALPHA = "    - {key: alpha, from: 0.1, to: 1}\n"
RATIO = "    - {key: amplitude_ratio, from: 0.01, to: 0.1}\n"
DRAWN, TIMES = "sample.keys[{}].{} is {}: expected {}", "sample.keys[3].times is {}: expected *"
NUMBER, UNIT = "a key of the scene whose value is a number*", "root_radius, or a key given in *"
GIVEN = "a key that neither scene nor sweep gives"
NEEDS_WAVES = "expected a number > 0, here, in the sweep or in the sample, as alpha varies"


def test_a_sample_and_its_plan(data):
    data.case("good", SAMPLE)
    expect(0, "*good: 3 points, 0 checks: within", "run good --output out")
    planned = expect(0, "", "plan good")
    for line in ("^  draw 3 scenes; each value depends on seed 17", "^    amplitude from 0 to 0.2 times wavelength, uniform$",
                 "^    wavelength from 1 to 3 times the square root of the radius, uniform in the"):
        assert planned.count(line), line


@pytest.mark.parametrize("message, changes", [(row[0], row[1:]) for row in (
    ("*: sample.seed is missing: expected a whole number of at most 15 digits", "  seed: 17\n", ""),
    *((f"8: sample.seed is {value}: expected a whole number of at most 15 digits", "17", value) for value in ("1.5", "-1")),
    *((f"9: sample.count is {value}: expected a whole number from 1 to 100000", "count: 3", f"count: {value}") for value in ("0", "100001")),
    ("9: sample.counts is unknown: expected one of seed, count, keys; did you mean count?", "count:", "counts:"),
    ("7: sample is 5: expected a mapping of seed, count, keys", "sample:", "sample: 5\nsimple:"),
    *(("11: " + DRAWN.format(1, "key", key, NUMBER), "tabor", key) for key in ("scheme", "nodes")),
    ("11: sample.keys[1].key is colour: expected a key of the scene whose value is a number, and not a count: tabor, *, outer_radius, mie_m, "
     "*power_c, *", "tabor", "colour"),
    ("12: " + DRAWN.format(2, "key", "tabor", "each key drawn once"), "key: radius", "key: tabor"),
    # A group and the key that it sets, or both groups of the waviness: the scene had other values than its label said, and with
    # both groups it was smooth.
    ("14: " + DRAWN.format(4, "key", "alpha", "each key drawn once"), AMPLITUDE, ALPHA),
    ("14: " + DRAWN.format(4, "key", "amplitude_ratio", "one of alpha and amplitude_ratio"), WAVELENGTH, ALPHA, AMPLITUDE, RATIO),
    ("14: " + DRAWN.format(3, "key", "alpha", GIVEN), WAVELENGTH, ALPHA, "radius: inf", "radius: inf\n  wavelength: 20"),
    ("14: " + DRAWN.format(3, "key", "alpha", "one of alpha and amplitude_ratio"),
     WAVELENGTH, ALPHA, "sample", "sweep: [{key: amplitude_ratio, values: [0.05]}]\nsample"),
    # Without an amplitude, alpha has no effect: every scene was the same smooth sphere.
    ("4: scene.amplitude is missing: " + NEEDS_WAVES, WAVELENGTH, ALPHA, AMPLITUDE, ""),
    ("6: scene.amplitude is 0: " + NEEDS_WAVES, WAVELENGTH, ALPHA, AMPLITUDE, "", "radius: inf", "radius: inf\n  amplitude: 0"),
    # A unit that a group sets, or that is a group, is not known when the number is drawn: it was 0.
    ("14: " + TIMES.format("wavelength"), WAVELENGTH, "", "sample", "sweep: [{key: alpha, values: [0.5]}]\nsample"),
    ("14: " + TIMES.format("coupling"), TABOR, "", "radius: inf", "radius: inf\n  coupling: 1", "times: wavelength", "times: coupling"),
    ("12: " + DRAWN.format(1, "key", "tabor", GIVEN), "radius: inf", "radius: inf\n  tabor: 1"),
    ("12: " + DRAWN.format(1, "key", "tabor", GIVEN), "sample", "sweep: [{key: tabor, values: [1]}]\nsample"),
    ("12: sample.keys[2].from is missing: expected a finite number", ", from: 30", ""),
    *(("12: " + DRAWN.format(2, "from", value, "a finite number > 0"), "from: 30", f"from: {value}") for value in ("-30", "nan")),
    *(("12: " + DRAWN.format(2, "to", value, "a finite number > from"), "to: 500", f"to: {value}") for value in ("30", "inf")),
    ("11: sample.keys[1].from is 0: expected a finite number > 0, as the scale is log", "1e-6", "1e-6, scale: log"),
    ("12: " + DRAWN.format(2, "scale", "cubic", "linear or log"), "500, scale: log", "500, scale: cubic"),
    *(("13: " + DRAWN.format(3, "times", unit, UNIT), "root_radius", unit) for unit in ("root_tabor", "amplitude", "scheme")),
    ("12: " + DRAWN.format(2, "times", "root_radius", UNIT), RADIUS, ""),
    ("4: scene.tabor is missing: expected a finite number >= 0, here, in the *", TABOR, ""),
    ("10: sample draws tabor=*: expected permitted values of these keys", "root_radius", "outer_radius"),
    (f"4: scene.wavelength is missing: {FINITE}, here, in the sweep or in the sample", WAVELENGTH, "", "times: wavelength", "times: radius"))])
def test_wrong_samples(good, message, changes):
    good.case("good", SAMPLE)
    refused(good, message, changes)
