#!/bin/sh
# Points are solved again if their scenes change, results compared again if checks or references change, and nothing is
# done if nothing changed.
# shellcheck disable=SC1091,SC2013,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
file=$PULLOFF_DATA/cases/good.yaml
record=run/good/record.json
store=run/good/points.jsonl

expect 0 'good: 1 point, 1 check: within' run --output run
cp "$record" first.json
expect 0 'good: 1 point, 1 check: within (kept)' run --output run
check 'a kept record is not written again' cmp first.json "$record"

# A stored force that was altered used to be compared, and pinned. Now the point is solved again, and bless refuses.
stored() { grep -v -E '"(checksum|seconds|date)"|^ *[0-9.]+(e-[0-9]+)?$' "$1"; }
stored first.json >stored
cp $store first.jsonl
sed -i 's/"force":2.0/"force":2.1/' $store
check 'the force is altered' fails cmp -s first.jsonl $store
mends good 1 0 'good: 1 point, 1 check: within' run --output run
stored "$record" >mended
check 'the altered point is solved again' cmp stored mended
check 'the altered line is gone' test "$(wc -l <$store)" -eq 1
sed -i 's/"points":\([0-9]\)/"points":1\1/' $store
"$program" bless good --output run --reason none 2>"$work/stderr"
check 'exit code 1' test $? -eq 1
check 'bless refuses' grep -q '^pulloff: good is not blessed: 1 stored result was altered or damaged; ' "$work/stderr"
check 'an altered counter is not pinned' test ! -e "$PULLOFF_DATA/cases/pins"
# The record and the tables beside it are written again from the store, whatever was altered.
rewritten='good: the record or a table beside it was altered or damaged; the stored results are intact, and it is written again'
sed -i 's/"verdict": "within"/"verdict": "outside"/' "$record"
first=$rewritten
expect 0 'good: 1 point, 1 check: within (kept)' run --output run
first=
check 'the altered verdict is replaced' fails grep -q '"outside"' "$record"

sed -i 's/tolerance: 1e-9/tolerance: 1e-8/' "$file"
expect 0 'good: 1 point, 1 check: within (kept)' run --output run
check 'a new tolerance is compared again' grep -q '"tolerance": 1.*e-0*8' "$record"

write_table "$PULLOFF_DATA/reference/table.csv" tabor,force,approach 0,2.5,0
expect 0 'good: 1 point, 1 check: outside (kept)' run --output run
check 'a new reference is compared again' grep -q '"expected": 2.5' "$record"
check 'the verdict of the case is updated' grep -q '"verdict": "outside"' "$record"

write_table "$PULLOFF_DATA/reference/table.csv" tabor,force,approach 0,2,0
sed -i 's/approach_end.*//; s/^  nodes: 101/  nodes: 101\n  approach_end: 0.1/' "$file"
expect 0 'good: 1 point, 1 check: within' run --output run
expect 0 'good: 1 point, 1 check: within' run --output run --fresh

sed -i 's/^want: .*/want: [pull_off, curve, profile]/' "$file"
expect 0 'good: 1 point, 1 check: within' run --output run
check 'a wanted curve is written' test -s run/good/curve-0.csv
check 'a wanted profile is written' test -s run/good/profile-0.csv
expect 0 'good: 1 point, 1 check: within (kept)' run --output run
cp run/good/curve-0.csv curve.csv
first=$rewritten
rm run/good/curve-0.csv
expect 0 'good: 1 point, 1 check: within (kept)' run --output run
check 'a lost curve is written again' cmp curve.csv run/good/curve-0.csv
sed -i 's/^\(0,[^,]*\),[^,]*/\1,7/' run/good/curve-0.csv
expect 0 'good: 1 point, 1 check: within (kept)' run --output run
check 'a changed curve is written again' cmp curve.csv run/good/curve-0.csv
first=

sed -i 's/^want/repeats: 3\nwant/' "$file"
expect 0 'good: 1 point, 1 check: within' run --output run
check 'three times for three repeats' test 3 -eq \
  "$(sed -n '/"seconds_all"/,/\]/p' "$record" | grep -c '[0-9]')"
expect 0 '*' verify good --output run --junit out.xml
check 'verify reads the kept run' grep -q 'kept' "$work/stderr"
check 'JUnit counts' grep -q '<testsuite name="good" tests="1" failures="0"' out.xml
finish
