#!/bin/sh
# theory: the closed forms by name, as JSON and for people; what is missing or wrong, in one line.
# shellcheck disable=SC1091,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
python=${PYTHON:-python3}

# near KEY VALUE TOLERANCE ARGUMENT...: the JSON document of `theory ARGUMENT...` has it.
near() {
  key=$1 value=$2 tolerance=$3
  shift 3
  expect 0 '' theory "$@" --json
  check "$key of $* is $value" "$python" -c '
import json, sys
d = json.load(open("stdout"))
assert d["schema"] == "pulloff/1" and abs(d[sys.argv[1]] - float(sys.argv[2])) <= float(sys.argv[3]), d
' "$key" "$value" "$tolerance"
}
near pull_off_force 19.9243 1e-4 guduru --tabor 5 --amplitude 10 --wavelength 20 --radius 100
near pull_off_force 0.7410559 1e-7 rigid --alpha 0.25 --amplitude 1
near pull_off_force 1.992148 1e-6 rigid --alpha 1e-4 --amplitude 1
near pull_off_force 1.5 1e-14 jkr --tabor 2.385
near last_load -0.83333333333333 1e-13 jkr --tabor 2.385
near bound 8.57604 1e-6 compactness --amplitude 1 --wavelength 20
near area_ratio 1.0986960440 1e-9 persson-tosatti --amplitude 2 --wavelength 20
near area_ratio_printed 1.0314159265 1e-9 persson-tosatti --amplitude 2 --wavelength 20
near peak_distance 1.2009369551760027 1e-15 lennard-jones
near load -2 1e-15 bradley --approach 0
# -(8/3) (x^3 - x^9), x = 1/1.2
near traction -1.02639201129570 1e-13 lennard-jones --gap 0.2
near part_of_bradley 1 1e-4 rumpf-rabinowicz --alpha 1e-7 --radius 100
near composite_radius 48.4 1 crest --amplitude 0.1 --wavelength 19.4
# Amplitude 0 is the smooth sphere, not a mistake.
near pull_off_force 1.5 1e-14 guduru --tabor 2.385 --amplitude 0
near pull_off_approach -1.8445993817945 1e-12 guduru --tabor 2.385 --amplitude 0
near effective_work 1 0 kesari-lew --tabor 2.385 --amplitude 0 --wavelength 20
near effective_work 1 0 persson-tosatti --amplitude 0
near pull_off_force 2 0 rigid --amplitude 0
near composite_radius 77 1e-13 crest --amplitude 0 --radius 77
near critical_radius 0 0 compactness --amplitude 0
expect 0 '' theory kesari-lew --amplitude 0
check 'an infinite Johnson parameter is a dash' grep -q '^johnson_parameter  *-$' "$work/stdout"
expect 0 '' theory kesari-lew --amplitude 1 --wavelength 20 --contact-radius 30
check 'for people' grep -q '^effective_work ' "$work/stdout"

expect 2 'pulloff: theory without a name is unknown: expected bradley, *' theory
expect 2 'pulloff: theory alchemy is unknown: expected bradley, *' theory alchemy
expect 2 'pulloff: theory guduru needs --amplitude and --wavelength' theory guduru
expect 2 'pulloff: theory rigid needs --amplitude' theory rigid --alpha 1
expect 2 'pulloff: theory rigid needs --alpha, or *' theory rigid --amplitude 1
expect 2 'pulloff: --tabor is 0: expected a finite number > 0' theory jkr --tabor 0
expect 2 'pulloff: --approach is 1: expected a finite number < 1' theory bradley --approach 1
expect 2 'pulloff: --radius is nan: expected a finite number > 0' theory jkr --radius nan
expect 2 'pulloff: --gap is -1: expected a finite number > -1' theory lennard-jones --gap -1
expect 2 'pulloff: theory takes no more*' theory jkr more
finish
