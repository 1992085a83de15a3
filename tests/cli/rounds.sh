#!/bin/sh
# Timed solvers: rounds that alternate with this program, the times of each round, all values of a knob.
# shellcheck disable=SC1091,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/manifest.sh"
most=1 limit=60
cat >timed.yaml <<END
name: timed
title: Smooth spheres
suites: [own]
scene: {radius: 100, outer_radius: inf, approach_end: -1}
sweep:
  - {key: tabor, values: [0.5, 1, 3]}
  - together: [{scheme: triangle, nodes: 31}, {scheme: panel, tolerance: 1e-3}]
repeats: 3
want: [pull_off]
measure:
  - {quantity: pull_off_force, reference: reference/feng_pull_off.csv}
END

manifest good 'knob: {name: nodes, values: [10, 20]}'
manifest slow_clock
if ! "$program" run timed.yaml --solver pulloff --solver good.yaml --solver slow_clock.yaml --knob all --output run --jobs 2 >stdout 2>stderr; then cat stderr; fi
cat >read.py <<'END'
import json, statistics, sys
ours, *others = [json.load(open(f"run/{name}timed/record.json")) for name in
                 ("", "solvers/good@10/", "solvers/good/", "solvers/slow_clock/")]
assert all("timing" not in point for point in ours["points"])
for record in others:
    assert [point["status"] for point in record["points"]] == 4 * ["ok"] + 2 * ["unsupported"], record["solver"]
    assert len(record["measured"]) == 4
    # two questions, because pairs of points differ only in the mesh of pulloff, and three rounds of each
    assert [p["asked"] for p in record["solver"]["processes"]] == 6 * [1], record["solver"]["processes"]
    for point in record["points"][:4]:
        timing = point["timing"]
        assert timing["interleaved"] is True
        assert point["seconds_all"] == 3 * [1e-3] and timing["first_seconds"] == 3 * [1e-3], point
        assert point["work"]["seconds"] == statistics.median(point["seconds_all"])
        for key in ("process_seconds", "process_processor_seconds", "start_seconds", "start_processor_seconds"):
            assert len(timing[key]) == 3 and min(timing[key]) > 0, (key, timing)
        for cpu, whole, start in zip(point["processor_seconds_all"], timing["process_processor_seconds"],
                                     timing["start_processor_seconds"]):
            assert abs(cpu - max(whole - start, 0) / 2) < 1e-12, point
        slow = record["solver"]["name"] == "slow_clock"
        assert not slow or min(timing["process_seconds"]) > 2, timing
    assert record["points"][0]["timing"] == record["points"][1]["timing"]
    assert record["points"][5]["timing"]["process_seconds"] == 3 * [None]
END
check 'the records have the times of the rounds' "$python" read.py
if ! "$program" verify timed.yaml --solver slow_clock.yaml --output run >stdout 2>stderr; then cat stderr; fi
check 'the record was kept' grep -q kept stderr
# A run without this program, of a solver that fails.
manifest slow_failure
if ! "$program" run timed.yaml --solver slow_failure.yaml --output run >stdout 2>stderr; then :; fi
check 'the rounds of a run without pulloff are not interleaved' grep -q '"interleaved": false' run/solvers/slow_failure/timed/record.json
# A long first solve is not repeated: the process is ended, and the time is that of the one solve.
manifest long
if ! "$program" run timed.yaml --points 0-1 --solver long.yaml --output run >stdout 2>stderr; then cat stderr; fi
cat >read.py <<'END'
import json
point = json.loads(open("run/solvers/long/timed/points.jsonl").readline())
timing = point["timing"]
assert point["status"] == "ok" and timing["first_seconds"] == point["seconds_all"] == 3 * [1e-3], point
assert all(6.5 < seconds < 30 for seconds in timing["process_seconds"]), timing
for cpu, whole, start in zip(point["processor_seconds_all"], timing["process_processor_seconds"], timing["start_processor_seconds"]):
    assert abs(cpu - max(whole - start, 0)) < 1e-12, point
END
check 'a long solve is not repeated' "$python" read.py
check 'nothing of it is left' [ -z "$(find run/solvers/long -name 'ask-*')" ]
# A point is stored after its last round, which for long solves is the first one, and not only at the end of all rounds.
manifest busy
"$program" run timed.yaml --points 0-3 --solver busy.yaml --output run 2>/dev/null &
child=$!
wait_for test -s run/solvers/busy/timed/points.jsonl
kill -9 $child
wait $child 2>/dev/null
if ! "$program" run timed.yaml --points 0-3 --solver busy.yaml --output run >stdout 2>stderr; then cat stderr; fi
check "an interrupted run keeps what took long: $(cat stderr)" grep -qE '^busy:timed: 4 of 6 points, .* \([24] points kept\)' stderr
check 'one round of long solves' [ "$("$python" -c "
import json
print(sorted({len(point['seconds_all']) for point in json.load(open('run/solvers/busy/timed/part.json'))['points'][:4]}))")" = '[1]' ]
# Times that are kept were not taken in the rounds in which this program solves the points again.
interleaved() { # VALUES: runs both, and tests what the record of the solver says of its four points.
  if ! "$program" run timed.yaml --points 0-3 --solver pulloff --solver good.yaml@10 --output mixed >stdout 2>stderr; then cat stderr; fi
  check "interleaved: $1" [ "$("$python" -c "
import json
points = json.load(open('mixed/solvers/good@10/timed/part.json'))['points'][:4]
print(*[point['timing']['interleaved'] for point in points])")" = "$1" ]
}
interleaved 'True True True True'
rm mixed/timed/points.jsonl
"$python" -c "
import json, pathlib
store = pathlib.Path('mixed/solvers/good@10/timed/points.jsonl')
store.write_text(''.join(line + '\n' for line in store.read_text().splitlines()[:2]))"
interleaved 'False False True True'
# Nor those of a whole record, which is written again with that.
whole() { # WHAT VALUE: whether the record of the solver has a point that was timed in the rounds of this program
  check "$1" [ "$("$python" -c "
import json
print(any(point['timing']['interleaved'] for point in json.load(open('whole/solvers/good@10/timed/record.json'))['points']))")" = "$2" ]
}
again='run timed.yaml --solver pulloff --solver good.yaml@10 --output whole'
# shellcheck disable=SC2086 # words
if ! "$program" $again >stdout 2>stderr; then cat stderr; fi
whole 'a whole record in the rounds of this program' True
cp whole/solvers/good@10/timed/record.json before.json
# shellcheck disable=SC2086
if ! "$program" $again >stdout 2>stderr; then cat stderr; fi
check 'without new solves a record stays' cmp -s before.json whole/solvers/good@10/timed/record.json
rm -r whole/timed
# shellcheck disable=SC2086
if ! "$program" $again >stdout 2>stderr; then cat stderr; fi
check 'the solver keeps its record' grep -q '^good@10:timed: 6 points, .* (kept)$' stderr
whole 'a whole record that is kept while this program solves the points again' False
manifest part 'knob: {name: nodes, values: [10, 20]}'
sed -i 's/, part,/, good,/' part.yaml
if ! "$program" run timed.yaml --solver part.yaml@20 --solver part.yaml@10 --solver good.yaml@10 --output some >stdout 2>stderr; then cat stderr; fi
check 'values of knobs by name' [ "$(cd some/solvers && echo *)" = 'good@10 part part@10' ]
expect 2 'pulloff: --solver names part twice: expected each solver once' run timed.yaml --solver part.yaml@20 --solver part.yaml
expect 2 'pulloff: --knob is 30: expected one of the values of the knob in the manifest' run timed.yaml --solver part.yaml@30
expect 4 'pulloff: absent.yaml cannot be opened: *' run timed.yaml --solver absent.yaml@30
expect 2 'pulloff: explain takes one value of the knob: expected --knob VALUE' explain timed.yaml --solver good.yaml --knob all
finish
