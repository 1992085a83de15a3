#!/bin/sh
# Cases that an external solver solves: verdicts, coverage, what is kept, shards, pins, explanations.
# shellcheck disable=SC1091,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/manifest.sh"

write_case() { # NAME TABORS
  cat >"$1.yaml" <<END
name: $1
title: Smooth spheres
suites: [own]
scene: {radius: 100, outer_radius: inf}
sweep:
  - together: [{scheme: panel}, {scheme: triangle, nodes: 51}]
  - {key: tabor, values: [$2]}
want: [pull_off]
checks:
  - {quantity: pull_off_force, reference: reference/feng_pull_off.csv, tolerance: 1e-2, kind: abs, because: b}
  - {quantity: contact_radius, reference: reference/feng_pull_off.csv, tolerance: 1.5, kind: abs, because: b}
  - {quantity: folds, reference: reference/feng_landmarks.csv, tolerance: 1e-2, kind: abs, because: b}
END
}
printed() { # PATTERN: tests that standard output or standard error has a line with the pattern.
  check "a line with: $1; there is: $(cat "$work/stdout" "$work/stderr")" grep -qE "$1" "$work/stdout" "$work/stderr"
}
value() { # FILE EXPRESSION: prints a value of a record.
  $python -c "import json, sys; r = json.load(open(sys.argv[1])); print($2)" "$1"
}
go() { # CODE ARGUMENT...: runs the program; the exit code must be CODE.
  want=$1
  shift
  "$program" "$@" >"$work/stdout" 2>"$work/stderr"
  got=$?
  check "pulloff $*: exit code $got, expected $want: $(cat "$work/stderr")" [ $got -eq "$want" ]
}

# A good solver: its verdicts, its coverage, its record. Points that differ only in our mesh are asked once.
manifest good
write_case judged '0.5, 1, 2, 3'
go 0 verify judged.yaml --solver good.yaml --output run
printed '^solver   good \(good.yaml\)'
printed '^command  /usr/bin/python3'
printed '^good:judged .*coverage 8/8 points, 16/24 checks'
printed '^16 checks pass'
record=run/solvers/good/judged/record.json
check 'the record names the solver' [ "$(value $record "r['solver']['name']")" = good ]
check 'four questions are asked for eight points' [ "$(value $record "sum(p['asked'] for p in r['solver']['processes'])")" = 4 ]
check 'both meshes have the answer' \
  [ "$(value $record "r['points'][0]['pull_off']['force'] == r['points'][4]['pull_off']['force'] > 1.7")" = True ]
check 'our records are untouched' [ ! -e run/judged ]
check 'no folder of a process is left' [ -z "$(find run -name 'ask-*')" ]
go 0 run judged.yaml --solver good.yaml --output run
printed 'good:judged: 8 points, 16 checks: within \(kept\)'

# What the manifest excludes is left out, and the coverage says so.
most=1.5
manifest part
sed 's/^solver: part/solver: part/; s/, part,/, good,/' part.yaml >part.tmp && mv part.tmp part.yaml
most=
go 0 verify judged.yaml --solver part.yaml --output run
printed '^part:judged .*coverage 4/8 points, 8/24 checks'
printed '^part:judged: the manifest excludes 4 of 8 points; the first, .*tabor=2, is not asked: tabor is 2: outside the values that the manifest declares$'
check 'a point that is left out says why' [ "$(value run/solvers/part/judged/record.json \
  "r['points'][2]['status'], r['points'][2]['reason'], r['points'][2]['failed']")" = \
  'unsupported not asked: tabor is 2: outside the values that the manifest declares False' ]

# A solver of elastic bodies is not asked about a viscoelastic one.
cat >creeps.yaml <<END
name: creeps
title: A viscoelastic sphere
suites: [own]
scene: {tabor: 1, radius: 100, outer_radius: inf, scheme: panel, preload: 3, viscoelastic: 'sls:0.2', unload_speed: 1}
want: [pull_off]
END
"$program" verify creeps.yaml --solver good.yaml --output run >"$work/stdout" 2>"$work/stderr"
printed 'is not asked: viscoelastic is sls:0.2: the manifest does not declare this key$'

# Several solvers at once, one of them this program.
go 0 verify judged.yaml --solver good.yaml --solver pulloff --output run --points 0-3
printed '^good:judged .*coverage 4/8 points, 8/24 checks'
printed '^judged +24 +0'
expect 2 'pulloff: --solver names good twice: expected each solver once' \
  verify judged.yaml --solver good.yaml --solver good.yaml
expect 2 'pulloff: explain takes one solver: expected --solver once' \
  explain judged.yaml --solver good.yaml --solver pulloff
for solver in '' '--solver pulloff' '--solver good.yaml@10'; do
  # shellcheck disable=SC2086 # words
  expect 2 'pulloff: --knob is 3: expected it with --solver MANIFEST, whose knob it is' run judged.yaml $solver --knob 3
done
expect 4 'pulloff: absent.yaml cannot be opened: *' run judged.yaml --solver absent.yaml

# A planted factor: verify fails, explain names it.
manifest pi
go 1 verify judged.yaml --solver pi.yaml --output run
printed '^    pulloff explain judged.yaml --point 0 --solver pi.yaml --output run'
go 1 explain judged.yaml --solver pi.yaml --output run
printed 'fault +solver: the results of pi are the expected values times pi at all 8 points'
printed '^  rerun      pulloff verify judged.yaml --points 0 --solver pi.yaml --fresh --verbose --output run$'
printed '^  compare    pulloff solve --tabor 0.5 --radius 100 '
again=$(sed -n '0,/^  rerun/s/^  rerun      pulloff //p' "$work/stdout" | head -n 1)
# shellcheck disable=SC2086 # the words of the command are meant
go 1 $again
printed 'pull_off_force .* outside'
check 'the record names the solver in its commands' [ "$(value run/solvers/pi/judged/record.json \
  "r['command'] == 'pulloff run judged.yaml --solver pi.yaml' and 'solver pi.yaml' in r['points'][0]['command']")" = True ]

# Of a table of one's own that is published, explain does not say that it "was computed by an independent method".
write_table() { # KIND FACTOR
  printf 'tabor,force\n' >own.csv
  grep -v '^#' "$root/reference/feng_pull_off.csv" | awk -F, -v factor="$2" '$1 == 1 || $1 == 2 {print $1 "," $2 * factor}' >>own.csv
  "$program" seal --what a --source b --kind "$1" --method c --units d --uncertainty 0.001 own.csv >"$work/stdout"
}
cat >own.yaml <<'END'
name: own
title: A table of one's own
suites: [own]
scene: {radius: 100, outer_radius: inf, scheme: panel}
sweep: [{key: tabor, values: [1, 2]}]
want: [pull_off]
checks: [{quantity: pull_off_force, reference: own.csv, tolerance: 0.01, kind: abs, because: b}]
END
for kind in published oracle; do
  write_table $kind 1.02
  go 1 explain own.yaml --solver good.yaml --output own
  if [ $kind = published ]; then
    printed 'fault +solver: own.csv is a published table: check good first, .*then the publication and its digitisation'
  else
    printed 'fault +solver: own.csv was computed by an independent method'
  fi
done

# explain asks only for the points that it explains, and uses those that are known.
manifest pi
go 1 verify judged.yaml --solver pi.yaml --output few --points 0-1
go 1 explain judged.yaml --solver pi.yaml --output few --point 2
printed 'pi:judged: 3 of 8 points, .*\(2 points kept\)'
printed 'the results of pi are the expected values times pi at all 3 points'
check 'the record of some points' \
  [ "$(value few/solvers/pi/judged/part.json "r['solver']['coverage']['asked'], r['solver']['coverage']['points']")" = '3 8' ]
check 'no record of all points' [ ! -e few/solvers/pi/judged/record.json ]
check 'points that were not asked have not failed' \
  [ "$(value few/solvers/pi/judged/part.json "[p['failed'] for p in r['points']] == 8 * [False], r['points'][5]['reason']")" = \
  'True not asked: the run was limited to other points' ]
go 0 run judged.yaml --solver pi.yaml --output few
check 'the record of all points replaces it' [ ! -e few/solvers/pi/judged/part.json ]

# A failure is a status of its point; the others are judged. conform.sh has the other kinds of failure.
# What ends the process does so again at the second point of the next one.
for mode in crash:4 hang:4 skip:6; do
  solved=${mode#*:}
  mode=${mode%:*}
  manifest $mode 'start_limit: 5'
  go 3 verify judged.yaml --solver $mode.yaml --output run --jobs 1
  check "$mode: $solved points are solved: $(cat "$work/stdout")" \
    [ "$(value run/solvers/$mode/judged/record.json "[p['status'] for p in r['points']].count('ok')")" = $solved ]
done
for pair in crash:crashed hang:timed_out skip:no_answer; do
  check "$pair" [ "$(value run/solvers/${pair%:*}/judged/record.json "r['points'][1]['status']")" = ${pair#*:} ]
done

# Killed, the program leaves no solver behind. tests/robust/store.py kills it at random moments.
limit=20
manifest slow # no answer is late, however busy the machine is
limit=
write_case long '0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 1, 1.25, 1.5'
"$program" run long.yaml --solver slow.yaml --output lost --jobs 1 2>/dev/null &
child=$!
wait_for test -s lost/solvers/slow/long/points.jsonl
kill -9 $child
wait $child 2>/dev/null
sleep 0.2
check 'the solver does not outlive the program' [ -z "$(pgrep -f "responder.py slow .*$work" || true)" ]
# An answer that only the response of a killed process has is taken from there.
rm lost/solvers/slow/long/points.jsonl
go 0 run long.yaml --solver slow.yaml --output lost --jobs 1
printed 'slow:long: 24 points, .* \([1-9][0-9]* points kept\)'
check 'nothing is left of the killed process' [ -z "$(find lost -name 'ask-*')" ]

# Shards, merged, are the whole.
for k in 1 2; do
  go 0 run judged.yaml --solver good.yaml --shard $k/2 --output shards/$k
done
go 0 merge shards/1/solvers/good shards/2/solvers/good --solver good.yaml --output merged
strip() { $python -c "
import json, sys
r = json.load(open(sys.argv[1]))
print([(p['id'], p['status'], p['pull_off'], p['folds']) for p in r['points']], r['checks'], r['solver']['coverage'])" "$1"; }
strip merged/solvers/good/judged/record.json >a
strip run/solvers/good/judged/record.json >b
check 'the merged record is that of one run' cmp a b

# With all values of its knob, merge would solve with those that the shards do not have.
expect 2 'pulloff: merge takes one value of the knob: expected --knob VALUE' \
  merge shards/1/solvers/good shards/2/solvers/good --solver good.yaml --knob all

# Times that a solver does not report are left out: they made the time of a merged case null, and that of a failed test nan.
for k in 1 2; do
  go 0 run judged.yaml --solver part.yaml --shard $k/2 --output parts/$k
done
go 0 merge parts/1/solvers/part parts/2/solvers/part --solver part.yaml --output parts
check 'the time of the merged case' [ "$(value parts/solvers/part/judged/record.json "r['seconds'] > 0")" = True ]
go 3 verify judged.yaml --solver crash.yaml --output run --junit junit.xml
check 'a time for each test' [ "$(grep -c 'time="[0-9.]*"' junit.xml)" -eq "$(grep -c 'time=' junit.xml)" ]
expect 2 'pulloff: * is of a run with another program*' merge shards/1/solvers/good shards/2/solvers/good

# Only results of this program are pinned.
expect 2 'pulloff: unknown option --solver of bless *' bless judged.yaml --solver good.yaml --reason first
manifest scalar
go 0 verify judged.yaml --solver scalar.yaml --output run
printed '^scalar:judged .*coverage 8/8 points, 16/24 checks'

# The step of a solver that locates jumps with one. It makes no tolerance slack.
unstable=false
manifest shifted 'approach_step: 1500'
write_case steps '1, 2'
sed -i 's/contact_radius,\(.*\)1.5/pull_off_approach,\11e-3/' steps.yaml
go 0 verify steps.yaml --solver shifted.yaml --output run --verbose
printed 'pull_off_approach .* within$'
check 'the tolerance is not slack' fails grep -q 'pull_off_approach .* slack' stdout
# The explanation names it beside the tolerance of the case, which alone does not give the ratio.
manifest shifted 'approach_step: 0.5'
go 1 explain steps.yaml --solver shifted.yaml --output run
printed '^  difference -1, 1.996 times the tolerance of 1e-3 abs$'
printed '^  note       the approach step of the solver, 0.5, is added to the tolerance$'

finish
