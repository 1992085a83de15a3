"""Results are compared with their pins to the last bit. A difference within rounding is counted, a greater one fails, and so does a tenth
more work; with --identical every difference fails."""

import pathlib
import re

import pytest
from conftest import edit, expect, seal

NOT_OK = "^not ok 4 - good stored_results/pin$"
ALL = "^3 of 3 results are identical to the last bit with the stored ones"


@pytest.fixture
def good(good, monkeypatch):
    """Three elastic spheres and their pins."""
    for name, value in (("GIT_CONFIG_GLOBAL", "/dev/null"), ("GIT_CONFIG_SYSTEM", "/dev/null"), ("USER", "tester")):
        monkeypatch.setenv(name, value)
    good.case("good", """
name: good
title: Spheres
suites: [smoke]
scene: {tabor: 0.5, amplitude: 0, outer_radius: inf, scheme: panel, tolerance: 1e-5}
sweep: [{key: radius, values: [90, 100, 110]}]
want: [pull_off]
checks:
  - {quantity: energy_defect, reference: zero, tolerance: 1e-4, kind: abs, because: it must not be large}
""")
    good.pins = good.folder / "cases/pins/good.csv"
    return good


def verify(code, *patterns, more=""):
    return expect(code, "*", f"verify good --output run {more}").has(*patterns)


def bless(*patterns):
    expect(0, "*", "bless good --reason why --output run").has(*patterns)


def alter(pins, pattern, new):
    """Edits the table and corrects its checksum."""
    text, count = re.subn(pattern, new, pins.read_text(), flags=re.M)
    assert count
    pins.write_text(text)
    seal(pins)


def pin(pins, force):
    alter(pins, "^1,[^,]*,[^,]*", f"1,0123456789abcdef,{force}")


def test_without_pins_nothing_is_identical(good):
    assert verify(0).count("identical") == 0
    verify(1, "^good: 3 results are not stored; pulloff bless good --reason TEXT stores them$", more="--identical")
    verify(1, NOT_OK, more="--identical --tap")


def test_the_same_bits(good):
    bless("^cases/pins/good.csv: 3 results, 3 new$")
    first = good.pins.read_text()
    assert len(re.findall(r"^[0-2],[0-9a-f]{16},1\.[0-9]{14}[0-9]*(?:,[0-9]+){5}$", first, re.M)) == 3, "one row a point"
    verify(0, ALL, more="--identical")
    verify(0, "^2 of 2 results are identical", more="--points 1-2")
    verify(0, "^# 3 of 3 results are identical", "^ok 4 - good stored_results/pin$", more="--tap")
    bless()
    assert good.pins.read_text() == first


def test_another_last_bit(good):
    """Of another quantity than the force, and of the force."""
    bless()
    alter(good.pins, "^1,.", "1,x")
    verify(0, "^2 of 3 results are identical to the last bit with the stored ones, 1 differ: their pull-off forces by at most 0$")
    force = re.search("^1,[^,]*,([^,]*),", good.pins.read_text(), re.M)[1]
    pin(good.pins, force[:-6] + "999999")
    assert verify(0, "^2 of 3 results .* 1 differ: their pull-off forces by at most [0-9.]*e-1[0-9]$").count("not the stored ones") == 0
    verify(0, "^ok 4 - good stored_results/pin$", more="--tap")
    verify(1, "^good: 1 of 3 results are not the stored ones; the pull-off force of radius=100 differs most, by .*: zero can judge it$",
           more="--identical")
    verify(1, "^# good: 1 of 3 results", NOT_OK, more="--identical --tap --junit identical.xml")
    assert 'stored_results/pin"><failure' in pathlib.Path("identical.xml").read_text()
    # An oracle whose name is part of that of another one was left out, and a table that does not exist was named.
    good.table("reference/zero_force.csv", "radius,force", "90,1.8", "100,1.8", "110,1.8")
    check = "  - {{quantity: pull_off_force, reference: reference/{}, tolerance: 0.5, kind: abs, because: b}}\n"
    edit(good.file, "checks:\n", "checks:\n" + check.format("zero_force.csv") + check.format(
        "published/none.csv").replace("}", ", stand_in: reference/zero_force.csv}"))
    verify(1, ": zero_force, zero can judge it$", more="--identical")


def test_more_than_rounding(good):
    """And a force that was not there."""
    bless()
    pin(good.pins, re.search("^1,[^,]*,([^,]*),", good.pins.read_text(), re.M)[1][:-12] + "999999999999")
    verify(1, "1 by more than rounding$")
    verify(1, NOT_OK, more="--tap --junit junit.xml")
    assert 'name="stored_results/pin"><failure' in pathlib.Path("junit.xml").read_text()
    pin(good.pins, "-")
    verify(1, "1 differ: their pull-off forces by at most inf, 1 by more than rounding$",
           "only one of both results of radius=100 has a pull-off force: zero can judge it$")
    alter(good.pins, "^1,.*\n", "")
    verify(0, "^2 of 2 results are identical")
    bless("^cases/pins/good.csv: 3 results, 1 new$")


def test_a_damaged_table(good):
    bless()
    edit(good.pins, "\n1,", "\n1,x")
    expect(4, "pulloff: cases/pins/good.csv:*: sha256 is *", "verify good --output run")
    alter(good.pins, "^point,", "colour,")
    expect(4, "pulloff: cases/pins/good.csv:*: expected the columns point,digest,pull_off_force,points,*", "verify good --output run")


def test_other_work(good):
    """It fails with --identical, and if a counter of the case is a tenth above the stored ones."""
    bless()
    points = int(re.search("^1,[^,]*,[^,]*,([^,]*),", good.pins.read_text(), re.M)[1])
    for stored, code, line in ((points + 1, 0, ALL + "; 1 took other work$"),
                               (1, 1, "^good: 1 of 3 results took other work than the stored ones: points [+][0-9.]* % in all$")):
        alter(good.pins, "^(1,[^,]*,[^,]*),[^,]*", rf"\g<1>,{stored}")
        verify(code, line)
        verify(1, "^good: 1 of 3 results took other work than the stored ones: points [-+][0-9.]* % in all$", more="--identical")
    verify(1, NOT_OK, more="--tap")
    alter(good.pins, "^(1,[^,]*,[^,]*),[^,]*", r"\1,-")
    verify(0, more="--identical")
    bless("^cases/pins/good.csv: 3 results, 1 new$")


def test_other_scenes(good):
    """Digests of other scenes are not compared: those of the same numbers were, and each result differed."""
    bless()
    verify(0, ALL, more="--identical --time-limit 500")
    edit(good.file, "90, 100, 110", "110, 100, 90")
    assert verify(0).count("results are|scenes") == 0
    others = "^good: its scenes are not those whose results were stored, and none is compared; pulloff bless good --reason TEXT stores "
    verify(1, others, more="--identical")
    verify(1, NOT_OK, more="--identical --tap")
    bless("^cases/pins/good.csv: 3 results, 3 new$")
    verify(0, ALL, more="--identical")
    alter(good.pins, "^# scenes:.*\n", "")
    verify(1, others, more="--identical")
    bless()
    assert re.search("^# scenes: [0-9a-f]{64}$", good.pins.read_text(), re.M)


def test_several_cases(good):
    good.case("other", good.file.read_text().replace("name: good", "name: other"))
    for words in "good other", "--suite smoke":
        ended = expect(0, None, f"bless {words} --reason both --output run")
    ended.has("^cases/pins/good.csv: 3 results, 0 new; nothing is written$")
    expect(2, "pulloff: cases and --suite are given: expected one of them", "bless good --suite smoke --reason both")
    expect(0, None, "verify --suite smoke --output run --identical").has("^6 of 6 results are identical")
