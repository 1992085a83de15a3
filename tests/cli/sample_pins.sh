#!/bin/sh
# Pins of random scenes: they apply as for any scene, at any time limit, but not if solves of the sample may fail.
# shellcheck disable=SC1091,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null USER=tester
rm "$PULLOFF_DATA/cases/good.yaml"
file=$PULLOFF_DATA/cases/scenes.yaml
pins=$PULLOFF_DATA/cases/pins/scenes.csv
all=''
some=', when: [{key: tolerance, values: [1e-3]}]'

write_scenes() { # WHEN-OF-PIN OTHER-CHECK SCENE SWEEP
  cat >"$file" <<CASE
name: scenes
title: Spheres at random, to two tolerances
suites: [random]
scene: {outer_radius: inf, scheme: panel$3}
sample:
  seed: 20200908
  count: 2
  keys:
    - {key: tabor, from: 0.1, to: 1, scale: log}
    - {key: radius, from: 30, to: 500, scale: log}
sweep: [{key: tolerance, values: [1e-4, 1e-3]}$4]
want: [pull_off]
checks:
  - {quantity: pull_off_force, reference: pin, tolerance: 1e-10, kind: rel, because: it is quick to bless again$1}
$2
CASE
}
share() { # WHEN
  echo "  - {quantity: solved_share, reference: every_scene, tolerance: 0.4, kind: abs, because: it is made so$1}"
}

write_scenes "$all" '' '' ''
expect 0 '*' bless scenes --reason 'the first'
check 'four pins' grep -q '4 pins, 0 moved, 4 new, 0 dropped$' "$work/stdout"
expect 0 'scenes: 4 points, 4 checks: within*' verify scenes
expect 0 'scenes: 4 points, 4 checks: within' verify scenes --time-limit 3600
check 'no header or column of the time limit' test 0 -eq "$(grep -c time_limit "$pins")"

write_scenes "$all" "$(share '')" '' ''
refused='expected a reference other than pin where a solved_share lets solves fail'
expect 2 "pulloff: cases/scenes.yaml:14: checks[[]1[]].reference is pin: $refused" plan scenes
write_scenes "$some" "$(share "$some")" '' ''
expect 2 "pulloff: cases/scenes.yaml:14: checks[[]1[]].reference is pin: $refused" plan scenes
write_scenes "$all" '' '' ', {key: time_limit, values: [60, 3600]}'
expect 2 "pulloff: cases/scenes.yaml:14: checks[[]1[]].reference is pin: expected a reference other than pin, as pins do not depend on time_limit *" \
  plan scenes

# Pins can be blessed together with a check of the solved fraction if no solve may fail.
write_scenes "$some" "$(share ', when: [{key: tolerance, values: [1e-4]}]')" ', time_limit: 3600' ''
expect 0 '*' bless scenes --reason 'only where none may fail'
check 'two of the four pins are left' grep -q '2 pins, 0 moved, 0 new, 2 dropped$' "$work/stdout"
check 'the fraction is not listed as an oracle' test 0 -eq "$(grep -c '^# checked' "$pins")"
finish
