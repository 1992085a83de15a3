#!/bin/sh
# A case whose scene is in SI units is solved as a dimensionless scene; its results are also in newton and metre.
# shellcheck disable=SC1091,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
python=${PYTHON:-python3}
rm "$PULLOFF_DATA/cases/good.yaml"
file=$PULLOFF_DATA/cases/si.yaml

# write_si PHYSICAL SCENE SWEEP REFERENCE TOLERANCE
write_si() {
  cat >"$file" <<CASE
name: si
title: A sphere in metres
suites: [smoke]
scene:
  physical: {$1}
  scheme: panel
  tolerance: 1e-7
$2
$3
want: [pull_off]
checks:
  - {quantity: pull_off_force, reference: $4, tolerance: $5, kind: abs, because: it is so good}
CASE
}
body='work_j_per_m2: 0.05, distance_m: 3e-10, radius_m: 3e-8'

# mu = (R w^2/(E*^2 eps^3))^(1/3) is 1 for E* = w (R/eps^3)^(1/2) = 0.05 (1e21/0.9)^(1/2) = (5/3) 1e9, and R is 100 eps;
# pi w R = 4.71238898038469e-9 N.
write_table "$PULLOFF_DATA/reference/table.csv" tabor,radius,force,approach 1,100,1.67066478,-0.8734
write_si "modulus_pa: 1666666666.6666667, $body" '' '' reference/table.csv 1e-7
expect 0 '*' verify --verbose si --output run
check 'the reference of the dimensionless scene holds' grep -q '^si  *pull_off_force .*oracle *within' "$work/stdout"
check 'newton and metre are printed' grep -q '^si  *pull_off  *scene  *7.872822[23][0-9]*e-09 N at approach -2.6201.*e-10 m$' "$work/stdout"
check 'the record has newton and metre' "$python" -c '
import json
point = json.load(open("run/si/record.json"))["points"][0]
assert abs(point["input"]["tabor"] - 1) < 1e-15 and abs(point["input"]["radius"] / 100 - 1) < 1e-15
assert point["input"]["outer_radius"] == "inf" and "--tabor" in point["command"]
units, found = point["physical"]["units"], point["physical"]["pull_off"]
assert abs(units["force_n"] / 4.71238898038469e-9 - 1) < 1e-14 and units["length_m"] == 3e-10
assert abs(found["force_n"] / 7.8728223e-9 - 1) < 1e-7, found
assert abs(found["approach_m"] / (point["pull_off"]["approach"] * 3e-10) - 1) < 1e-14'
expect 0 'si: 1 points, 1 checks: within (kept)' run --output run

# Bradley: 2 pi w R
write_si "modulus_pa: inf, $body" '' '' bradley 1e-12
expect 0 '*' verify --verbose si --output run
check '2 pi w R' grep -q ' 9.424777961e-09 N at approach ' "$work/stdout"

# A wavy sphere on a cut surface. A length that is given in metres cannot also be given in epsilon.
wave='amplitude_m: 3e-11, wavelength_m: 3e-9, outer_radius_m: 3e-8'
write_si "modulus_pa: 1666666666.6666667, $body, $wave" '' '' bradley 1
expect 1 '*' verify --verbose si --output run
check 'lengths are divided by epsilon' "$python" -c '
import json
i = json.load(open("run/si/record.json"))["points"][0]["input"]
for key, value in (("amplitude", 0.1), ("wavelength", 10), ("outer_radius", 100)):
    assert abs(i[key] / value - 1) < 4e-15, key'
both='expected none of tabor, amplitude, wavelength, radius, outer_radius, the profile and waves, or a group of them, beside scene.physical'

# A profile whose lengths are in metres; without a radius, loads are in pi w epsilon.
tip='modulus_pa: 1666666666.6666667, work_j_per_m2: 0.05, distance_m: 3e-10'
write_si "$tip, profile: \"punch:1.5e-9,6e-9\", waves: \"3e-11@3e-9;1.5e-11@6e-10\"" '' '' bradley 1
expect 1 '*' verify --verbose si --output run
check 'profile and waves are divided by epsilon' "$python" -c '
import json, math
point = json.load(open("run/si/record.json"))["points"][0]
i = point["input"]
assert i["profile"] == "punch" and i["load_unit"] == "pi w epsilon" and i["radius"] == 1, i
assert abs(i["punch_b"] / 5 - 1) < 4e-15 and abs(i["punch_r"] / 20 - 1) < 4e-15, i
waves = [[float(x) for x in wave.split("@")] for wave in i["waves"].split(";")]
assert all(abs(a / b - 1) < 4e-15 for w, v in zip(waves, ((0.1, 10), (0.05, 2))) for a, b in zip(w, v)), waves
assert abs(i["tabor"] ** 1.5 / 0.1 - 1) < 1e-14, i
assert abs(point["physical"]["units"]["force_n"] / (math.pi * 0.05 * 3e-10) - 1) < 1e-14'
write_si "$tip, profile: \"power:1e9\"" '' '' bradley 1
expect 2 'pulloff: cases/si.yaml:5: scene.physical.profile is power:1e9: expected sphere, *' plan si
write_si "$tip, radius_m: 3e-8, profile_file: none.csv" '' '' bradley 1
expect 4 'pulloff: cases/si.yaml:5: scene.physical.profile_file: */cases/none.csv cannot be opened: *' plan si
write_si "$tip, profile: \"cone:0.3\", amplitude_m: 1e-9, wavelength_m: 1e-8, waves: \"1e-9@1e-8\"" '' '' bradley 1
expect 2 'pulloff: cases/si.yaml:5: scene.physical.waves is *: expected only waves, or amplitude_m and wavelength_m' plan si
write_si "modulus_pa: 1e9, $body" '  tabor: 1' '' bradley 1
expect 2 "pulloff: cases/si.yaml:8: scene.tabor is 1: $both" plan si
write_si "modulus_pa: 1e9, $body" '' 'sweep: [{key: radius, values: [50, 100]}]' bradley 1
expect 2 "pulloff: cases/si.yaml:9: sweep[[]1[]].key is radius: $both" plan si
write_si "modulus_pa: 1e9, $body" '' 'sweep: [{key: alpha, values: [1]}]' bradley 1
expect 2 "pulloff: cases/si.yaml:9: sweep[[]1[]].key is alpha: $both" plan si
write_si "modulus_pa: -1, $body" '' '' bradley 1
expect 2 'pulloff: cases/si.yaml:5: scene.physical: the modulus is -1: expected a number > 0, or inf' plan si
write_si "modulus_pa: 1 GPa, $body" '' '' bradley 1
expect 2 'pulloff: cases/si.yaml:5: scene.physical.modulus_pa is 1 GPa: expected a finite number, or inf' plan si
write_si "modulus_pa: 1e9, work_j_per_m2: 0.05, distance_m: 3e-10" '' '' bradley 1
expect 2 'pulloff: cases/si.yaml:5: scene.physical.radius_m is missing: expected a finite number > 0 in m' plan si
write_si "modulus_pa: 1e9, $body, radius: 3" '' '' bradley 1
expect 2 'pulloff: cases/si.yaml:5: scene.physical.radius is unknown: expected one of modulus_pa, work_j_per_m2, *' plan si
finish
