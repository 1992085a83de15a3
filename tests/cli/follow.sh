#!/bin/sh
# The pull-off of a series of scenes: the verb follow, and cases with the key `follow`.
# shellcheck disable=SC1091,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
file=$PULLOFF_DATA/cases/good.yaml

expect 2 'pulloff: --key is not given: expected --key, --from and --to' follow --from 1 --to 2
expect 2 'pulloff: --from is not given: expected --key, --from and --to' follow --key tabor --to 2
expect 2 'pulloff: --to is not given: expected --key, --from and --to' follow --key tabor --from 2 --scale linear
expect 2 'pulloff: --from is 2 and --to is 2: expected two different values > 0, or --scale linear' \
  follow --key tabor --from 2 --to 2
expect 2 'pulloff: --key is scheme: expected *' follow --key scheme --from 1 --to 2
expect 2 'pulloff: --tabor is given, but its value varies (--key): *' follow --key tabor --from 1 --to 2 --tabor 1
expect 2 'pulloff: --from is 0 and --to is 2: expected two different values > 0, or --scale linear' \
  follow --key tabor --from 0 --to 2
expect 2 'pulloff: a waviness is given without --wavelength*' follow --key tabor --from 1 --to 2 --amplitude 1
expect 2 'pulloff: both amplitude and amplitude-ratio are given*' \
  follow --key amplitude --from 1 --to 2 --amplitude-ratio 0.1 --wavelength 20
expect 2 'pulloff: --radius is -3: *' follow --key tabor --from 1 --to 2 --radius -3
expect 2 'pulloff: --points is 1: *' follow --key tabor --from 1 --to 2 --points 1

# Amplitude and wavelength in proportion: a followed value equals that of a trace.
expect 0 '' follow --key wavelength --from 17.3 --to 24.1 --points 7 --amplitude-ratio 0.0385 --tabor 0.71 \
  --tolerance 1e-5 --json
cp "$work/stdout" line.json
python=$(command -v python3)
field() { # FILE EXPRESSION, of the document d
  "$python" -c 'import json, sys; d = json.load(open(sys.argv[1])); print(eval(sys.argv[2]))' "$1" "$2"
}
check 'the ends are traced, the other scenes followed' test \
  "$(field line.json '[p["followed"] for p in d["points"]] == [False] + 5 * [True] + [False]')" = True
check 'a followed scene has no folds' test "$(field line.json 'd["points"][3]["folds"]')" = None
for k in 2 5; do
  "$program" solve --tolerance 1e-5 --tabor 0.71 --wavelength "$(field line.json "d['points'][$k]['input']['wavelength']")" \
    --amplitude "$(field line.json "d['points'][$k]['input']['amplitude']")" --json >solve.json
  for value in force approach; do
    error=$([ $value = force ] && echo error_estimate || echo approach_error_estimate)
    a=$(field line.json "d['points'][$k]['pull_off']['$value']")
    b=$(field solve.json "d['pull_off']['$value']")
    e=$(field solve.json "d['pull_off']['$error']")
    f=$(field line.json "d['points'][$k]['pull_off']['$error']")
    check "$value of point $k: $a followed, $b traced" \
      awk -v a="$a" -v b="$b" -v e="$e" -v f="$f" 'BEGIN { d = a - b; exit !(a != "" && (d < 0 ? -d : d) <= e + f) }'
  done
done

# Followed folds equal those of traces and end where two of them merge (mu = 0.697).
expect 2 'pulloff: --of is fold: expected pull-off or folds' follow --key tabor --from 1 --to 2 --of fold
expect 2 'pulloff: folds are not followed from scene 1 to the next: *' follow --key amplitude --from 0 --to 1 \
  --scale linear --points 3 --wavelength 20 --of folds
expect 0 '' follow --of folds --key tabor --from 1.35 --to 0.61 --points 6 --scale linear --radius 87 --json
cp "$work/stdout" folds.json
check 'the first scene is traced, the others followed' test \
  "$(field folds.json '[p["followed"] for p in d["points"]] == [False] + 5 * [True]')" = True
check 'two folds until they merge' test \
  "$(field folds.json '[[f["kind"] for f in p["folds"] if f["approach"]] for p in d["points"]] == 5 * [["jump_in", "jump_out"]] + [[]]')" = True
"$program" solve --tabor "$(field folds.json 'd["points"][3]["input"]["tabor"]')" --radius 87 --json >solve.json
for value in approach load; do
  error=$([ $value = load ] && echo load_error_estimate || echo error_estimate)
  for j in 0 1; do
    a=$(field folds.json "d['points'][3]['folds'][$j]['$value']")
    b=$(field solve.json "d['folds'][$j]['$value']")
    e=$(field solve.json "d['folds'][$j]['$error']")
    f=$(field folds.json "d['points'][3]['folds'][$j]['$error']")
    check "$value of fold $j: $a followed, $b traced" \
      awk -v a="$a" -v b="$b" -v e="$e" -v f="$f" 'BEGIN { d = a - b; exit !(a != "" && (d < 0 ? -d : d) <= e + f) }'
  done
done

# A case with two series.
restore
write_case() { # what differs
  cat >"$file" <<CASE
name: good
title: Lines that are followed
suites: [smoke]
scene: {radius: 93, outer_radius: 80, scheme: panel, tolerance: 1e-4, wavelength: 21}
sweep:
  - {key: amplitude_ratio, values: [0.01, 0.02]}
  - {key: tabor, from: 0.5, to: 0.9, count: 6, scale: log}
$1
checks:
  - {quantity: solved_share, reference: every_scene, tolerance: 0.01, kind: abs, because: all have}
CASE
}
write_case 'follow: amplitude_ratio
want: [pull_off]'
expect 2 '*follow is amplitude_ratio: expected the last key of the sweep*' plan good
write_case 'follow: tabor
want: [folds]'
expect 2 '*want?1? is folds: expected pull_off alone*' plan good
write_case 'checkpoint_every: 3
want: [pull_off]'
expect 2 '*checkpoint_every is 3: expected*beside follow' plan good
write_case 'follow: tabor
repeats: 2
want: [pull_off]'
expect 2 '*repeats is 2: expected 1*' plan good
write_case 'follow: tabor
checkpoint_every: 4
want: [pull_off]'
expect 0 '' plan good
check 'the plan lists the series' grep -q 'in tabor along 2 series of 6 scenes; every 4 scenes one is traced' "$work/stdout"
expect 0 'good: 12 points, 1 checks: within' run good --output whole --jobs 2
check 'most scenes are followed' test "$(field whole/good/record.json 'sum(p["followed"] for p in d["points"])')" -ge 6

# A series is solved as a whole, whichever of its points are kept or selected.
numbers() { field "$1" '[(p["id"], p["pull_off"], p["followed"], p["work"]["newton_iterations"]) for p in d["points"]]'; }
expect 0 'good: 3 of 12 points, 1 checks: within' run good --output parts --points 7-9
expect 0 'good: 12 points, 1 checks: within (3 points kept)' run good --output parts --jobs 1
check 'the record is the same' test "$(numbers parts/good/record.json)" = "$(numbers whole/good/record.json)"
expect 0 'good: 12 points, 1 checks: within (kept)' run good --output parts
# Some scenes are also traced; both values must agree.
write_case 'follow: tabor
traced: {seed: 7, count: 3}
want: [pull_off]'
expect 2 '*traced is*: expected a check against traced' plan good
against='  - {quantity: QUANTITY, reference: traced, tolerance: 1e-5, kind: rel, because: each is solved for 1e-4}'
write_traced() { # traced, quantity
  write_case "follow: tabor
checkpoint_every: 4
$1
want: [pull_off]"
  echo "$against" | sed "s/QUANTITY/$2/" >>"$file"
}
write_traced '' pull_off_force
expect 2 '*checks?2?.reference is traced: expected traced only for a pull-off, in a case with*' plan good
write_traced 'traced: {seed: 7, count: 3}' solved_share
expect 2 '*checks?2?.reference is traced: expected every_scene*' plan good
write_traced 'traced: {seed: 7, count: 7}' pull_off_force
expect 2 '*traced.count is 7: expected a whole number from 1 to the number of scenes between checkpoints' plan good
write_traced 'traced: {seed: -1, count: 3}' pull_off_force
expect 2 '*traced.seed is -1: expected a whole number*' plan good
write_traced 'traced: {seed: 7, count: 3}' pull_off_force
expect 0 '' plan good
check 'the plan lists the comparison' grep -q 'compare pull_off_force with traced at 3 of 12 points, tolerance' "$work/stdout"
check 'no trace is missed' test "$(grep -c 'has no value' "$work/stdout")" -eq 0
check 'the plan lists the traced scenes' grep -q 'trace 3 scenes between checkpoints in addition, drawn with seed 7' "$work/stdout"
expect 0 'good: 12 points, 4 checks: within' run good --output traced --jobs 2
record=traced/good/record.json
check 'three followed scenes have a trace' test \
  "$(field $record '[p["followed"] for p in d["points"] if "traced" in p] == 3 * [True]')" = True
check 'the trace is a full trace' test "$(field $record '[p["traced"]["folds"] is None for p in d["points"] if "traced" in p]')" = \
  '[False, False, False]'
check 'the traces do not change the followed values' test "$(numbers $record)" = "$(numbers whole/good/record.json)"
drawn=$(field $record '[p["id"] for p in d["points"] if "traced" in p][1]')
expect 0 "good: 1 of 12 points, 2 checks: within" run good --output one --points "$drawn"
expect 0 'good: 12 points, 4 checks: within (1 points kept)' run good --output one --jobs 1
traces() { field "$1" '[(p["id"], p["traced"]["pull_off"]) for p in d["points"] if "traced" in p]'; }
check 'the traces are the same, point by point' test "$(traces one/good/record.json)" = "$(traces $record)"

# A difference between a followed and a traced value is an error. A missing trace is no agreement.
alter() { # STATEMENT on the point p
  PYTHONPATH=$here:$here/.. "$python" -c '
import checksum, digest, json, sys
path, drawn, statement = sys.argv[1:]
d = json.load(open(path))
p = next(p for p in d["points"] if p["id"] == drawn)
exec(statement)
p["traced"]["digest"] = digest.function()(p["traced"])
d["key"] = ""
checksum.write(path, d)' "$record" "$drawn" "$1"
}
alter 'p["traced"]["pull_off"]["force"] *= 1 + 2e-5'
expect 1 '*' verify --verbose good --output traced
check 'a trace that finds another force is outside' grep -q '^good  *pull_off_force .* oracle  *outside' "$work/stdout"
expect 1 '*' explain good --output traced
check 'the message explains the difference' grep -q 'the trace of the same scene finds another pull-off' "$work/stdout"
alter 'p["traced"].update(status="not_converged", reason="it is made so", pull_off=None)'
expect 1 '*' verify --verbose good --output traced
check 'a failed trace is no agreement' grep -q 'missing_reference: the trace failed: it is made so' "$work/stdout"

# Stored results that were altered do not have their checksum: they are no results.
sed 's/"force": 1/"force": 2/' "$record" >altered && mv altered "$record"
"$program" verify good --output traced >stdout 2>stderr
check 'they are solved again' grep -q '^good: [0-9]* stored results were altered or damaged and are solved again$' stderr
check 'the results are those of before' grep -q '"force": 1' "$record"

# The table of the pull-offs.
"$program" follow --key tabor --from 1 --to 2 --points 4 --curve - >table.csv 2>stderr
check 'a table on standard output' test $? = 0
check 'its columns' grep -q '^tabor,force,force_error,approach,approach_error,contact_radius,contact_radius_error,followed$' table.csv
check 'its rows' test "$(grep -c '^[0-9]' table.csv)" = 4
expect 0 '' follow --key tabor --from 1 --to 2 --points 4 --curve file.csv
check 'a file' cmp table.csv file.csv
check 'and the printed table' grep -q '^work ' stdout
expect 4 'pulloff: nowhere/a.csv cannot be written: *' follow --key tabor --from 1 --to 2 --points 2 --curve nowhere/a.csv
check 'the result is printed although the file is not written' grep -q '^work ' stdout
expect 2 'pulloff: standard output is asked for twice: *' follow --key tabor --from 1 --to 2 --curve - --json
expect 2 'pulloff: --curve has no effect on --of folds: *' follow --key tabor --from 1 --to 2 --of folds --curve a.csv
expect 2 'pulloff: --key is time-limit: *' follow --key time-limit --from 1 --to 2
expect 3 'pulloff: the solve at tabor * failed: after 1e-06 s of processor time *' \
  follow --key tabor --from 3 --to 4 --points 2 --amplitude 1 --wavelength 20 --time-limit 1e-6

# SI units: the same numbers as solve, scene by scene.
tip='--from-physical --modulus-pa 2e9 --work-j-per-m2 0.05 --distance-m 3e-10'
for series in 'radius-m --from 1e-7 --to 3e-7 --amplitude-m 1e-10 --wavelength-m 6e-9' \
  'wavelength-m --from 4e-9 --to 6e-9 --amplitude-ratio 0.03 --radius-m 1e-7' \
  'amplitude-m --from 1e-10 --to 2e-10 --wavelength-m 6e-9 --radius-m 1e-7' \
  'power-c --from 4e6 --to 8e6 --profile power --power-n 2'; do
  # shellcheck disable=SC2086
  expect 0 '' follow --key $series --points 3 $tip --preload-m 2e-9 --tolerance 1e-5 --json
  cp stdout si.json
  check "three scenes of $series" test "$(field si.json 'len(d["points"])')" = 3
  for k in 0 1 2; do
    given=$(field si.json '" ".join("--%s %s" % (k.replace("_", "-"), v) for k, v in d["points"]['$k']["physical"]["input"].items()
      if k not in ("approach_start_m", "profile_approach_m"))')
    # shellcheck disable=SC2086
    "$program" solve --from-physical $given --preload-m 2e-9 --tolerance 1e-5 --json >solve.json
    check "scene $k of $series: force, approach and input in SI units" "$python" -c '
import json, sys
k = int(sys.argv[1])
a, b = json.load(open("si.json"))["points"][k]["physical"], json.load(open("solve.json"))["physical"]
assert a["input"] == b["input"] and a["units"] == b["units"], (a["input"], b["input"])
for name, error in (("force_n", "error_estimate_n"), ("approach_m", "approach_error_estimate_m")):
    x, y = a["pull_off"], b["pull_off"]
    assert abs(x[name] - y[name]) <= x[error] + y[error] and 0 < x[error] < 1e-3 * abs(x[name]), (name, x, y)
' $k
  done
done
# The modulus, the work of adhesion and the distance vary with the same scene at one end.
for key in modulus-pa:2e9 work-j-per-m2:0.05 distance-m:3e-10; do
  name=${key%:*} value=${key#*:}
  # shellcheck disable=SC2046,SC2086
  expect 0 '' follow --key "$name" --from "$value" --to "$(awk "BEGIN { print 1.1 * $value }")" --points 2 \
    --radius-m 1e-7 $(echo "$tip" | sed "s/--$name [^ ]*//") --json
  cp stdout si.json
  # shellcheck disable=SC2086
  expect 0 '' solve $tip --radius-m 1e-7 --json
  cp stdout solve.json
  check "the first scene of $name is the tip" test "$(field si.json 'd["points"][0]["pull_off"]["force"]')" = "$(field solve.json 'd["pull_off"]["force"]')"
  check "the other scene of $name is not" test "$(field si.json 'd["points"][1]["physical"]["pull_off"]["force_n"]')" != "$(field solve.json 'd["physical"]["pull_off"]["force_n"]')"
done
# shellcheck disable=SC2086
expect 0 '' follow --key radius-m --from 1e-7 --to 3e-7 --points 3 $tip --curve si.csv
check 'the printed table says its units' grep -q '^units    lengths in m, loads and forces in N$' stdout
check 'and the CSV table' grep -q '^# units: SI units: lengths in m, force in N' si.csv
check 'its columns say units' grep -q '^radius_m,force_n,force_error_n,approach_m,approach_error_m,contact_radius_m,contact_radius_error_m,followed$' si.csv
check 'table and print agree' "$python" -c '
printed = [line.split() for line in open("stdout") if line[:1] == " "][1:]
table = [line.split(",") for line in open("si.csv") if line[0] in "0123456789"]
assert len(printed) == len(table) == 3
for a, b in zip(printed, table):
    assert a[0] == "%g" % float(b[0]) and a[1] == "%.8e" % float(b[1]) and a[3] == "%.8e" % float(b[3]), (a, b)'
# shellcheck disable=SC2086
expect 0 '' follow --of folds --key distance-m --from 3e-10 --to 4e-10 --points 2 --radius-m 1e-7 \
  --from-physical --modulus-pa 2e9 --work-j-per-m2 0.05
check 'folds in SI units' grep -q '^jump_in  *3e-10  *-[0-9.]*e-10 .* -[0-9.]*e-09 ' stdout
check 'and their units' grep -q '^units    lengths in m, loads and forces in N$' stdout
expect 2 'pulloff: --radius-m is in SI units: expected --from-physical, too' follow --key radius-m --from 1e-7 --to 2e-7
# shellcheck disable=SC2086
expect 2 'pulloff: --radius is in units of epsilon: expected --radius-m with --from-physical' \
  follow --key radius --from 1 --to 2 $tip
# shellcheck disable=SC2086
expect 2 'pulloff: --tabor is given with --from-physical: expected --modulus-pa, *' follow --key tabor --from 1 --to 2 $tip
expect 2 'pulloff: --from-physical is given without --work-j-per-m2, --distance-m: expected these, too' \
  follow --from-physical --key modulus-pa --from 1e9 --to 2e9 --radius-m 1e-7
# shellcheck disable=SC2086
expect 2 'pulloff: --preload-load is dimensionless: expected --preload-m with --from-physical' \
  follow --key radius-m --from 1e-7 --to 2e-7 $tip --preload-load 2
expect 2 'pulloff: --modulus-pa is -1: expected *' follow --from-physical --key radius-m --from 1e-7 --to 2e-7 --modulus-pa -1
"$program" follow --key radius --from 1e-3 --to 5e-3 --points 3 >/dev/null 2>stderr
check 'one warning for the series' test "$(grep -c 'warning: --radius is 0.001 epsilon, which looks like metres' stderr)" = 1
finish
