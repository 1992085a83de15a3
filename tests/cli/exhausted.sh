#!/bin/sh
# If memory, address space or disk space runs out, the program ends with a message and an exit code. It does not hang,
# leaves no damaged file, and the next run continues.
# shellcheck disable=SC1091,SC2013,SC2016,SC2034,SC2154,SC3045
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
rm "$PULLOFF_DATA/cases/good.yaml"

cat >"$PULLOFF_DATA/cases/parts.yaml" <<'CASE'
name: parts
title: Spheres at random
suites: [smoke]
scene: {outer_radius: inf, scheme: triangle, nodes: 61}
sample:
  seed: 5
  count: 6
  keys:
    - {key: tabor, from: 0.7, to: 1.3}
    - {key: radius, from: 70, to: 200}
want: [pull_off]
CASE
store=parts/points.jsonl
strip() { grep -v -E '"(seconds|date|jobs|checksum)"|^ *[0-9.]+(e-[0-9]+)?$' "$1"; }

expect 0 'parts: 6 points, 0 checks: within' run --jobs 1 --output whole
strip whole/parts/record.json >at-once

# A limit of the file size acts like a disk that fills up in the middle of a line. The next run continues after what was
# written of it.
(
  ulimit -f 8
  "$program" run --jobs 1 --output limited 2>stderr
  echo $? >code
)
check 'exit code 4 at the file-size limit, no signal' test "$(cat code)" -eq 4
check 'the message names the file and the reason' \
  grep -q '^pulloff: limited/parts/points.jsonl cannot be written: \(File too large\|No space left on device\)$' stderr
kept=$(wc -l <limited/$store)
check 'some points are kept' test "$kept" -ge 1
[ "$kept" -eq 1 ] && points=point || points=points
expect 0 "parts: 6 points, 0 checks: within ($kept $points kept)" run --jobs 1 --output limited
strip limited/parts/record.json >mended
check 'the record is that of an undisturbed run' cmp mended at-once
(
  ulimit -f 2
  "$program" solve --tabor 0 --curve curve.csv >/dev/null 2>stderr
  echo $? >code
)
check 'exit code 4 if a curve cannot be written' test "$(cat code)" -eq 4
check 'no part of the curve is left' test -z "$(find . -name 'curve.csv*')"

# A small stack suffices: a solve took 1.2 MB.
(
  ulimit -s 128
  "$program" solve --tabor 1 --want hysteresis,preload,diagnostics,curve,profile >/dev/null 2>stderr
  echo $? >code
)
check 'a stack of 128 kB suffices' test "$(cat code)" -eq 0

# A point that ran out of memory is no result.
expect 0 'parts: 3 of 6 points, 0 checks: within' run --jobs 1 --output starved --points 0-2
sed -i '2s/"status":"ok"/"status":"no_memory"/' starved/$store
mends parts 1 0 'parts: 6 points, 0 checks: within (2 points kept)' run --jobs 1 --output starved

# With little address space, OpenBLAS used to request its work area for ever and to ignore SIGTERM.
if grep -q __asan_init "$program"; then
  echo 'skipped: little address space (the address sanitizer needs much)'
else
  for room in 60000 100000 140000 180000 200000 250000 300000 400000; do
    (
      ulimit -v $room
      timeout -k 1 60 "$program" solve --tabor 1 >stdout 2>stderr
      echo $? >code
    )
    case $(cat code) in
    0) check "a result within $room kB" grep -q '^pull-off force 1.67066' stdout ;;
    3)
      check "refused with one line within $room kB" grep -q '^pulloff: the solve failed: out of memory' stderr
      ;;
    127) check "not started within $room kB" grep -q 'error while loading shared libraries' stderr ;;
    *) check "an end within $room kB" false ;;
    esac
  done
  check 'with enough address space there is a result' test "$(cat code)" -eq 0
  # Only condition numbers need OpenBLAS, and its work area.
  (
    ulimit -v 180000
    timeout -k 1 60 "$program" solve --tabor 1 --scheme triangle --nodes 61 >stdout 2>stderr
    echo $? >code
    timeout -k 1 60 "$program" solve --tabor 1 --scheme triangle --nodes 61 --want diagnostics >stdout 2>stderr
    echo $? >>code
  )
  check 'a result without diagnostics' test "$(tr '\n' ' ' <code)" = '0 3 '
  check 'the message says what is needed' grep -q 'OpenBLAS needs 129 MB of address space' stderr
fi
finish
