#!/bin/sh
# pulloff explain prints what differs, where, which side is probably wrong, and a command that repeats the solve.
# shellcheck disable=SC1091,SC2013,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
python=${PYTHON:-python3}
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null USER=tester
file=$PULLOFF_DATA/cases/good.yaml
table=$PULLOFF_DATA/reference/table.csv

explained() { # CODE PATTERN...: of good
  code=$1
  shift
  expect "$code" '*' explain good --output run
  for pattern in "$@"; do
    check "explained: $pattern" grep -q -e "$pattern" "$work/stdout"
  done
}

expect 2 'pulloff: explain needs the name of one case (see pulloff explain --help)' explain
expect 2 'pulloff: --point is tabor=1: expected a number below 1, or words of a label such as scene' \
  explain good --point tabor=1
check 'nothing was solved for these' test ! -e run
explained 0 '^good pull_off_force scene: slack$' '^  fault      tolerance: .*: reduce it$'
sed -i 's/tolerance: 1e-9/tolerance: 1e-12/' "$file"
explained 0 '^good: 0 of 1 check explained, the others are within$'
expect 0 '*' explain good --output run --all
check '--all explains also checks that are within' grep -q '^good pull_off_force scene: within$' "$work/stdout"

# A check is outside, and no other check is of the same quantity.
restore
write_table "$table" tabor,force,approach,force_uncertainty 0,2.5,0,1e-10
explained 1 '^good pull_off_force scene: outside$' '^  obtained   2$' '^  expected   2.5$' \
  '^  ledger     oracle: reference/table.csv, with an uncertainty of 1e-10$' \
  '^  difference -0.5, 5e+08 times the tolerance of 1e-9 abs$' \
  '^  where      approach .*, load -2, at minimum-1$' \
  '^  fault      program: .*no other reference covers this number' \
  '^  tolerance  because it has a closed form$' '^good: 1 of 1 check explained$'
command=$(sed -n 's/^  rerun      pulloff //p' "$work/stdout")
check 'the explanation states every key of the scene' test "$command" = \
  'solve --tabor 0 --radius 100 --outer-radius inf --scheme triangle --grading uniform --nodes 101'
# shellcheck disable=SC2086 # words are meant
expect 0 '' $command
check 'the command repeats it' grep -q '^pull-off force 2 ' "$work/stdout"

# A check against a published value does not pass, but the check against an oracle does.
restore
write_table "$PULLOFF_DATA/reference/paper.csv" tabor,force,approach 0,1.9,0
sed -i 's/^# kind: .*/# kind: published/' "$PULLOFF_DATA/reference/paper.csv" && seal "$PULLOFF_DATA/reference/paper.csv"
cat >>"$file" <<'CHECKS'
  - {quantity: pull_off_force, reference: reference/paper.csv, tolerance: 1e-2, kind: abs, because: read off a plot}
CHECKS
explained 1 '^  fault      publication: reference/table.csv (oracle) agrees with the result'

# The reference was altered after the result had been accepted.
expect 0 '*' bless good --reason 'the first' --output run
write_table "$table" tabor,force,approach 0,2.1,0
explained 1 '^good pull_off_force scene: outside$' \
  '^  fault      reference: the result is the stored one to the last bit, .* see git log -- reference/table.csv$'
rm -r "$PULLOFF_DATA/cases/pins"

# A curve: the place, the special points on both sides, and the JSON document.
restore
sed -i 's/quantity: pull_off_force/quantity: curve/; s/tolerance: 1e-9/tolerance: 1e-7/;
  s/reference: .*/reference: bradley/; s/^  tabor: 0//; s/^want/sweep: [{key: tabor, values: [0, 0.01]}]\nwant/' "$file"
expect 1 '*' explain good --output run --point tabor=0.01 --json
cat >look.py <<'LOOK'
import json, sys
d = json.load(sys.stdin)
assert (d["schema"], d["case"], d["verdict"], d["failed"]) == ("pulloff-explain/1", "good", "outside", [])
(c,) = d["checks"]
assert (c["point"], c["label"], c["quantity"], c["ledger"]) == ("1", "tabor=0.01", "curve", "oracle")
assert (c["verdict"], c["passes"], c["fault"]) == ("outside", False, "program")
assert c["error"] > 1e-7 and abs(c["ratio"] * 1e-7 / c["error"] - 1) < 1e-12
assert c["where"]["special_points"] == "after minimum-1" and c["where"]["approach"] > 0
assert c["command"].startswith("pulloff solve --tabor 0.01 ") and c["command"].endswith(" --curve curve.csv")
assert c["because"] == "it has a closed form" and c["reference"] == "bradley"
LOOK
check 'the document' "$python" look.py <"$work/stdout"
expect 1 '*' explain good --output run --point 0
check '--point selects the other point' grep -q '^good: 1 of 1 check explained$' "$work/stdout"

# A solve that failed.
restore
sed -i 's/^  nodes: 101/&\n  approach_end: 5/' "$file"
explained 3 '^good pull_off_force scene: no_result$' '^  fault      solve: ' \
  '^good solve scene: failed$' '^  reason     approach_end is 5'
finish
