#!/bin/sh
# pulloff conform: a good solver, planted factors, and every kind of wrong answer.
. "$(dirname "$0")/lib.sh"
root=$here/../..
export PULLOFF_DATA="$root"

# manifest MODE [MORE LINES]: the manifest of a responder.
manifest() {
  cat >"$1.yaml" <<END
protocol: pulloff-ask/1
solver: $1
command: [/usr/bin/python3, '$here/responder.py', $1, '$root/reference/feng_pull_off.csv', '{request}', '{response}']
can:
  scene: ${scene:-[{key: tabor\}, {key: radius\}, {key: outer_radius\}]}
  quantities: [${quantities:-pull_off_force, pull_off_approach, contact_radius}]
  unstable: true
start_limit: ${start_limit:-20}
time_limit: ${time_limit:-1}
$2
END
}

# conform CODE MODE PATTERN...: tests that the exit code is CODE, and that each pattern (grep -E) is a line.
conform() {
  code=$1
  mode=$2
  shift 2
  manifest "$mode" "$more"
  "$program" conform "$mode.yaml" --output out >"$work/stdout" 2>"$work/stderr"
  got=$?
  check "conform $mode: exit code $got, expected $code: $(cat "$work/stdout")" [ "$got" -eq "$code" ]
  for pattern in "$@"; do
    check "conform $mode: a line $pattern: $(cat "$work/stdout")" grep -qE "^$pattern" "$work/stdout"
  done
}

conform 0 good 'ok +manifest: 3 quantities' 'ok +empty request: ended' 'ok +Bradley, tabor 0.01' 'ok +JKR, tabor 3' \
  'ok +between, tabor 0.8, radius 50' 'ok +force at pull-off: within' 'ok +approach at pull-off: within' \
  'ok +contact radius at pull-off: within' 'ok +repeats: 2 answers' 'ok +a scene outside .*unsupported'
check 'no folder is left after a good solver' [ ! -e out ]
mkdir out
manifest good
"$program" conform good.yaml --output out >/dev/null
check 'a folder that was there before is left' [ -z "$(ls out)" ]
conform 0 slow 'ok +stopped after [123] of 4 answers'
conform 0 scalar 'ok +force at pull-off: within'
conform 0 noise 'ok +force at pull-off: within'
# A byte order mark before the first answer made it invalid.
conform 0 marked 'ok +force at pull-off: within 5 % of the expected value in 4 scenes'
# The spellings of infinity in YAML, and a byte order mark of a manifest, are read.
for infinity in .inf +.INF; do
  scene="[{key: tabor}, {key: radius}, {key: outer_radius, values: [$infinity]}]"
  conform 0 good 'ok +force at pull-off: within 5 % of the expected value in 4 scenes'
done
scene=
manifest good
{ printf '\357\273\277' && cat good.yaml; } >marked.yaml
expect 0 '' conform marked.yaml --output out

# Planted factors: each is named in one line.
conform 1 sign 'wrong +force at pull-off: the expected value times -1 \(a wrong sign\)'
conform 1 pi 'wrong +force at pull-off: the expected value times pi in'
conform 1 random 'wrong +force at pull-off: no common factor; worst for tabor 3'
conform 1 approach_sign 'wrong +approach at pull-off: the expected value times -1 \(a wrong sign\)' 'ok +force at pull-off'
conform 1 shifted 'wrong +approach at pull-off: the expected value -1 eps' 'ok +force at pull-off'
check 'one line names the fault' [ "$(grep -c '^wrong' "$work/stdout")" -eq 1 ]
check 'the last line counts it' grep -qx '1 finding is wrong' "$work/stdout"

# Other factors and other manifests run no further line of the program: not under the sanitizers.
if [ -z "${RUN_FEW-}" ]; then
  conform 1 half 'wrong +force at pull-off: the expected value times 1/2 in'
  conform 1 four_thirds 'wrong +force at pull-off: the expected value times 4/3 in'
  conform 1 radius 'wrong +force at pull-off: the expected value times R in'
  conform 1 pi_radius 'wrong +force at pull-off: the expected value times pi R in'

  # A manifest of soft scenes alone was asked nothing, and passed with a force times pi. The scenes come from the values
  # and the ranges of the manifest, whatever these are.
  for scene in '[{key: tabor, from: 2}, {key: radius}, {key: outer_radius}]' \
    '[{key: tabor, from: 6, to: 8}, {key: radius}, {key: outer_radius}]' \
    '[{key: tabor, values: [0.65]}, {key: radius}, {key: outer_radius}]' \
    '[{key: tabor, to: 0.005}, {key: radius}, {key: outer_radius}]' \
    '[{key: tabor, values: [0]}, {key: radius}, {key: outer_radius}]' \
    '[{key: tabor}, {key: radius, from: 2000}, {key: outer_radius}]' \
    '[{key: tabor}, {key: radius, values: [77]}, {key: outer_radius}]' \
    '[{key: tabor}, {key: radius, from: 60, to: 90}, {key: outer_radius, values: [400]}]'; do
    conform 0 good 'ok +force at pull-off: within 5 % of the expected value in [1-4] scene'
    case $scene in
      *'from: 2}'*) conform 1 pi 'wrong +force at pull-off: the expected value times pi in' ;;
    esac
    check "$scene: the scenes differ" [ -z "$(grep answered "$work/stdout" | sort | uniq -d)" ]
  done
fi
# What is expected between the rows of the table is what the program finds.
scene='[{key: tabor, values: [7]}, {key: radius}, {key: outer_radius}]'
conform 0 good 'ok +JKR, tabor 7, radius 100'
expected=$(sed -n 's/.*radius 100: answered.* expected //p' "$work/stdout")
found=$("$program" solve --tabor 7 | sed -n 's/^pull-off force \([^ ]*\) .*/\1/p')
check "tabor 7: expected $expected, solved $found" awk "BEGIN {exit !($expected / $found < 1.01 && $expected / $found > 0.99)}"
# Nothing that is known: the test does not pass, and says why.
for scene in '[{key: tabor, from: 12}, {key: radius}, {key: outer_radius}]' '[{key: tabor}, {key: radius}]' \
  '[{key: tabor}, {key: radius}, {key: outer_radius, to: 5}]' '[{key: tabor, to: -1}, {key: radius}, {key: outer_radius}]'; do
  conform 1 good 'wrong +no scene was asked, so that no number is tested: expected a manifest that accepts'
done
scene='[{key: tabor}, {key: radius}]'
conform 1 good 'wrong +no scene was asked, .*outer_radius is inf: the manifest does not declare this key'
scene=
quantities=folds
conform 1 numberless 'ok +Bradley' 'wrong +no answer has a number that can be compared'
quantities=

# Wrong answers: the point gets a status, the others are judged.
conform 1 nothing 'wrong +Bradley, .*: no_answer: the solver ended without an answer' \
  'wrong +between, tabor 0.8, radius 50: no_answer'
conform 1 skip 'ok +Bradley' 'wrong +JKR, .*: no_answer' 'ok +between'
conform 1 half_line 'ok +Bradley' 'wrong +JKR, .*: invalid: a line is not JSON' 'ok +between'
conform 1 wrong_type 'wrong +JKR, .*: invalid: pull_off.force is a text: expected a number' 'ok +between'
conform 1 list 'wrong +JKR, .*: invalid: a line is an array: expected an object' 'ok +between'
conform 1 no_status 'wrong +JKR, .*: invalid: status is missing: expected ok, unsupported or failed'
conform 1 nan "wrong +JKR, .*: invalid: a line is not JSON: .*near 'NaN'" 'ok +between'
conform 1 null 'wrong +JKR, .*: invalid: pull_off.force is missing or not a finite number'
conform 1 lacking 'wrong +JKR, .*: invalid: pull_off.approach is missing'
conform 1 stranger 'wrong +JKR, .*: invalid: an answer has the id 4711, which was not asked' 'ok +between'
conform 1 twice 'ok +Bradley' 'wrong +JKR, .*: invalid: two answers for repeat 1: expected one' 'ok +between'
conform 1 crash 'ok +Bradley' 'wrong +JKR, .*: crashed: the solver ended with exit status 3: a secret reason' 'ok +between'
conform 1 abort 'wrong +JKR, .*: crashed: signal 11 .Segmentation fault. ended the solver' 'ok +between'
conform 1 always_crash 'wrong +empty request' 'wrong +Bradley, .*: crashed' 'wrong +between, .*: no_answer: not asked any more'
conform 1 link 'wrong +Bradley, .*: invalid: the response cannot be opened, or is a symbolic link'
conform 1 shorter 'wrong +JKR, .*: invalid: the response became shorter' 'ok +between'
time_limit=20
conform 1 gigabyte 'ok +Bradley' 'wrong +JKR, .*: (crashed: signal 25|invalid: a line of the response has more)' 'ok +between'
conform 1 flood 'ok +Bradley' 'wrong +JKR, .*: (invalid: it printed more than 256 MB|crashed: signal 13)' 'ok +between'
time_limit=1
conform 1 hang 'ok +Bradley' 'wrong +JKR, .*: timed_out: no answer within 1 s; the solver was stopped' 'ok +between'
conform 1 deaf 'wrong +JKR, .*: timed_out' 'ok +between' 'note +request and response are in'

# Nothing of its process group lives on, whether the solver is stopped or ends by itself.
conform 1 spawn 'wrong +JKR, .*: timed_out' 'ok +between'
check 'no child is left' [ -z "$(pgrep -f 'sleep 4711' || true)" ]
conform 0 leave 'ok +between' 'note +processes that the solver left behind were killed'
check 'no child of an ended solver is left' [ -z "$(pgrep -f 'sleep 4712' || true)" ]

# Of the environment the solver gets what it needs, and what its manifest names.
SECRET=hidden
NAMED=shown
export SECRET NAMED
more='environment: [NAMED, ABSENT]'
conform 1 environment 'wrong +JKR, .*: crashed: the solver ended with exit status 5: HOME=.* LANG=C.UTF-8 .*NAMED=shown'
check 'no secret of the environment is passed on' sh -c "! grep -q 'hidden' '$work/stdout'"
more=

# It may change all in its own folder.
conform 0 inside 'ok +JKR' 'ok +between'

# Wrong manifests and a wrong command line.
expect 2 'pulloff: conform needs one manifest (see pulloff conform --help)' conform
expect 4 'pulloff: absent.yaml cannot be opened: *' conform absent.yaml
manifest good
mkdir -p locked/solvers
ln -s /proc/self locked/solvers/good # in which no folder can be created
expect 4 'pulloff: a folder for the solver cannot be created in locked/solvers/good' conform good.yaml --output locked
refuse() { # MESSAGE SED-SCRIPT: a manifest that the script has changed is refused.
  manifest good
  sed "$2" good.yaml >changed.yaml
  expect 2 "$1" conform changed.yaml --output out
}
refuse 'pulloff: changed.yaml:1: protocol is pulloff-ask/2: expected pulloff-ask/1' 's/ask.1/ask\/2/'
refuse 'pulloff: changed.yaml:2: solver is ../x: expected letters*' 's/solver: good/solver: ..\/x/'
refuse 'pulloff: changed.yaml:2: solver is pulloff: expected letters*' 's/solver: good/solver: pulloff/'
refuse 'pulloff: changed.yaml:3: command\[1\] is no-such-program: expected a program in PATH*' 's/.usr.bin.python3/no-such-program/'
refuse 'pulloff: changed.yaml:3: command\[1\] is /no/such: expected a program that can be executed' 's/.usr.bin.python3/\/no\/such/'
refuse 'pulloff: changed.yaml:5: can.scene\[1\].key is tabour: expected a key of the scene' 's/key: tabor/key: tabour/'
refuse 'pulloff: changed.yaml:5: can.scene\[1\].key is nodes: expected a key of the scene' 's/key: tabor/key: nodes/'
refuse 'pulloff: changed.yaml:5: can.scene\[1\].to is 0: expected a finite number >= from' 's/key: tabor/key: tabor, from: 1, to: 0/'
refuse 'pulloff: changed.yaml:6: can.quantities\[3\] is steps: expected a list of names*' 's/contact_radius\]/steps]/'
refuse 'pulloff: changed.yaml:6: can.quantities\[3\] is folds: expected a quantity of stable*' 's/contact_radius\]/folds]/; s/: true/: false/'
refuse 'pulloff: changed.yaml:7: can.unstable is maybe: expected true or false' 's/: true/: maybe/'
refuse 'pulloff: changed.yaml:9: time_limit is 0: expected a finite number of seconds > 0' 's/^time_limit.*/time_limit: 0/'
refuse 'pulloff: changed.yaml:3: colour is unknown: expected one of protocol, solver*' '3i colour: red'
manifest good
expect 2 'pulloff: --knob is 7: expected no such option, as the manifest has no knob' conform good.yaml --knob 7

finish
