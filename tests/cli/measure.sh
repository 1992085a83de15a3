#!/bin/sh
# Errors that are measured without a verdict, keys that vary together, scenes that are left out, and solves that are
# timed in rounds.
# shellcheck disable=SC1091,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
python=${PYTHON:-python3}
rm "$PULLOFF_DATA/cases/good.yaml"
file=$PULLOFF_DATA/cases/measured.yaml

write_measured() {
  cat >"$file" <<'CASE'
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
CASE
  # The reference has one fold too many at 0.7, where there are two, and no fold for the rigid sphere.
  write_table "$PULLOFF_DATA/reference/landmarks.csv" tabor,kind,approach,load \
    0.7,jump_in,-1.2,-1 0.7,jump_out,-1.3,-1.1 0.7,jump_in,-1.1,-1.2
}

write_measured
expect 0 '' plan measured
check 'the plan lists the measured quantities' grep -q \
  '^  measure the error of pull_off_force against bradley at 5 of 5 points, without a verdict$' "$work/stdout"
check 'the plan lists the scenes without reference' grep -q \
  '^    but reference/landmarks.csv has no value for 3 of these$' "$work/stdout"
check 'the plan lists the scenes that are left out' grep -q '^  leave out 1 scene: it is made so$' "$work/stdout"
check 'the plan says how the solves are timed' grep -q 'repeat each solve 3 times, one solve at a time, in rounds' "$work/stdout"

# Measured quantities have no verdict, so even a wrong value does not fail.
expect 0 '*measured: 5 points, 0 checks: within' verify
cat >read.py <<'READ'
import json
record = json.load(open("build/run/measured/record.json"))
points = {point["id"]: point for point in record["points"]}
assert [p["label"] for p in record["points"]] == [
    "tabor=0 approach_end=0.5 scheme=triangle nodes=63", "tabor=0 approach_end=0.5 scheme=panel tolerance=1e-3",
    "tabor=0 approach_end=0.5 scheme=ring nodes=63", "tabor=0.7 scheme=triangle nodes=63",
    "tabor=0.7 scheme=panel tolerance=1e-3"], [p["label"] for p in record["points"]]
assert record["not_solved"] == [{"when": [{"key": "tabor", "values": ["0.7"]}, {"key": "scheme", "values": ["ring"]}],
                                 "points": 1, "because": "it is made so"}]
assert record["checks"] == []
for point in points.values():
    for key in ("seconds_all", "processor_seconds_all"):
        assert len(point[key]) == 3 and min(point[key]) > 0, point[key]
    assert point["work"]["seconds"] == sorted(point["seconds_all"])[1]
    assert {"tabor", "scheme", "nodes", "tolerance", "approach_end"} <= point["sweep"].keys()
told = {}
for item in record["measured"]:
    told.setdefault(item["quantity"], {})[item["point"]] = item
force = told["pull_off_force"]
for identifier in points:         # far off at 0.7, which is not rigid
    item = force[identifier]
    assert item["outcome"] == "measured" and item["expected"] == 2, item
    assert item["error"] == points[identifier]["pull_off"]["force"] - 2, item
for identifier in ("0", "1", "2"):
    assert told["fold_count"][identifier]["outcome"] == "missing_reference"
    assert told["fold_count"][identifier]["error"] is None
for identifier in ("3", "4"):
    item = told["fold_count"][identifier]
    assert (item["outcome"], item["obtained"], item["expected"]) == ("no_correspondence", 2, 3), item
    assert item["note"].startswith("missing jump_in near approach -1.1"), item["note"]
assert list(told["curve"]) == ["1"]
curve = told["curve"]["1"]
assert curve["outcome"] == "measured" and 0 <= curve["error"] < 1e-3, curve
READ
check 'the record' "$python" read.py
cp build/run/measured/record.json first.json
expect 0 'measured: 5 points, 0 checks: within (kept)' verify measured
check 'a kept record is not changed in any byte' cmp first.json build/run/measured/record.json
sed -i '/quantity: folds/d' "$file"
expect 0 'measured: 5 points, 0 checks: within (kept)' verify measured
check 'the times are kept if only the measured quantities change' "$python" -c '
import json
a, b = (json.load(open(p))["points"] for p in ("first.json", "build/run/measured/record.json"))
assert a == b'

# A failed solve has no measured error, and the record says so.
sed -i 's/scheme: ring, nodes: 63}/scheme: ring, nodes: 63, time_limit: 1e-9}/' "$file"
expect 3 '*measured: 5 points, 0 checks: failed' verify measured
check 'it has no result' "$python" -c '
import json
record = json.load(open("build/run/measured/record.json"))
assert [p["id"] for p in record["points"] if p["failed"]] == ["2"], record["points"]
force = [m for m in record["measured"] if m["quantity"] == "pull_off_force"]
assert [m["outcome"] for m in force] == 2 * ["measured"] + ["no_result"] + 2 * ["measured"], force
assert force[2]["error"] is None and force[2]["note"].startswith("after 1e-09 s"), force'

spoilt() { # SED-SCRIPT MESSAGE
  write_measured
  sed -i "$1" "$file"
  expect 2 "pulloff: cases/measured.yaml:$2" list
}
spoilt 's/tabor: 0.7}/tabor: 0.7, nodes: 5}/' '*: sweep[[]2[]].together *: expected each key swept once'
spoilt 's/tabor: 0.7}/tabor: 0.7, radius: 5}/' '*: sweep[[]1[]].together *: expected a key that the scene does not give'
spoilt 's/tabor: 0.7}/tabor: -7}/' '8: sweep[[]1[]].together[[]2[]].tabor is -7: expected *'
spoilt 's/{tabor: 0.7}/{approach_end: 0.7}/' '8: sweep[[]1[]].together[[]2[]].tabor is missing: expected *'
spoilt 's/{scheme: ring, nodes: 63}/{scheme: triangle, nodes: 63}/' '12: sweep[[]2[]].together[[]3[]] is *: expected each setting once'
spoilt 's/{scheme: ring, nodes: 63}/{scheme: ring}/' '12: sweep[[]2[]].together[[]3[]].nodes is missing: expected *'
spoilt 's/tabor: 0.7}/tabour: 0.7}/' '8: sweep[[]1[]].together[[]2[]].tabour is unknown: expected one of tabor, *'
spoilt 's/^leave_out:/  - {key: nodes}\nleave_out:/' '13: sweep[[]3[]].values is missing: expected a list of values, or from, to and count'
spoilt 's/^leave_out:/  - {key: grading, values: [graded], together: [{tabor: 1}]}\nleave_out:/' \
  '13: sweep[[]3[]].together is *: expected key and values, or together alone'
spoilt 's/because: it is made so/because: ""/' '14: leave_out[[]1[]].because is empty: expected the reason *'
spoilt 's/values: \[ring\]/values: [rind]/' '14: leave_out[[]1[]].when[[]2[]].values[[]1[]] is rind: *'
spoilt 's/{key: tabor, values: \[0.7\]}/{key: tabor, values: [0.8]}/' \
  '14: leave_out[[]1[]].when is *: expected a condition that holds for at least one point'
spoilt 's/{key: tabor, values: \[0.7\]}/{key: radius, values: [100]}/; s/\[ring\]/[ring, panel, triangle]/' \
  '13: leave_out is *: expected rules that do not exclude all points'
spoilt 's/quantity: curve/quantity: work/' '20: measure[[]3[]].quantity is work: expected pull_off_force, *'
# A quantity without any reference is not computed.
for quantity in residual moved_force energy_defect reverse_trace hysteresis_force jumps; do
  spoilt "s/quantity: curve/quantity: $quantity/" "20: measure[[]3[]].quantity is $quantity: expected pull_off_force, *"
done
for reference in zero traced every_scene; do
  spoilt "s/force, reference: bradley/force, reference: $reference/" \
    "18: measure[[]1[]].reference is $reference: expected bradley or *"
done
spoilt 's/quantity: curve/quantity: solved_share/' '20: measure[[]3[]].quantity is solved_share: expected *'
spoilt 's/force, reference: bradley/force, reference: pin/' '18: measure[[]1[]].reference is pin: expected bradley or *'
spoilt 's/force, reference: bradley/force, reference: bradley, tolerance: 1/' \
  '18: measure[[]1[]].tolerance is unknown: expected one of quantity, reference, when'
finish
