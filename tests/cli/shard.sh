#!/bin/sh
# Shards of a run: merged, they equal a single run to the last bit. Shards that do not belong together are refused, and
# the message names them.
# shellcheck disable=SC1091,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
python=${PYTHON:-python3}
rm "$PULLOFF_DATA/cases/good.yaml"

write_cases() { # NODES
  cat >"$PULLOFF_DATA/cases/drawn.yaml" <<CASE
name: drawn
title: Spheres at random
suites: [smoke]
scene: {outer_radius: inf, scheme: triangle, nodes: $1}
sample:
  seed: 5
  count: 7
  keys:
    - {key: tabor, from: 0.7, to: 1.3}
    - {key: radius, from: 70, to: 200}
want: [pull_off, curve]
checks:
  - {quantity: solved_share, reference: every_scene, tolerance: 0.01, kind: abs, because: all have}
CASE
  cat >"$PULLOFF_DATA/cases/rigid.yaml" <<'CASE'
name: rigid
title: One rigid sphere, on meshes
suites: [smoke]
scene: {tabor: 0, radius: 93, outer_radius: inf, scheme: ring}
sweep: [{key: nodes, values: [63, 71, 83, 97, 101]}]
want: [pull_off, profile]
checks:
  - {quantity: pull_off_force, reference: bradley, tolerance: 1e-3, kind: abs, because: the closed form}
CASE
  cat >"$PULLOFF_DATA/cases/timed.yaml" <<'CASE'
name: timed
title: Solves that are timed
suites: [smoke]
scene: {tabor: 0, radius: 93, outer_radius: inf, scheme: ring}
sweep: [{key: nodes, values: [63, 71, 83]}]
repeats: 2
want: [pull_off]
CASE
  cat >"$PULLOFF_DATA/cases/followed.yaml" <<'CASE'
name: followed
title: Lines that are followed
suites: [smoke]
scene: {radius: 93, outer_radius: 80, scheme: panel, tolerance: 1e-4, wavelength: 21}
sweep:
  - {key: amplitude_ratio, values: [0.01, 0.015, 0.02]}
  - {key: tabor, from: 0.5, to: 0.7, count: 4, scale: log}
follow: tabor
checkpoint_every: 3
want: [pull_off]
CASE
}
strip() { grep -v -E '"(seconds|date|jobs|checksum|openblas)"|^ *[0-9.]+(e-[0-9]+)?,?$' "$1"; }

# ends CODE ARGUMENT...: tests that the program ends with the exit code CODE; its output is not tested.
ends() {
  code=$1
  shift
  "$program" "$@" >"$work/stdout" 2>"$work/stderr"
  check "exit code $code of pulloff $*" test $? -eq "$code"
}

expect 2 'pulloff: --shard is 0/3: expected K/N, the K-th of N shards, such as 1/4' run --shard 0/3
expect 2 'pulloff: --shard is 4/3: expected K/N*' run --shard 4/3
expect 2 'pulloff: --shard is 2: expected K/N*' run --shard 2
expect 2 'pulloff: --shard is 1/: expected K/N*' run --shard 1/
expect 2 'pulloff: --shard is 1/2/3: expected K/N*' run --shard 1/2/3
expect 2 'pulloff: --points and --shard are given: expected one of them' run --shard 1/2 --points 0
expect 2 'pulloff: merge needs the folders of the shards (see pulloff merge --help)' merge
mkdir empty
expect 4 'pulloff: the folder empty contains no shard: expected *' merge empty
expect 4 'pulloff: the folder absent cannot be read: *' merge absent

write_cases 81
ends 0 run --output whole
# The shards are of three processors, as far as OpenBLAS can tell.
OPENBLAS_CORETYPE=Prescott ends 0 run --output part-1 --shard 1/3 --jobs 1
OPENBLAS_CORETYPE=Nehalem ends 0 run --output part-2 --shard 2/3 --jobs 2
ends 0 run --output part-3 --shard 3/3 --jobs 3
check 'no shard has a record of a case that is divided' test ! -e part-1/drawn/record.json -a ! -e part-2/drawn/record.json
ends 0 merge --output merged part-3 part-1 part-2
cp "$work/stderr" said
for name in drawn rigid timed followed; do
  strip whole/$name/record.json >at-once
  strip merged/$name/record.json >joined
  check "the record of $name is that of the whole run, but for times" cmp joined at-once
done
for table in drawn/curve-0.csv drawn/curve-6.csv rigid/profile-3.csv; do
  check "$table is the same" cmp merged/$table whole/$table
done
check 'every case is reported' test "$(grep -c 'within$' said)" -eq 4
expect 0 'drawn: 7 points, 1 check: within (kept)' run drawn --output merged
ends 0 merge --output part-1 part-1 part-2 part-3
ends 0 merge --output again part-1 part-2 part-3
strip again/drawn/record.json >joined
strip whole/drawn/record.json >at-once
check 'the folder of a shard that became the complete run can be merged again' cmp joined at-once

# Shards that are missing, given twice, damaged or not finished. (The folder part-1 has all points by now.)
rm -r part-1
ends 0 run --output part-1 --shard 1/3
expect 4 'pulloff: * of 7 points of drawn are lacking: expected all 3 shards, each finished; missing or not finished: 2/3' merge part-1 part-3
expect 4 'pulloff: *; missing or not finished: 1/3, 3/3' merge part-2
cp -r part-2 twin
ends 0 merge --output twins part-1 part-2 part-3 twin
ends 0 run drawn --output shared --shard 1/2
expect 2 'pulloff: shared/shard-1-of-2.json is of a run with another number of shards than part-1/shard-1-of-3.json: *' \
  merge part-1 shared part-3
cp -r part-2 torn
sed -i '1d' torn/drawn/points.jsonl
expect 4 'pulloff: 1 of 7 points of drawn is lacking: expected all 3 shards, each finished; missing or not finished: 2/3' \
  merge part-3 torn part-1
sed -i '1s/1/2/' torn/drawn/points.jsonl
expect 4 'pulloff: 2 of 7 points of drawn are lacking, and stored results were altered or damaged: *: 2/3' \
  merge part-3 torn part-1
ends 0 run --output torn --shard 2/3
ends 0 merge --output mended part-3 torn part-1
strip mended/drawn/record.json >joined
check 'an interrupted shard continues' cmp joined at-once
# A file with a wrong number of shards used to keep the program busy for ever.
mkdir lies
lie() { # NUMBER OF
  sed "s/\"shard\": 2/\"shard\": $1/; s/\"of\": 3/\"of\": $2/" part-2/shard-2-of-3.json >lies/shard-2-of-3.json
  "$python" "$here/../checksum.py" lies/shard-2-of-3.json
}
lie 2 9000000000000000000
expect 4 'pulloff: 7 of 7 points of drawn are lacking: expected all 9000000000000000000 shards, *' merge lies
lie 0 3
expect 4 'pulloff: lies/shard-2-of-3.json is damaged: *' merge lies
sed 's/"time_limit": null/"time_limit": 1/' part-2/shard-2-of-3.json >lies/shard-2-of-3.json
expect 4 'pulloff: lies/shard-2-of-3.json was altered: it does not have its checksum' merge lies
echo '{}' >torn/shard-2-of-3.json
expect 4 'pulloff: torn/shard-2-of-3.json is damaged: *' merge part-1 torn part-3

# Shards of another program, other cases, other scenes, or another time limit.
cp "$program" other-program
printf x >>other-program # the same numbers, but who knows
program_here=$program
program=$work/other-program
ends 0 run --output other --shard 2/3
expect 2 'pulloff: part-1/shard-1-of-3.json is of a run with another program than this one: expected shards of one run' merge part-1 part-2 part-3
program=$program_here
expect 2 'pulloff: other/shard-2-of-3.json is of a run with another program than part-1/*' \
  merge part-1 other part-3

ends 0 run drawn rigid --output less --shard 2/3
expect 2 'pulloff: less/* is of a run with other cases, or other scenes, at case rigid than part-1/shard-1-of-3.json: *' \
  merge part-1 less part-3
ends 0 run --output late --shard 2/3 --time-limit 600
expect 2 'pulloff: late/shard-2-of-3.json is of a run with another time limit than part-1/shard-1-of-3.json: *' \
  merge part-1 late part-3
for k in 1 3; do ends 0 run --output late --shard $k/3 --time-limit 600; done
ends 0 merge --output limited late
check 'the time limit of the shards applies' grep -q -e '--time-limit 600' limited/drawn/record.json
write_cases 91
expect 2 'pulloff: part-1/shard-1-of-3.json is of a run with other cases, or other scenes, at case drawn than this one: *' \
  merge part-1 part-2 part-3
ends 0 run --output mesh --shard 3/3
expect 2 'pulloff: mesh/shard-3-of-3.json is of a run with other cases, or other scenes, at case drawn than part-1/*' merge part-1 part-2 mesh
rm "$PULLOFF_DATA/cases/drawn.yaml"
expect 2 'pulloff: no case is named drawn: *' merge part-1 part-2 part-3

# A solve that fails in a shard fails in the merged run, too.
sed -i 's/scheme: ring}/scheme: ring, time_limit: 1e-9}/' "$PULLOFF_DATA/cases/timed.yaml"
ends 3 run timed --output failed --shard 1/1
ends 3 merge --output failures failed
finish
