#!/bin/sh
# After Ctrl-C a run ends with exit code 130 and keeps all finished cases; the next run continues.
# shellcheck disable=SC1091,SC2013,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"

write_long() { # NAME NODES
  cat >"$PULLOFF_DATA/cases/$1.yaml" <<CASE
name: $1
title: Elastic spheres
suites: [smoke]
scene: {radius: 100, outer_radius: inf, scheme: triangle, nodes: $2}
sweep:
  - key: tabor
    values: [0.9, 1.1, 1.3, 1.5, 1.7, 1.9]
want: [pull_off, curve]
CASE
}

interrupt() { # SIGNAL
  : >"$work/stderr" # that of the last run has the line for which this one waits
  "$program" run --output run --jobs 2 2>"$work/stderr" &
  child=$!
  wait_for grep -q "^good: " "$work/stderr" # it hears signals by then, also where it starts slowly
  sleep 0.2
  kill -"$1" $child
  wait $child
}

stop_after() { # SECONDS: interrupts the program that was started last; returns its exit code.
  child=$!
  wait_for hears
  sleep "$1"
  kill -INT $child
  wait $child
}

write_long long 801
# A shell starts background jobs with SIGINT ignored. The program must handle the signal nevertheless.
interrupt INT
check 'exit code 130 after SIGINT' test $? -eq 130
check 'the message says that it was interrupted' grep -q 'pulloff: interrupted; finished points are kept in run' "$work/stderr"
check 'the finished case is kept' test -s run/good/record.json
check 'the other case has no record' test ! -e run/long/record.json
interrupt TERM
check 'exit code 130 after SIGTERM' test $? -eq 130
expect_line() { check "$1: $2" grep -q "^$2" "$work/stderr"; }
rm "$PULLOFF_DATA/cases/long.yaml"
write_long long 101
"$program" run --output run --jobs 2 2>"$work/stderr"
check 'the next run continues' test $? -eq 0
expect_line 'finished before' 'good: 1 point, 1 check: within (kept)'
expect_line 'finished now' 'long: 6 points, 0 checks: within'
"$program" run --output run 2>"$work/stderr"
expect_line 'all kept' 'long: 6 points, 0 checks: within (kept)'

# The evaluation of closed forms can be interrupted, too. The points of the case are not solved again after that.
write_lines() { # COUNT
  cat >"$PULLOFF_DATA/cases/drawn.yaml" <<CASE
name: drawn
title: A point and many closed forms
suites: [smoke]
scene: {tabor: 0, radius: 100, wavelength: 20, outer_radius: inf, scheme: ring, nodes: 101}
want: [pull_off, curve]
lines:
  - name: along
    theory: guduru
    sweep:
      - {key: amplitude, from: 1, to: 5, count: 9}
      - {key: tabor, from: 0.01, to: 5, count: $1, scale: log}
CASE
}
write_lines 10000
"$program" run drawn --output lines 2>"$work/stderr" &
child=$!
wait_for test -s lines/drawn/curve-0.csv # written before the lines are made
kill -INT $child
wait $child
check 'exit code 130 after SIGINT during closed forms' test $? -eq 130
check 'the closed forms are not completed' test ! -e lines/drawn/line-along.csv
check 'there is no record' test ! -e lines/drawn/record.json
write_lines 2
expect 0 'drawn: 1 point, 0 checks: within (kept)' run drawn --output lines
check 'the next run writes the record' test -s lines/drawn/record.json
rm "$PULLOFF_DATA/cases/drawn.yaml"

"$program" solve --tabor 3 --scheme triangle --nodes 1501 --json >out.json 2>"$work/stderr" &
stop_after 0.2
check 'exit code 130 of an interrupted solve' test $? -eq 130
check 'the JSON document states the interruption' grep -q '"status": "interrupted"' out.json

# A series, in its first scene, which is traced, and later.
for scenes in '10 --to 11 --points 2 --amplitude 3 --wavelength 8 --tolerance 1e-8' '2 --to 5 --points 9000'; do
  for of in folds pull-off; do
    # shellcheck disable=SC2086 # words
    "$program" follow --of $of --key tabor --from $scenes >"$work/stdout" 2>"$work/stderr" &
    stop_after 0.4
    check "exit code 130 of an interrupted series of $of from tabor $scenes" test $? -eq 130
    check 'its message' grep -qx 'pulloff: interrupted' "$work/stderr"
    check 'no result is printed' test ! -s "$work/stdout"
  done
done

finish
