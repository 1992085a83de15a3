#!/bin/sh
# A solve ends at its time limit, and hears a signal, wherever it is: in a factorisation, in the quadrature of a rigid load,
# in a closed form beside it. The scenes are far outside the documented domain. Each took from 20 s to many minutes. The
# kernel ends what takes more than 8 s of processor time.
# shellcheck disable=SC1091,SC2034,SC2154
. "$(dirname "$0")/lib.sh"

limited() { # NAME EXIT ARGUMENTS
  name=$1
  expected=$2
  shift 2
  (
    ulimit -t 8
    "$program" solve --time-limit 1 "$@" >out 2>"$work/stderr"
    echo $? >code
  )
  check "$name: exit code $expected" test "$(cat code)" -eq "$expected"
  check "$name: a line says why" test -s out
}
limited 'last minimum of 5e9 waves' 3 --tabor 1e-6 --radius 1e5 --amplitude 1e5 --wavelength 0.01
limited 'JKR curve of a long wave' 3 --tabor 1e-5 --radius 100 --amplitude 1000 --wavelength 1e5 --outer-radius 1 --want hysteresis
check 'the theories are named' grep -q 'the branch is traced, but the theories beside it are not evaluated' "$work/stderr"
limited 'rigid load with a long sum' 3 --tabor 0 --profile cone:7.06501e-06 --radius 2283.75 --wave 28.0569,31.4525 \
  --law mie:7.35350115,20.5499121 --want preload
awk 'BEGIN { print "r,gap"; for (k = 0; k < 120000; ++k) printf "%.17g,%.17g\n", k/2000, k*k/8e8 }' >rows.csv
limited 'JKR curve of a table of 120,000 rows' 3 --tabor 1 --profile-file rows.csv --want hysteresis
check 'the pull-off of a table takes no longer than its rows' sh -c \
  "ulimit -t 8; '$program' solve --tabor 1 --profile-file rows.csv >out"
limited 'many waves on a stiff sphere' 3 --tabor 35839 --wave 0.001,0.2 --wave 0.01,0.5 --wave 1,70 --wave 0.13,6 \
  --wave 10,300 --wave 0.15,8 --wave 0.16,1

"$program" solve --tabor 1 --profile-file rows.csv --want hysteresis --json >out.json 2>"$work/stderr" &
child=$!
wait_for hears
sleep 0.5
kill -INT $child
wait $child
check 'exit code 130 of a solve interrupted in a closed form' test $? -eq 130
check 'the JSON document states the interruption' grep -q '"status": "interrupted"' out.json
finish
