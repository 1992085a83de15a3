"""Errors that are measured without a verdict, keys that vary together, scenes that are left out, and solves that are timed in
rounds."""

import pathlib
import statistics

import pytest
from conftest import expect, load

CASE = """
name: measured
title: Rigid and elastic spheres
suites: [smoke]
scene: {radius: 100, outer_radius: inf}
sweep:
  - together:
      - {tabor: 0, approach_end: 0.5}
      - {tabor: 0.7}
  - together:
      - {scheme: triangle, nodes: 63}
      - {scheme: panel, tolerance: 1e-3}
      - {scheme: ring, nodes: 63}
leave_out:
  - {when: [{key: tabor, values: [0.7]}, {key: scheme, values: [ring]}], because: it is made so}
repeats: 3
want: [pull_off]
measure:
  - {quantity: pull_off_force, reference: bradley}
  - {quantity: folds, reference: reference/landmarks.csv}
  - quantity: curve
    reference: bradley
    when: [{key: tabor, values: [0]}, {key: scheme, values: [panel]}]
"""
RECORD = "build/run/measured/record.json"


@pytest.fixture
def measured(data):
    """The reference has one fold too many at 0.7, where there are two, and no fold for the rigid sphere."""
    data.table("reference/landmarks.csv", "tabor,kind,approach,load", "0.7,jump_in,-1.2,-1", "0.7,jump_out,-1.3,-1.1",
               "0.7,jump_in,-1.1,-1.2")
    return data.case("measured", CASE)


def test_the_plan(measured):
    planned = expect(0, "", "plan measured").out.splitlines()
    for line in ("  measure the error of pull_off_force against bradley at 5 of 5 points, without a verdict",
                 "    but reference/landmarks.csv has no value for 3 of these", "  leave out 1 scene: it is made so"):
        assert line in planned
    assert any("repeat each solve 3 times, one solve at a time, in rounds" in line for line in planned)


def test_rules_that_overlap(measured):
    """A rule was refused if an earlier one excludes all points for which it holds."""
    rule = "  - {when: [{key: tabor, values: [0.7]}, {key: nodes, values: [63]}, {key: scheme, values: [ring]}], because: also}\n"
    measured.write_text(CASE.replace("repeats", rule + "repeats").lstrip("\n"))
    planned = expect(0, "", "plan measured").out.splitlines()
    for line in ("  leave out 1 scene: it is made so", "  leave out 1 scene: also"):
        assert line in planned


@pytest.mark.once
def test_the_record(measured):
    """Measured quantities have no verdict, so even a wrong value does not fail."""
    expect(0, "*measured: 5 points, 0 checks: within", "verify")
    bytes_of = pathlib.Path(RECORD).read_bytes
    first, record = bytes_of(), load(RECORD)
    points = {point["id"]: point for point in record["points"]}
    assert [p["label"] for p in record["points"]] == [
        "tabor=0 approach_end=0.5 scheme=triangle nodes=63", "tabor=0 approach_end=0.5 scheme=panel tolerance=1e-3",
        "tabor=0 approach_end=0.5 scheme=ring nodes=63", "tabor=0.7 scheme=triangle nodes=63", "tabor=0.7 scheme=panel tolerance=1e-3"]
    assert record["not_solved"] == [{"when": [{"key": "tabor", "values": ["0.7"]}, {"key": "scheme", "values": ["ring"]}],
                                     "points": 1, "because": "it is made so"}]
    assert record["checks"] == []
    for point in points.values():
        seconds, processor = point["seconds_all"], point["processor_seconds_all"]
        # three rounds, unless a slow machine has spent 0.1 s on the point before
        assert len(seconds) == len(processor) and (len(seconds) == 3 or sum(processor) >= 0.1) and min(seconds + processor) > 0
        assert point["work"]["seconds"] == pytest.approx(statistics.median(seconds), rel=1e-15)
        assert {"tabor", "scheme", "nodes", "tolerance", "approach_end"} <= point["sweep"].keys()
    told = {}
    for item in record["measured"]:
        told.setdefault(item["quantity"], {})[item["point"]] = item
    for identifier, point in points.items():  # far off at 0.7, which is not rigid
        item = told["pull_off_force"][identifier]
        assert item["outcome"] == "measured" and item["expected"] == 2 and item["error"] == point["pull_off"]["force"] - 2
    for identifier in "012":
        assert told["fold_count"][identifier]["outcome"] == "missing_reference"
        assert told["fold_count"][identifier]["error"] is None
    for identifier in "34":
        item = told["fold_count"][identifier]
        assert (item["outcome"], item["obtained"], item["expected"]) == ("no_correspondence", 2, 3)
        assert item["note"].startswith("missing jump_in near approach -1.1")
    assert list(told["curve"]) == ["1"]
    curve = told["curve"]["1"]
    assert curve["outcome"] == "measured" and 0 <= curve["error"] < 1e-3

    expect(0, "measured: 5 points, 0 checks: within (kept)", "verify measured")
    assert bytes_of() == first, "a kept record is not changed in any byte"
    measured.write_text("".join(line for line in measured.read_text().splitlines(True) if "quantity: folds" not in line))
    expect(0, "measured: 5 points, 0 checks: within (kept)", "verify measured")
    assert load(RECORD)["points"] == record["points"], "the times are kept if only the measured quantities change"

    # A failed solve has no measured error, and the record says so.
    measured.write_text(measured.read_text().replace("scheme: ring, nodes: 63}", "scheme: ring, nodes: 63, time_limit: 1e-9}"))
    expect(3, "*measured: 5 points, 0 checks: failed", "verify measured")
    record = load(RECORD)
    assert [p["id"] for p in record["points"] if p["failed"]] == ["2"]
    force = [m for m in record["measured"] if m["quantity"] == "pull_off_force"]
    assert [m["outcome"] for m in force] == 2 * ["measured"] + ["no_result"] + 2 * ["measured"]
    assert force[2]["error"] is None and force[2]["note"].startswith("after 1e-09 s")


RING, TABOR, FORCE = "{scheme: ring, nodes: 63}", "tabor: 0.7}", "force, reference: bradley"


@pytest.mark.parametrize("old, new, message", [
    (TABOR, "tabor: 0.7, nodes: 5}", "*: sweep[2].together *: expected each key swept once"),
    (TABOR, "tabor: 0.7, radius: 5}", "*: sweep[1].together *: expected a key that the scene does not give"),
    (TABOR, "tabor: -7}", "8: sweep[1].together[2].tabor is -7: expected *"),
    ("{tabor: 0.7}", "{approach_end: 0.7}", "8: sweep[1].together[2].tabor is missing: expected *"),
    (RING, "{scheme: triangle, nodes: 63}", "12: sweep[2].together[3] is *: expected each setting once"),
    (TABOR, "tabor: 0.0, approach_end: 5e-1}", "8: sweep[1].together[2] is *: expected each setting once"),
    (RING, "{scheme: ring}", "12: sweep[2].together[3].nodes is missing: expected *"),
    (TABOR, "tabour: 0.7}", "8: sweep[1].together[2].tabour is unknown: expected one of tabor, *"),
    ("leave_out:", "  - {key: nodes}\nleave_out:", "13: sweep[3].values is missing: expected a list of values, or from, to and count"),
    ("leave_out:", "  - {key: grading, values: [graded], together: [{tabor: 1}]}\nleave_out:",
     "13: sweep[3].together is *: expected key and values, or together alone"),
    ("because: it is made so", 'because: ""', "14: leave_out[1].because is empty: expected the reason *"),
    ("values: [ring]", "values: [rind]", "14: leave_out[1].when[2].values[1] is rind: *"),
    ("{key: tabor, values: [0.7]}", "{key: tabor, values: [0.8]}",
     "14: leave_out[1].when is *: expected a condition that holds for at least one point"),
    ("{key: tabor, values: [0.7]}, {key: scheme, values: [ring]}",
     "{key: radius, values: [100]}, {key: scheme, values: [ring, panel, triangle]}",
     "13: leave_out is *: expected rules that do not exclude all points"),
    # a quantity without any reference is not computed
    *(("quantity: curve", "quantity: " + quantity, f"20: measure[3].quantity is {quantity}: expected pull_off_force, *")
      for quantity in ("residual", "moved_force", "energy_defect", "reverse_trace", "hysteresis_force", "jumps")),
    *((FORCE, "force, reference: " + reference, f"18: measure[1].reference is {reference}: expected bradley or *")
      for reference in ("zero", "traced", "every_scene")),
    ("quantity: curve", "quantity: solved_share", "20: measure[3].quantity is solved_share: expected *"),
    (FORCE, FORCE + ", tolerance: 1", "18: measure[1].tolerance is unknown: expected one of quantity, reference, when")])
def test_wrong_cases(measured, old, new, message):
    text = measured.read_text()
    assert old in text
    measured.write_text(text.replace(old, new))
    expect(2, "pulloff: cases/measured.yaml:" + message, "list")
