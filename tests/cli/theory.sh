#!/bin/sh
# pulloff theory: the closed forms by name, as JSON and as text; the message for missing or wrong options is one line.
# shellcheck disable=SC1091,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
python=${PYTHON:-python3}

# near KEY VALUE TOLERANCE ARGUMENT...: tests a value in the JSON document of `theory ARGUMENT...`.
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
# Amplitude 0 is the smooth sphere and is accepted.
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
check 'the printed result' grep -q '^effective_work ' "$work/stdout"

expect 2 'pulloff: theory needs the name of a closed form: expected bradley, *' theory
expect 2 'pulloff: no closed form is named alchemy: expected bradley, *' theory alchemy
# The parameters that each form needs: waves, an elastic half-space, or both.
for form in guduru kesari-lew persson-tosatti compactness crest; do
  expect 2 "pulloff: theory $form needs --amplitude and --wavelength" theory $form
done
for form in guduru kesari-lew persson-tosatti; do
  expect 2 'pulloff: --tabor is 0: expected a finite number > 0' theory $form --tabor 0 --amplitude 1 --wavelength 20
done
for form in rigid rumpf-rabinowicz compactness crest; do
  expect 0 '' theory $form --amplitude 1 --wavelength 20
done
expect 2 'pulloff: theory rigid needs --amplitude' theory rigid --alpha 1
expect 2 'pulloff: theory rigid needs --alpha, or *' theory rigid --amplitude 1
expect 2 'pulloff: --tabor is 0: expected a finite number > 0' theory jkr --tabor 0
expect 2 'pulloff: --approach is 1: expected a finite number < 1' theory bradley --approach 1
expect 2 'pulloff: --radius is nan: expected a finite number > 0' theory jkr --radius nan
expect 2 'pulloff: --gap is -1: expected a finite number > -1' theory lennard-jones --gap -1
expect 2 'pulloff: unexpected argument more of theory*' theory jkr more

# Extreme ratios of lengths. GSL's error handler used to end the program, or the search for the deepest wave did not end.
near load 3.79606689822e43 1e33 guduru --tabor 5 --amplitude 1 --wavelength 10 --contact-radius 1e16
near pull_off_force 2.10744797525e12 10 guduru --tabor 5 --amplitude 1 --wavelength 1e-12
near pull_off_force 210780002.771 1e-3 guduru --tabor 5 --amplitude 1 --wavelength 1e-8
far='*expected values of more similar size'
expect 2 "pulloff: pull_off_force of theory guduru cannot be computed: $far" theory guduru --tabor 5 --amplitude 1 --wavelength 1e-300
expect 2 "pulloff: pull_off_force of theory rigid cannot be computed: $far" theory rigid --amplitude 1 --wavelength 1e-300
expect 2 "pulloff: load of theory jkr cannot be computed: $far" theory jkr --contact-radius 1e200
# For very short waves the rigid load is their mean: the solver and the closed form compute it independently.
for wavelength in 0.02 1e-8 1e-150; do
  expect 0 '' solve --tabor 0 --amplitude 1.3 --wavelength $wavelength --json
  check "rigid waves of $wavelength end" grep -q '"status": "ok"' stdout
done
expect 0 '' solve --tabor 0 --amplitude 1.3 --wavelength 0.02 --json
force=$("$python" -c 'import json; print(json.load(open("stdout"))["pull_off"]["force"])')
near pull_off_force "$force" 1e-10 rigid --amplitude 1.3 --wavelength 0.02
expect 3 'pulloff: the solve failed: the rigid load would be the sum of 2e+10 half waves up to radius 100, *' \
  solve --tabor 0 --amplitude 1 --wavelength 1e-8 --outer-radius 100

# An option that has no effect is refused for every form.
idle() { # NAME FLAG EXPECTED ARGUMENT...
  name=$1 flag=$2 expected=$3
  shift 3
  expect 2 "pulloff: $flag has no effect on theory $name*: expected $expected" theory "$name" "$@" "$flag" 0.7
}
for flag in --amplitude --wavelength --alpha --approach --gap; do
  idle jkr $flag 'only --tabor, --coupling, --radius, --contact-radius, --profile, --profile-file or --wave'
done
for flag in --tabor --amplitude --wavelength --radius --alpha --approach --contact-radius; do
  idle lennard-jones $flag 'only --gap'
done
for flag in --tabor --amplitude --wavelength --radius --alpha --contact-radius --gap; do
  idle bradley $flag 'only --approach'
done
for name in guduru kesari-lew; do
  for flag in --alpha --approach --gap; do
    idle $name $flag 'only --tabor, --coupling, --amplitude, --wavelength, --radius or --contact-radius' --amplitude 1 --wavelength 9
  done
done
for name in compactness crest; do
  idle $name --tabor 'only --amplitude, --wavelength or --radius' --amplitude 1 --wavelength 9
done
idle persson-tosatti --contact-radius 'only --tabor, --coupling, --amplitude, --wavelength or --radius' --amplitude 1 --wavelength 9
idle rigid --radius 'only --amplitude, --alpha or --approach' --alpha 1 --amplitude 1
idle rigid --wavelength 'only --amplitude, --alpha or --approach' --alpha 1 --amplitude 1
idle rumpf-rabinowicz --amplitude 'only --radius or --alpha' --alpha 1
idle rumpf-rabinowicz --approach 'only --radius or --alpha' --alpha 1
expect 2 'pulloff: --contact-radius-m has no effect on theory bradley: expected only --radius-m or --approach-m' \
  theory bradley --from-physical --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 1e-7 --contact-radius-m 1e-9

# The forms of any profile: the cone, the sphere as a power, the peak of the law, the reasons of what is refused.
near pull_off_force 10.1321183642338 1e-12 jkr --profile cone:0.3 --coupling 0.05
near pull_off_least_gap 0 0 jkr --profile cone:0.3 --coupling 0.05
near pull_off_force 1.5 1e-13 jkr --profile power:0.005,2 --radius 100 --tabor 2.385
near approach_rate 0 1e-12 jkr --profile cone:0.3 --coupling 0.05 --contact-radius 0.35367765131532297
near tension 1.0264004785593346 1e-15 maugis --tabor 1
near pull_off_force 2 1e-12 rigid --law morse:1.7
near pull_off_force 137.425431733702511 1e-10 rigid --profile punch:5,20 --law morse:3
expect 2 'pulloff: Maugis-Dugdale needs a full disc of contact *' theory maugis --wave 3,10 --tabor 0.5
expect 2 'pulloff: --wave has no effect on theory guduru: *' theory guduru --wave 1,20
expect 2 'pulloff: --tension is 0: expected a finite number > 0' theory maugis --tension 0
expect 2 'pulloff: --coupling is 0: expected a finite number > 0' theory jkr --profile cone:0.3 --coupling 0

# Options without effect are refused by the other verbs, too.
expect 2 'pulloff: --wavelength has no effect on a scene without amplitude: expected *' solve --wavelength 9
expect 2 'pulloff: --wavelength has no effect on scenes without amplitude: expected *' \
  follow --key tabor --from 1 --to 2 --wavelength 9
expect 2 'pulloff: the wavelength varies, but the scenes have no amplitude: expected *' follow --key wavelength --from 1 --to 2
expect 2 'pulloff: --checkpoint-every has no effect on --of folds: expected *' \
  follow --key tabor --from 1 --to 2 --of folds --checkpoint-every 3

# A fixed mesh on the unbounded surface resolves a limited number of waves; scenes with more waves are refused.
expect 3 'pulloff: the solve failed: * waves beyond radius * must be resolved, with 12 nodes each: * expected *' \
  solve --tabor 0.1 --scheme ring --amplitude 10 --wavelength 0.3 --nodes 2500
expect 3 'pulloff: the solve failed: elements of length * cannot represent waves of length 0.1; expected at least * nodes, *' \
  solve --scheme ring --amplitude 0.01 --wavelength 0.1 --nodes 100
finish
