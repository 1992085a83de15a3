#!/bin/sh
# Each point of a case is kept as soon as it is solved, also if the case is run in parts on one or several machines. The campaign
# `killed` of tests/robust/store.py interrupts runs.
# shellcheck disable=SC1091,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
rm "$PULLOFF_DATA/cases/good.yaml"

write_parts() { # COUNT NODES
  cat >"$PULLOFF_DATA/cases/parts.yaml" <<CASE
name: parts
title: Spheres at random
suites: [smoke]
scene: {outer_radius: inf, scheme: triangle, nodes: $2}
sample:
  seed: 5
  count: $1
  keys:
    - {key: tabor, from: 0.7, to: 1.3}
    - {key: radius, from: 70, to: 200}
want: [pull_off, curve]
CASE
}
store=run/parts/points.jsonl
strip() { grep -v -E '"(seconds|date|jobs|checksum)"|^ *[0-9.]+(e-[0-9]+)?$' "$1"; }

write_parts 6 81
expect 0 'parts: 6 points, 0 checks: within' run --output whole
check 'the store has a line for each point' test "$(wc -l <whole/parts/points.jsonl)" -eq 6

expect 0 'parts: 3 of 6 points, 0 checks: within' run --output run --points 0-2
check 'three points are kept' test "$(wc -l <$store)" -eq 3
check 'a part of a case has no record' test ! -e run/parts/record.json
expect 0 'parts: 3 of 6 points, 0 checks: within (3 points kept)' run --output run --points 0-2
check 'no point is solved twice' test "$(wc -l <$store)" -eq 3
expect 0 'parts: 1 of 6 points, 0 checks: within' run --output run --points 2 --fresh
check '--fresh solves all points again' test "$(wc -l <$store)" -eq 4

# Two machines: their stores are combined. Which points come first does not matter.
cp -r run one
expect 0 'parts: 3 of 6 points, 0 checks: within' run --output two --points 3-99
cat two/parts/points.jsonl >>one/parts/points.jsonl
expect 0 'parts: 6 points, 0 checks: within (kept)' run --output one
strip one/parts/record.json >joined
strip whole/parts/record.json >at-once
check 'the record is that of one run, except for the times' cmp joined at-once
check 'superseded lines are removed' test "$(wc -l <one/parts/points.jsonl)" -eq 6
check 'a curve is that of one run' cmp one/parts/curve-3.csv whole/parts/curve-3.csv
expect 0 'parts: 6 points, 0 checks: within' run --output one --fresh
check '--fresh leaves one line a point' test "$(wc -l <one/parts/points.jsonl)" -eq 6

# A point is found by its key: scenes can be added anywhere. If the mesh changes, no point is kept.
expect 0 'parts: 2 of 6 points, 0 checks: within' run --output more --points 0-1
write_parts 8 81
expect 0 'parts: 8 points, 0 checks: within (2 points kept)' run --output more
cat >"$PULLOFF_DATA/cases/swept.yaml" <<'CASE'
name: swept
title: A sphere on meshes
suites: [smoke]
scene: {tabor: 0, radius: 93, outer_radius: inf, scheme: ring}
sweep: [{key: nodes, values: [63, 83]}]
want: [pull_off, profile]
CASE
expect 0 'swept: 2 points, 0 checks: within' run swept --output refined
cp refined/swept/profile-1.csv before.csv
sed -i 's/63, 83/57, 63, 71, 83/' "$PULLOFF_DATA/cases/swept.yaml"
expect 0 'swept: 4 points, 0 checks: within (2 points kept)' run swept --output refined
check 'the profile of a point that was kept' cmp before.csv refined/swept/profile-3.csv
rm "$PULLOFF_DATA/cases/swept.yaml"
write_parts 6 81
expect 0 'parts: 2 of 6 points, 0 checks: within' run --output mesh --points 0-1
write_parts 6 91
expect 0 'parts: 6 points, 0 checks: within' run --output mesh
finish
