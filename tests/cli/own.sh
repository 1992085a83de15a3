#!/bin/sh
# Case files outside the data folder: every command that is printed for such a case works when it is pasted into a shell,
# and no such case replaces another case.
# shellcheck disable=SC1091,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
python=${PYTHON:-python3}
mkdir bin
ln -s "$program" bin/pulloff
PATH=$work/bin:$PATH

write_table "$PULLOFF_DATA/reference/wrong.csv" tabor,force,approach 0,3,0

write_own() { # FILE NAME NODES
  mkdir -p "$(dirname "$1")"
  cat >"$1" <<CASE
name: $2
title: A tip of one's own
suites: [smoke]
scene: {tabor: 0, radius: 93, outer_radius: inf, scheme: ring}
sweep: [{key: nodes, values: [$3]}]
want: [pull_off]
lines:
  - {name: smooth, theory: jkr, sweep: [{key: tabor, values: [3]}]}
checks:
  - {quantity: pull_off_force, reference: reference/wrong.csv, tolerance: 0.1, kind: abs, because: it fails}
CASE
}

# Prints all commands in the output and the files of a case, one per line.
cat >commands.py <<'PYTHON'
import json, re, sys
out, name, *texts = sys.argv[1:]
record = json.load(open(f"{out}/{name}/record.json"))
found = [record["command"]] + [check["command"] for check in record["checks"]]
printed = "\n".join(open(path).read() for path in texts + [f"{out}/{name}/line-smooth.csv"])
printed += "\n" + "\n".join(record["plan"] + [check["note"] for check in record["checks"]])
found += re.findall(r"pulloff (?:run|verify|bless|explain) .*?(?= --reason TEXT|\)?$)", printed, flags=re.M)
for line in sorted(set(found)):
    print(line + (" --reason tried" if "pulloff bless" in line else ""))
PYTHON

# commands_work FILE NAME: tests that these commands work in the folder in which the program was started.
commands_work() {
  write_own "$1" "$2" '21, 22'
  "$program" plan "$1" >plan.txt
  "$program" verify "$1" --output "out-$2" >verify.txt 2>"$work/stderr"
  check "verify $1" test $? -eq 1
  "$program" explain "$1" --output "out-$2" >explain.txt 2>"$work/stderr"
  "$program" bless "$1" --reason refused --output "out-$2" >bless.txt 2>&1
  check 'bless is refused with a command to explain it' grep -q 'pulloff explain' bless.txt
  "$python" commands.py "out-$2" "$2" plan.txt verify.txt explain.txt bless.txt >commands.txt
  check "$1 has commands" test $? -eq 0
  for verb in run verify explain; do
    check "one with $verb" grep -q "^pulloff $verb " commands.txt
  done
  while read -r line; do
    printf '%s --output again\n' "$line" >one.sh
    sh one.sh >pasted.txt 2>&1 </dev/null
    code=$?
    check "$line works: exit code $code, $(tail -n 1 pasted.txt)" \
      grep -q -e "^$2: " -e 'checks pass' -e "^pulloff: $2 is not blessed: " pasted.txt
  done <commands.txt
  "$program" run "$1" --shard 1/1 --output "shard-$2" 2>"$work/stderr"
  check "a shard of $1" test $? -eq 0
  expect 0 "$2: 2 points, 2 checks: outside" merge "shard-$2" --output "merged-$2"
}

commands_work cases/mine.yaml mine # which once was taken for a case of the data folder
commands_work "my tips/it's \"so\" & \$HOME.yaml" quoted
long=$(printf 'a%.0s' 1 2 3 4 5 6 7 8 9 10)
# Under the sanitizers only the lines count that are run.
if [ -z "${RUN_FEW-}" ]; then
  commands_work "größe/überall.yaml" umlaut
  commands_work "$long/$long/$long/$long/$long/$long/$long/$long/tip.yaml" long
  commands_work "$work/at/a/place.yaml" absolute
fi

write_own ./-dash.yaml dash 21
"$program" verify --output out-dash -- -dash.yaml >verify.txt 2>"$work/stderr"
check 'no path is printed as an option' grep -q 'pulloff explain ./-dash.yaml' verify.txt

# A case of the data folder can be given by its path or by its name.
(cd data && "$program" run cases/good.yaml --shard 1/1 --output ../built-in 2>"$work/stderr")
check 'a case of the data folder is found by its path' test $? -eq 0
check 'it is printed with its name' grep -q '"argument": "good"' built-in/shard-1-of-1.json
expect 0 'good: 1 point, 1 check: within' merge built-in --output merged
expect 0 'good: 1 point, 1 check: within (kept)' run good data/cases/good.yaml --output merged

# Two cases with the same name are refused.
write_own taken.yaml good 21
for verb in run verify plan explain; do
  expect 2 'pulloff: taken.yaml: name is good: expected another name, as cases/good.yaml has this one' $verb taken.yaml
done
expect 2 'pulloff: taken.yaml: name is good: *' run taken.yaml --shard 1/2 --output taken
check 'no shard is written' test ! -e taken
write_own one.yaml twin 21
write_own two.yaml twin 22
expect 2 'pulloff: two.yaml: name is twin: expected another name, as one.yaml has this one' run one.yaml two.yaml
# A file that is given twice is taken once, as a case that is named twice.
expect 0 'twin: 1 point, 1 check: outside' run one.yaml ./one.yaml --output twins
cp twins/twin/record.json before.json
expect 2 'pulloff: two.yaml: name is twin: expected another name or another folder for the records, as twins/twin contains the record of one.yaml' \
  run two.yaml --output twins --fresh
check 'the record is unchanged' cmp before.json twins/twin/record.json
expect 0 'twin: 1 point, 1 check: outside (kept)' run ./one.yaml --output twins
mv one.yaml renamed.yaml
expect 0 'twin: 1 point, 1 check: outside (kept)' run renamed.yaml --output twins
expect 0 'twin: 1 point, 1 check: outside' run two.yaml --output twins
# A wrong case file in the data folder does not affect a case outside it.
echo 'name: [' >"$PULLOFF_DATA/cases/broken.yaml"
expect 0 'twin: 1 point, 1 check: outside (kept)' run two.yaml --output twins
expect 2 'pulloff: cases/broken.yaml:*' run good --output twins
finish
