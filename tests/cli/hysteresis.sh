#!/bin/sh
# Loading and unloading: the output of solve, and the record.
# shellcheck disable=SC1091,SC2154
. "$(dirname "$0")/lib.sh"
python=${PYTHON:-python3}

cat >look.py <<'LOOK'
import json, math, sys

d = json.load(open(sys.argv[1]))
if "points" in d:
    d = d["points"][0]
h = d["hysteresis"]
assert set(h) == {"displacement_control", "load_control", "jkr"}
loops = [h["displacement_control"], h["load_control"], *h["jkr"].values()]
for loop in loops:
    assert set(loop) == {"preload", "pull_off", "energy_lost", "energy_lost_error_estimate", "work",
                         "work_error_estimate", "energy_error_estimate", "jumps"}
    assert [j["label"] for j in loop["jumps"]] == ["1", "a"], loop["jumps"]
    assert [j["ends"] for j in loop["jumps"]] == [["1", "2"], ["a", "b"]]
    assert [j["phase"] for j in loop["jumps"]] == ["loading", "unloading"]
    for j in loop["jumps"]:
        assert set(j["before"]) == set(j["after"]) == {"approach", "load", "energy", "contact_radius",
                                                       "position"}
held, loaded = h["displacement_control"], h["load_control"]
assert math.isclose(held["preload"]["approach"], 0.7)
assert math.isclose(held["jumps"][0]["before"]["approach"], d["folds"][0]["approach"])
assert math.isclose(held["jumps"][1]["before"]["load"], d["folds"][1]["load"])
assert math.isclose(held["pull_off"]["force"], d["pull_off"]["force"])
assert abs(held["work"] - held["energy_lost"]) <= held["work_error_estimate"] < 1e-5
assert 0 < held["energy_lost_error_estimate"] <= held["work_error_estimate"]
assert loaded["energy_lost_error_estimate"] is None and 0 < loaded["energy_error_estimate"] < 1e-5
assert 0 < held["energy_error_estimate"] < 1e-5
assert all(0 < j["energy_lost_error_estimate"] < 1e-5 for j in held["jumps"])
assert all(loop["energy_error_estimate"] is None for loop in h["jkr"].values())
assert loaded["jumps"][0]["before"]["approach"] is None and loaded["energy_lost"] is None
assert math.isclose(h["jkr"]["displacement_control"]["pull_off"]["force"], 1.5)
LOOK
expect 0 '' solve --tabor 2.385 --preload 0.7 --want hysteresis --json
cp "$work/stdout" solved.json
check 'the JSON block has the documented form' "$python" look.py solved.json
expect 0 '' solve --tabor 2.385 --preload 0.7 --want hysteresis
check 'the printed result has the measured pull-off' grep -q '^displacement control: loading reversed at approach 0.7, ' "$work/stdout"
check 'the printed result has the jumps' grep -q '^a    unloading ' "$work/stdout"

cat >loop.yaml <<'CASE'
name: loop
title: A loop
suites: [smoke]
scene: {tabor: 2.385, radius: 100, outer_radius: inf, scheme: panel, preload: 0.7}
want: [hysteresis]
CASE
expect 0 'loop: 1 points, 0 checks: *' run loop.yaml --output run
check 'the record has the block' "$python" look.py run/loop/record.json
cp run/loop/record.json first.json
sed -i 's/A loop/The loop/' loop.yaml
expect 0 'loop: 1 points, 0 checks: *' run loop.yaml --output run
check 'a record made from a kept one has the block' "$python" look.py run/loop/record.json
cat >same.py <<'LOOK'
import json

a, b = (json.load(open(name))["points"][0] for name in ("first.json", "run/loop/record.json"))
assert a["hysteresis"] == b["hysteresis"] and a["seconds_all"] == b["seconds_all"]
LOOK
check 'a kept record is used' "$python" same.py
expect 0 '' plan loop.yaml
check 'the plan lists the hysteresis' grep -q 'simulate loading and unloading' "$work/stdout"

expect 2 'pulloff: --preload-load is -1: expected a finite number >= 0' solve --preload-load -1
expect 2 'pulloff: --preload-load is dimensionless: *' solve --from-physical --modulus-pa 2e9 \
  --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 1e-7 --preload-load 1
expect 2 'pulloff: approach_end is 0.5: expected at least the preload, 0.7' \
  solve --approach-end 0.5 --preload 0.7
expect 3 'pulloff: the solve failed: the trace ended at approach 0.5, load *, before the load 7 was reached' \
  solve --tabor 2.385 --approach-end 0.5 --preload-load 7
finish
