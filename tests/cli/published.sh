#!/bin/sh
# Tables of published values that may be missing: their checks are left out, the plan says so, and the checks are made
# once the file exists.
# shellcheck disable=SC1091,SC2013,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
python=${PYTHON:-python3}
mkdir "$PULLOFF_DATA/reference/published"
published=$PULLOFF_DATA/reference/published/markers.csv
file=$PULLOFF_DATA/cases/curve.yaml

cat >"$file" <<'CASE'
name: curve
title: The smooth sphere of Tabor parameter 1 and somebody's markers
suites: [smoke]
scene:
  tabor: 1
  radius: 100
  outer_radius: inf
  scheme: triangle
  nodes: 101
want: [pull_off]
checks:
  - quantity: pull_off_force
    reference: reference/table.csv
    tolerance: 1e-2
    kind: abs
    because: hundred elements
  - quantity: curve
    reference: reference/published/markers.csv
    stand_in: reference/table.csv
    tolerance: 0.05
    kind: abs
    because: read off a figure
CASE
write_table "$PULLOFF_DATA/reference/table.csv" tabor,force,approach 1,1.6707,-0.8734

# markers KIND APPROACH,LOAD...: writes markers in arbitrary order; the first two lie on the curve, see Figure 3
markers() {
  kind=$1
  shift
  rows=$(for point in "$@"; do printf '1,1,%s,0.02\n' "$point"; done)
  # shellcheck disable=SC2086 # a row has no blank
  write_table "$published" tabor,index,approach,load,uncertainty $rows
  sed -i "s/^# kind:.*/# kind: $kind/" "$published"
  seal "$published"
}

expect 0 '' plan curve
check 'the plan lists the checks that are left out' grep -q -F 'leave out curve against reference/published/markers.csv: the file does not exist; its stand-in is reference/table.csv' "$work/stdout"
check 'the plan says that no curve is kept' grep -q 'no curves: neither' "$work/stdout"
expect 0 '*' verify --verbose curve --output run
check 'one check is made' test 1 -eq "$(grep -c '^curve ' "$work/stdout")"
check 'the record names the table that is used instead' "$python" -c '
import json
record = json.load(open("run/curve/record.json"))
assert record["left_out"] == [{"quantity": "curve", "reference": "reference/published/markers.csv",
                               "stand_in": "reference/table.csv"}], record["left_out"]'

# Markers at the pull-off, at the fold jump_in, farther out, and beyond the start of the computed branch, not sorted along
# the branch.
markers published -0.8734,-1.6707 -1.629,-0.681 -1.9,-0.397 -2.5,-0.21 -0.87,-1.66
expect 0 '*' verify --verbose curve --output run
check 'the markers join the checks' grep -q '^curve  *curve .*published *within' "$work/stdout"
check 'four of them' grep -q '4 points compared, 1 beyond the ends' run/curve/record.json
check 'nothing is left out any more' grep -q '"left_out": \[\]' run/curve/record.json
expect 0 '' list --references
check 'the list shows them' grep -q '^reference/published/markers.csv  *published  *5  *curve ' "$work/stdout"
markers published -0.8734,-1.6707 -1.5,-0.681
expect 1 '*' verify --verbose curve --output run
check 'a marker off the curve is outside' grep -q '^curve  *curve .*published *outside' "$work/stdout"
check 'the message describes it' grep -q 'largest distance near approach -1.5, load -0.681' run/curve/record.json
sed -i 's/^1,1,-1.5,-0.681/1,1,-1.629,-0.681/' "$published"
expect 4 'pulloff: reference/published/markers.csv:10: sha256 is *' verify --verbose curve --output run
expect 4 'pulloff: reference/published/markers.csv:10: sha256 is *' list --references
"$python" "$here/../../reference/make/seal.py" "$published"
expect 0 '*' verify --verbose curve --output run
markers oracle -0.8734,-1.6707
expect 4 'pulloff: reference/published/markers.csv:3: kind is oracle: expected published, *' plan curve
markers published -0.8734,-1.6707
sed -i 's/0.02$/0.2/' "$published" && seal "$published"
expect 2 'pulloff: cases/curve.yaml:20: checks[[]2[]].tolerance is 0.05: expected at least 0.2, *' plan curve
rm "$published"
expect 0 '*' verify --verbose curve --output run
check 'after the file is removed, the check is left out again' grep -q '"stand_in": "reference/table.csv"' run/curve/record.json

sed -i 's/stand_in:.*/stand_in: reference\/other.csv/' "$file"
expect 2 'pulloff: cases/curve.yaml:19: checks[[]2[]].stand_in is reference/other.csv: expected the reference of another check, *' plan curve
sed -i 's/stand_in:.*/stand_in: reference\/table.csv/; s/reference: reference\/published.*/reference: bradley/' "$file"
expect 2 'pulloff: cases/curve.yaml:18: checks[[]2[]].reference is bradley: expected the path of a CSV file, *' plan curve

finish
