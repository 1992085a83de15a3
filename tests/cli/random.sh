#!/bin/sh
# Random scenes: the summary counts the failures, its commands repeat the points to the last bit, and a stated fraction of
# solves may fail.
# shellcheck disable=SC1091,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
python=${PYTHON:-python3}
rm "$PULLOFF_DATA/cases/good.yaml"

write_scenes() { # SHARE
  cat >"$PULLOFF_DATA/cases/scenes.yaml" <<CASE
name: scenes
title: Spheres at random, every other one without the time to solve it
suites: [random]
scene: {outer_radius: inf, scheme: panel, tolerance: 1e-4}
sample:
  seed: 20200908
  count: 3
  keys:
    - {key: tabor, from: 0.1, to: 1, scale: log}
    - {key: radius, from: 30, to: 500, scale: log}
    - {key: wavelength, from: 3, to: 6, times: root_radius}
    - {key: amplitude, from: 0, to: 0.1, times: wavelength}
sweep: [{key: time_limit, values: [3600, 1e-9]}]
want: [pull_off]
checks:
  - {quantity: solved_share, reference: every_scene, tolerance: $1, kind: abs, because: it is made so}
CASE
}
write_scenes 0.6
expect 2 'pulloff: there is no such case in *' run
expect 0 '*scenes: 6 points, 1 checks: within' run --suite random --jobs 0
cp "$work/stdout" summary
check 'the points' grep -q '^scenes: 6 of 6 points$' summary
check 'three solved' grep -qE '^ok +3$' summary
check 'three failed' grep -qE '^out_of_time +3$' summary
for what in seconds points nodes; do
  check "the cost in $what" grep -qE "^$what +[0-9.e-]+ +[0-9.e+-]+ +[0-9.e+-]+$" summary
done
check 'each failure has its reason' test 3 -eq \
  "$(grep -c '^point [135], out_of_time: after 1e-09 s of processor time the trace is at' summary)"
expect 0 '' plan scenes
check 'the plan says what is compared' \
  grep -q '^  compare solved_share with every_scene at 6 of 6 points, tolerance 0.6 abs$' "$work/stdout"
check 'the record has the check that belongs to no single point' grep -q '"point": null' build/run/scenes/record.json

# The command after a failure repeats it, with the same reason and the exit code of a failed solve.
line=$(sed -n '/^point 3, out_of_time: /{n;s/^ *pulloff //;p;}' summary)
reason=$(sed -n 's/^point 3, out_of_time: //p' summary)
# shellcheck disable=SC2086 # words are meant
expect 3 "pulloff: the solve failed: $reason" $line
# The command of a solved point repeats every number to the last bit.
# Only the slowest points have a command; the first of them is taken.
solved=$(sed -n 's/^point \([0-9]*\), ok, .*/\1/p' summary | head -n 1)
line=$(sed -n "/^point $solved, ok, /{n;s/^ *pulloff //;p;}" summary)
# shellcheck disable=SC2086
expect 0 '' $line --json
cat >same.py <<'SAME'
import json, sys
again = json.load(open("stdout"))
point = json.load(open("build/run/scenes/record.json"))["points"][int(sys.argv[1])]
# The command contains the default preload, so that the solve does not continue beyond it.
assert again["input"].pop("preload_load") == 1 and point["input"].pop("preload_load") is None
for key in ("input", "status", "pull_off", "folds", "extrema"):
    assert again[key] == point[key], (key, again[key], point[key])
del again["work"]["seconds"], point["work"]["seconds"]
assert again["work"] == point["work"]
assert point["sweep"].keys() == {"time_limit", "tabor", "radius", "wavelength", "amplitude"}
SAME
check 'the command repeats a point' "$python" same.py "$solved"

expect 0 'scenes: 6 points, 1 checks: within (kept)' verify scenes --tap
check 'TAP has the fraction, not the failures that it allows' test "$(sed -n 2p "$work/stdout")" = 1..1
expect 0 '*' verify scenes --junit out.xml
check 'JUnit has the same' grep -q '<testsuite name="scenes" tests="1" failures="0"' out.xml
expect 0 '*' explain scenes
check 'explain: no failed solve if few enough failed' test "$(cat "$work/stdout")" = \
  'scenes: 0 of 1 checks explained, the others are within'
expect 0 '*' explain scenes --all
check 'explain: the fraction belongs to no single point' grep -q '^scenes solved_share -: within$' "$work/stdout"
expect 0 '*' verify --verbose scenes
check 'the verdict belongs to no single point' grep -qE '^scenes +solved_share +- +0.5 +1 ' "$work/stdout"
write_scenes 0.4
expect 3 'scenes: 6 points, 1 checks: failed (kept)' verify --verbose scenes
check 'too many solves failed' grep -q 'outside: 3 of 6 points failed, first point 1: after 1e-09 s' "$work/stdout"
expect 3 '*' explain scenes --json
cat >told.py <<'TOLD'
import json, sys
d = json.load(open("stdout"))
(c,) = d["checks"]
assert (c["id"], c["point"], c["label"], c["fault"]) == ("solved_share/every_scene", None, None, "solve")
assert [f["point"] for f in d["failed"]] == ["1", "3", "5"]
assert c["command"] == d["failed"][0]["command"] and " --time-limit 1e-09" in c["command"], c["command"]
TOLD
check 'explain: the fraction, and each failure' "$python" told.py
expect 3 '*' explain scenes --point 3
check 'explain: for one point only its failure' grep -q '^scenes: 0 of 0 checks explained$' "$work/stdout"
expect 0 '*' explain scenes --point 0
expect 3 '*' verify --verbose scenes
check 'now the failed solves count' test 3 -eq "$(grep -c 'time_limit=1e-9 .*failed: after' "$work/stdout")"
"$program" run scenes >"$work/stdout" 2>"$work/stderr"
check 'exit code 3 of the run' test $? -eq 3
expect 0 '*' run scenes --time-limit 3600
check 'the time limit of the command line applies' grep -qE '^none failed$' "$work/stdout"
expect 0 '*(kept)' explain scenes --time-limit 3600 --all
finish
