#!/bin/sh
# A case is kept point by point: after Ctrl-C, and when it is run in parts, on one machine or on several.
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
strip() { grep -v -E '"(seconds|date|jobs)"|^ *[0-9.]+(e-[0-9]+)?$' "$1"; }

write_parts 6 81
expect 0 'parts: 6 points, 0 checks: within' run --output whole
check 'a finished case leaves no journal' test ! -e whole/parts/points.jsonl

expect 0 'parts: 3 of 6 points, 0 checks: within' run --output run --points 0-2
check 'three points are kept' test "$(wc -l <$journal)" -eq 3
check 'there is no record of a part' test ! -e run/parts/record.json
expect 0 'parts: 3 of 6 points, 0 checks: within (3 points kept)' run --output run --points 0-2
check 'nothing is solved twice' test "$(wc -l <$journal)" -eq 3
expect 0 'parts: 1 of 6 points, 0 checks: within' run --output run --points 2 --fresh
check 'unless it is asked for' test "$(wc -l <$journal)" -eq 4

# Two machines: their journals, and the curves, put together.
cp -r run one
expect 0 'parts: 3 of 6 points, 0 checks: within' run --output two --points 3-99
cat two/parts/points.jsonl >>one/parts/points.jsonl
cp two/parts/curve-*.csv one/parts/
expect 0 'parts: 6 points, 0 checks: within (6 points kept)' run --output one
strip one/parts/record.json >joined
strip whole/parts/record.json >at-once
check 'the record is that of one run, but for times' cmp joined at-once

# Damage is passed over, and what it hit is solved again: a torn line, a line of another point, a lost curve.
# Points are kept in the order they end, so a line is told by its point.
cp -r run torn
sed -i '/"id":"1"/s/.\{40\}$//' torn/parts/points.jsonl
expect 0 'parts: 6 points, 0 checks: within (2 points kept)' run --output torn
cp -r run other
sed -i 's/"id":"1"/"id":"4"/' other/parts/points.jsonl
expect 0 'parts: 6 points, 0 checks: within (2 points kept)' run --output other
cp -r run lost
rm lost/parts/curve-0.csv
expect 0 'parts: 6 points, 0 checks: within (2 points kept)' run --output lost
for folder in torn other lost; do
  strip $folder/parts/record.json >mended
  check "the record of $folder is whole" cmp mended at-once
done
expect 0 'parts: 6 points, 0 checks: within' run --output run --fresh
check 'fresh takes nothing over' test ! -e $journal

# More scenes: those that were are kept. Another mesh: none is.
expect 0 'parts: 2 of 6 points, 0 checks: within' run --output more --points 0-1
write_parts 8 81
expect 0 'parts: 8 points, 0 checks: within (2 points kept)' run --output more
expect 0 'parts: 2 of 8 points, 0 checks: within' run --output mesh --points 0-1
write_parts 8 91
expect 0 'parts: 8 points, 0 checks: within' run --output mesh

# Ctrl-C: what is solved is kept.
write_parts 400 301
"$program" run --output stopped --jobs 1 2>"$work/stderr" &
child=$!
stopped=stopped/parts/points.jsonl
two_lines() { [ -s $stopped ] && [ "$(wc -l <$stopped)" -ge 2 ]; }
wait_for two_lines
kill -INT $child
wait $child
check 'exit code 130' test $? -eq 130
check 'it says what is kept' grep -q 'interrupted; finished points are kept in stopped' "$work/stderr"
kept=$(wc -l <$stopped)
check 'some are' test "$kept" -ge 2
expect 0 "parts: $kept of 400 points, 0 checks: within ($kept points kept)" \
  run --output stopped --points "0-$((kept - 1))" --jobs 0
finish
