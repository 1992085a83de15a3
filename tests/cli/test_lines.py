"""Sweeps given by their ends, groups of keys, references for another scene, and closed forms along a sweep."""

import math

import pytest
from conftest import document, edit, expect, load, rows_of

GROUPS = """
name: good
title: Groups and lines
suites: [smoke]
scene: {radius: 61.3, outer_radius: inf, scheme: panel, tolerance: 1e-6, tabor: 1e-4}
sweep:
  - {key: alpha, values: [0.25, 4]}
  - {key: amplitude, values: [1]}
want: [pull_off]
lines:
  - name: rigid
    theory: rigid
    sweep:
      - {key: alpha, from: 0.01, to: 100, count: 5, scale: log}
      - {key: amplitude, values: [1, 2.385]}
  - name: curve
    theory: guduru
    sweep:
      - {key: tabor, values: [2.385]}
      - {key: wavelength, values: [11]}
      - {key: amplitude_ratio, values: [0.063]}
      - {key: contact_radius, from: 0, to: 40, count: 41}
checks:
  - quantity: pull_off_force
    reference: reference/table.csv
    as_if: [{key: tabor, values: [0]}]
    tolerance: 1e-5
    kind: rel
    because: the surface yields a little
    when: [{key: alpha, values: [0.25]}]
"""
# Laws, profiles and couplings in the sweep of a line, and in the record of a swept case.
LAWS = """
name: good
title: Lines of laws and profiles
suites: [smoke]
scene: {outer_radius: inf, scheme: panel, tolerance: 1e-4, coupling: 0.05, approach_end: 1}
sweep:
  - together: [{profile: "power:0.001,4", law: "mie:4,10"}]
want: [pull_off]
lines:
  - name: profiles
    theory: jkr
    sweep:
      - {key: profile, values: ["cone:0.3", "power:0.001,4", sphere]}
      - {key: coupling, values: [0.05, 0.5]}
  - name: laws
    theory: maugis
    sweep:
      - {key: law, values: ["mie:4,10", "morse:1"]}
      - {key: profile, values: ["cone:0.3"]}
      - {key: cone_t, values: [0.2, 0.3]}
checks:
  - {quantity: solved_share, reference: every_scene, tolerance: 1e-9, kind: abs, because: the scene must be solved}
"""


def near(row, column, value, tolerance):
    assert math.isclose(float(row[column]), value, rel_tol=tolerance), (row, column, value)


def from_theory(key, words):
    return document("theory " + words)[key]


def test_lines_of_groups(data):
    data.case("good", GROUPS)
    data.table("reference/table.csv", "alpha,amplitude,tabor,force,approach", "0.25,1,0,0.74105588164102001,0.0918", "4,2.385,0,0.30543829,0.03")
    expect(0, "*good: 2 points, 1 check: within", "run --output out")
    record, rigid, curve = load("out/good/record.json"), rows_of("out/good/line-rigid.csv"), rows_of("out/good/line-curve.csv")
    assert [line["table"] for line in record["lines"]] == ["line-rigid.csv", "line-curve.csv"] and (len(rigid), len(curve)) == (10, 41)
    near(rigid[4], "alpha", 1, 1e-15)
    near(rigid[5], "pull_off_force", from_theory("pull_off_force", "rigid --alpha 1 --amplitude 2.385"), 1e-14)
    near(curve[17], "load", from_theory("load", "guduru --tabor 2.385 --wavelength 11 --amplitude 0.693 --radius 61.3 --contact-radius 17"), 1e-13)
    assert math.isclose(record["points"][-1]["input"]["wavelength"]**2, 61.3 / 4, rel_tol=1e-5), "alpha = A R/lambda^2 = 4"


def test_lines_of_laws_and_profiles(data):
    data.case("good", LAWS)
    expect(0, "*good: 1 point, 1 check: within", "run --output out")
    profiles, laws = rows_of("out/good/line-profiles.csv"), rows_of("out/good/line-laws.csv")
    assert profiles[2]["profile"] == "power:0.001;4"
    near(profiles[3], "pull_off_force", from_theory("pull_off_force", "jkr --profile power:0.001,4 --coupling 0.5"), 1e-14)
    near(profiles[5], "pull_off_force", 1.5, 1e-12)
    near(laws[2], "pull_off_force", from_theory("pull_off_force", "maugis --law morse:1 --profile cone:0.2 --coupling 0.05"), 1e-14)
    sweep = load("out/good/record.json")["points"][0]["sweep"]
    assert (sweep["law"], sweep["profile"]) == ("mie:4,10", "power:0.001,4")


AMPLITUDES, ONE = "{key: amplitude, values: [1, 2.385]}", "  - {key: amplitude, values: [1]}"
OF_LINE = "lines[1].sweep[{}].{} is {}: expected {}"


@pytest.mark.parametrize("message, case, changes", [(message, GROUPS, changes) for message, *changes in (
    (OF_LINE.format(1, "from", 0, "a finite number > 0, as the scale is log"), "from: 0.01", "from: 0"),
    (OF_LINE.format(1, "to", 0.001, "a finite number > from"), "to: 100", "to: 0.001"),
    (OF_LINE.format(1, "count", 1, "a whole number from 2 to 10000"), "count: 5", "count: 1"),
    (OF_LINE.format(1, "scale", "round", "linear or log"), "scale: log", "scale: round"),
    (OF_LINE.format(2, "values[2]", -2, "a finite number >= 0"), "1, 2.385", "1, -2"),
    (OF_LINE.format(2, "values[2]", "two", "a *number*"), "1, 2.385", "1, two"),
    ("*values*: expected either values, or from, to and count", "count: 41", "count: 41, values: [1]"),
    ("lines[1].theory is alchemy: expected bradley, *", "theory: rigid", "theory: alchemy"),
    ("lines[2].name is rigid: expected each name once", "name: curve", "name: rigid"),
    ("lines[2].sweep[4].key is approach: expected tabor, *", "key: contact_radius", "key: approach"),
    ("lines[1].theory is rigid: expected an amplitude > 0", AMPLITUDES, "{key: radius, values: [1]}"),
    ("sweep[2].key is amplitude_ratio: expected one of alpha *", ONE, ONE.replace("amplitude", "amplitude_ratio")),
    ("sweep[2].key is wavelength: expected each key swept once", ONE, ONE.replace("amplitude", "wavelength")),
    ("checks[1].as_if[1].values is a list: expected one value", "tabor, values: [0]", "tabor, values: [0, 1]"),
    ("checks[1].as_if[1].key is colour: expected a key of the scene: tabor, *", "tabor, values: [0]", "colour, values: [0]"))] + [
    (message, LAWS, changes) for message, *changes in (
        ("lines[1].sweep[1].key is profile: expected tabor, *", "theory: jkr", "theory: guduru"),
        ("lines[1].sweep (profile=cone:-1): *", "cone:0.3", "cone:-1"),
        ("lines[2].sweep[3].key is power_n: expected a parameter of *", "cone_t", "power_n"),
        ("lines[1].theory is kesari-lew: expected one of rigid, jkr, maugis and persson-brener*", "theory: jkr", "theory: kesari-lew",
         'key: profile, values: ["cone:0.3", "power:0.001,4", sphere]', "key: amplitude, values: [1]", "scene: {", 'scene: {profile: "cone:0.3", ',
         'profile: "power:0.001,4", ', "", LAWS[LAWS.index("  - name: laws"):LAWS.index("checks:")], ""))])
def test_wrong_cases(data, message, case, changes):
    data.table("reference/table.csv", "alpha,amplitude,tabor,force,approach", "0.25,1,0,0.74105588164102001,0.0918")
    edit(data.case("good", case), *changes)
    expect(2, f"pulloff: cases/good.yaml:*: {message}", "run --output none")
