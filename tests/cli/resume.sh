#!/bin/sh
# Each point of a case is kept as soon as it is solved: after Ctrl-C, and if the case is run in parts on one or several
# machines.
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
journal=run/parts/points.jsonl
strip() { grep -v -E '"(seconds|date|jobs|checksum)"|^ *[0-9.]+(e-[0-9]+)?$' "$1"; }

write_parts 6 81
expect 0 'parts: 6 points, 0 checks: within' run --output whole
check 'a finished case leaves no journal' test ! -e whole/parts/points.jsonl

expect 0 'parts: 3 of 6 points, 0 checks: within' run --output run --points 0-2
check 'three points are kept' test "$(wc -l <$journal)" -eq 3
check 'a part of a case has no record' test ! -e run/parts/record.json
expect 0 'parts: 3 of 6 points, 0 checks: within (3 points kept)' run --output run --points 0-2
check 'no point is solved twice' test "$(wc -l <$journal)" -eq 3
expect 0 'parts: 1 of 6 points, 0 checks: within' run --output run --points 2 --fresh
check '--fresh solves all points again' test "$(wc -l <$journal)" -eq 4

# Two machines: their journals and curves are combined.
cp -r run one
expect 0 'parts: 3 of 6 points, 0 checks: within' run --output two --points 3-99
cat two/parts/points.jsonl >>one/parts/points.jsonl
cp two/parts/curve-*.csv one/parts/
expect 0 'parts: 6 points, 0 checks: within (6 points kept)' run --output one
strip one/parts/record.json >joined
strip whole/parts/record.json >at-once
check 'the record is that of one run, except for the times' cmp joined at-once

# Damaged parts are ignored and their points are solved again: an incomplete line, a line of another point, a lost curve.
# The lines are in the order in which the solves end, so a line is identified by its point.
cp -r run torn
sed -i '/"id":"1"/s/.\{40\}$//' torn/parts/points.jsonl
mends parts 1 0 'parts: 6 points, 0 checks: within (2 points kept)' run --output torn
cp -r run other
sed -i 's/"id":"1"/"id":"4"/' other/parts/points.jsonl
expect 0 'parts: 6 points, 0 checks: within (2 points kept)' run --output other
cp -r run lost
rm lost/parts/curve-0.csv
mends parts 1 0 'parts: 6 points, 0 checks: within (2 points kept)' run --output lost
for folder in torn other lost; do
  strip $folder/parts/record.json >mended
  check "the record of $folder is whole" cmp mended at-once
done
expect 0 'parts: 6 points, 0 checks: within' run --output run --fresh
check '--fresh reuses nothing' test ! -e $journal

# If scenes are added, the earlier points are kept. If the mesh changes, no point is kept.
expect 0 'parts: 2 of 6 points, 0 checks: within' run --output more --points 0-1
write_parts 8 81
expect 0 'parts: 8 points, 0 checks: within (2 points kept)' run --output more
expect 0 'parts: 2 of 8 points, 0 checks: within' run --output mesh --points 0-1
write_parts 8 91
expect 0 'parts: 8 points, 0 checks: within' run --output mesh

# After Ctrl-C the solved points are kept.
write_parts 400 301
"$program" run --output stopped --jobs 1 2>"$work/stderr" &
child=$!
stopped=stopped/parts/points.jsonl
two_lines() { [ -s $stopped ] && [ "$(wc -l <$stopped)" -ge 2 ]; }
wait_for two_lines
kill -INT $child
wait $child
check 'exit code 130' test $? -eq 130
check 'the message says what is kept' grep -q 'interrupted; finished points are kept in stopped' "$work/stderr"
kept=$(wc -l <$stopped)
check 'some points are kept' test "$kept" -ge 2
expect 0 "parts: $kept of 400 points, 0 checks: within ($kept points kept)" \
  run --output stopped --points "0-$((kept - 1))" --jobs 0
finish
