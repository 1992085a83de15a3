#!/bin/sh
# Wrong sections `sample` of a case: the message is one line with file, line, path, value and what was expected.
# shellcheck disable=SC1091,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
file=$PULLOFF_DATA/cases/good.yaml

write_sample() {
  restore
  cat >"$file" <<'CASE'
name: good
title: Spheres at random
suites: [random]
scene:
  outer_radius: inf
  scheme: panel
sample:
  seed: 17
  count: 3
  keys:
    - {key: tabor, from: 0, to: 1e-6}
    - {key: radius, from: 30, to: 500, scale: log}
    - {key: wavelength, from: 1, to: 3, scale: log, times: root_radius}
    - {key: amplitude, from: 0, to: 0.2, times: wavelength}
want: [pull_off]
CASE
}

spoilt() { # SED-SCRIPT MESSAGE
  write_sample
  sed -i "$1" "$file"
  expect 2 "pulloff: cases/good.yaml:$2" run good --output out
  check 'nothing is written' test ! -e out
}

write_sample
expect 0 '*good: 3 points, 0 checks: within' run good --output out0
expect 0 '' plan good
check 'the plan says how many are drawn' grep -q '^  draw 3 scenes; each value depends on seed 17' "$work/stdout"
check 'the plan states the ranges' \
  grep -q '^    wavelength from 1 to 3 times the square root of the radius, uniform in the' "$work/stdout"
check 'the plan states the units of the ranges' grep -q '^    amplitude from 0 to 0.2 times wavelength, uniform$' "$work/stdout"

spoilt '/^  seed/d' '*: sample.seed is missing: expected a whole number of at most 15 digits'
spoilt 's/seed: 17/seed: 1.5/' '8: sample.seed is 1.5: expected a whole number of at most 15 digits'
spoilt 's/seed: 17/seed: -1/' '8: sample.seed is -1: expected a whole number of at most 15 digits'
spoilt 's/count: 3/count: 0/' '9: sample.count is 0: expected a whole number from 1 to 100000'
spoilt 's/count: 3/count: 100001/' \
  '9: sample.count is 100001: expected a whole number from 1 to 100000'
spoilt 's/count: 3/counts: 3/' '9: sample.counts is unknown: expected one of seed, count, keys; did you mean count[?]'
spoilt 's/^sample:/sample: 5\nsimple:/' '7: sample is 5: expected a mapping of seed, count, keys'
spoilt 's/key: tabor/key: scheme/' \
  '11: sample.keys[[]1[]].key is scheme: expected a key of the scene whose value is a number*'
spoilt 's/key: tabor/key: nodes/' \
  '11: sample.keys[[]1[]].key is nodes: expected a key of the scene whose value is a number*'
spoilt 's/key: tabor/key: colour/' \
  '11: sample.keys[[]1[]].key is colour: expected a key of the scene whose value is a number, and not a count: tabor, *, outer_radius, mie_m, *power_c, *'
spoilt 's/key: radius/key: tabor/' \
  '12: sample.keys[[]2[]].key is tabor: expected each key drawn once'
# A group and the key that it sets, or both groups of the waviness: the scene had other values than its label said, and with
# both groups it was smooth.
spoilt 's/key: amplitude, .*}/key: alpha, from: 0.1, to: 1}/' \
  '14: sample.keys[[]4[]].key is alpha: expected each key drawn once'
spoilt 's/key: wavelength, .*}/key: alpha, from: 0.1, to: 1}/; s/key: amplitude, .*}/key: amplitude_ratio, from: 0.01, to: 0.1}/' \
  '14: sample.keys[[]4[]].key is amplitude_ratio: expected one of alpha and amplitude_ratio'
spoilt 's/outer_radius: inf/&\n  wavelength: 20/; s/key: wavelength, .*}/key: alpha, from: 0.1, to: 1}/' \
  '14: sample.keys[[]3[]].key is alpha: expected a key that neither scene nor sweep gives'
spoilt 's/^sample/sweep: [{key: amplitude_ratio, values: [0.05]}]\n&/; s/key: wavelength, .*}/key: alpha, from: 0.1, to: 1}/' \
  '14: sample.keys[[]3[]].key is alpha: expected one of alpha and amplitude_ratio'
# Without an amplitude, alpha has no effect: every scene was the same smooth sphere.
spoilt 's/key: wavelength, .*}/key: alpha, from: 0.1, to: 1}/; /key: amplitude/d' \
  '4: scene.amplitude is missing: expected a number > 0, here, in the sweep or in the sample, as alpha varies'
spoilt 's/outer_radius: inf/&\n  amplitude: 0/; s/key: wavelength, .*}/key: alpha, from: 0.1, to: 1}/; /key: amplitude/d' \
  '6: scene.amplitude is 0: expected a number > 0, here, in the sweep or in the sample, as alpha varies'
# A unit that a group sets, or that is a group, is not known when the number is drawn: it was 0.
spoilt 's/^sample/sweep: [{key: alpha, values: [0.5]}]\n&/; /key: wavelength/d' \
  '14: sample.keys[[]3[]].times is wavelength: expected *'
spoilt 's/outer_radius: inf/&\n  coupling: 1/; /key: tabor/d; s/times: wavelength/times: coupling/' \
  '14: sample.keys[[]3[]].times is coupling: expected *'
spoilt 's/outer_radius: inf/&\n  tabor: 1/' \
  '12: sample.keys[[]1[]].key is tabor: expected a key that neither scene nor sweep gives'
spoilt 's/^sample/sweep: [{key: tabor, values: [1]}]\n&/' \
  '12: sample.keys[[]1[]].key is tabor: expected a key that neither scene nor sweep gives'
spoilt 's/, from: 30//' '12: sample.keys[[]2[]].from is missing: expected a finite number'
spoilt 's/from: 30/from: -30/' '12: sample.keys[[]2[]].from is -30: expected a finite number > 0'
spoilt 's/from: 30/from: nan/' '12: sample.keys[[]2[]].from is nan: expected a finite number > 0'
spoilt 's/to: 500/to: 30/' '12: sample.keys[[]2[]].to is 30: expected a finite number > from'
spoilt 's/to: 500/to: inf/' '12: sample.keys[[]2[]].to is inf: expected a finite number > from'
spoilt 's/to: 1e-6/to: 1e-6, scale: log/' \
  '11: sample.keys[[]1[]].from is 0: expected a finite number > 0, as the scale is log'
spoilt 's/radius, from: 30, to: 500, scale: log/radius, from: 30, to: 500, scale: cubic/' \
  '12: sample.keys[[]2[]].scale is cubic: expected linear or log'
spoilt 's/times: root_radius/times: root_tabor/' \
  '13: sample.keys[[]3[]].times is root_tabor: expected root_radius, or a key given in *'
spoilt 's/times: root_radius/times: amplitude/' \
  '13: sample.keys[[]3[]].times is amplitude: expected root_radius, or a key given in *'
spoilt 's/times: root_radius/times: scheme/' \
  '13: sample.keys[[]3[]].times is scheme: expected root_radius, or a key given in *'
spoilt '/key: radius/d' \
  '12: sample.keys[[]2[]].times is root_radius: expected root_radius, or a key given in *'
spoilt '/key: tabor/d' '4: scene.tabor is missing: expected a finite number >= 0, here, in the *'
spoilt 's/times: root_radius/times: outer_radius/' \
  '10: sample draws tabor=*: expected permitted values of these keys'
spoilt '/key: wavelength/d; s/times: wavelength/times: radius/' \
  '4: scene.wavelength is missing: expected a finite number > 0, here, in the sweep or in the sample'
finish
