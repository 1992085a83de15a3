#!/bin/sh
# --from-physical: a scene in SI units is converted to a dimensionless scene and solved, and its results are printed in
# newton and metre, too. Both kinds of options cannot be mixed, and missing options are named.
# shellcheck disable=SC1091,SC2013,SC2016,SC2034,SC2086,SC2154
. "$(dirname "$0")/lib.sh"
python=${PYTHON:-python3}
body='--from-physical --modulus-pa 1.3385e9 --work-j-per-m2 0.0537 --distance-m 3.1e-10 --radius-m 2.7e-8'

expect 0 '' solve $body --amplitude-m 1.3e-10 --wavelength-m 6.3e-9 --outer-radius-m 3.3e-8 --scheme triangle --nodes 201 \
  --approach-start-m -1.7e-9 --approach-end-m 1.1e-10 --profile-approach-m -2.3e-10 --want curve,profile --json
cp "$work/stdout" physical.json
cat >look.py <<'LOOK'
import json, math, shlex, subprocess, sys

d = json.load(open("physical.json"))
e, w, eps, r = 1.3385e9, 0.0537, 3.1e-10, 2.7e-8
near = lambda a, b, tolerance=4e-15: (a == b == 0) or abs(a / b - 1) < tolerance
i, p = d["input"], d["physical"]
assert near(i["tabor"], (r * w**2 / (e**2 * eps**3)) ** (1 / 3))
for key, metres in (("radius", r), ("amplitude", 1.3e-10), ("wavelength", 6.3e-9), ("outer_radius", 3.3e-8),
                    ("approach_start", -1.7e-9), ("approach_end", 1.1e-10)):
    assert near(i[key], metres / eps), key
    assert p["input"][key + "_m"] == metres, key
assert (p["input"]["modulus_pa"], p["input"]["work_j_per_m2"], p["input"]["distance_m"]) == (e, w, eps)
force, traction = math.pi * w * r, w / (i["tabor"] * eps)
assert near(p["units"]["force_n"], force) and p["units"]["length_m"] == eps
assert near(p["units"]["traction_pa"], traction)
assert near(p["pull_off"]["force_n"], d["pull_off"]["force"] * force)
assert near(p["pull_off"]["approach_m"], d["pull_off"]["approach"] * eps)
assert near(p["pull_off"]["contact_radius_m"], d["pull_off"]["contact_radius"] * eps)
for key in ("folds", "extrema", "curve"):
    assert len(p[key]) == len(d[key]) > 0, key
    for a, b in zip(p[key], d[key]):
        assert near(a["load_n"], b["load"] * force) and near(a["approach_m"], b["approach"] * eps)
        assert a.get("error_estimate_m") == b.get("error_estimate") == None
        assert near(a["contact_radius_m"], b["contact_radius"] * eps) and a.get("kind") == b.get("kind")
assert len(p["profile"]) == len(d["profile"]) > 100
for a, b in zip(p["profile"], d["profile"]):
    assert near(a["gap_m"], (1 + b["gap"]) * eps) and near(a["traction_pa"], b["traction"] * traction)
    assert near(a["radius_m"], b["radius"] * eps)
assert abs(p["profile_approach_m"] + 2.3e-10) < 1e-19

# with panels, the errors are printed in SI units, too
found = json.loads(subprocess.run(sys.argv[1:2] + shlex.split("""solve --from-physical --modulus-pa 1.3385e9
    --work-j-per-m2 0.0537 --distance-m 3.1e-10 --radius-m 2.7e-8 --scheme panel --json"""), capture_output=True,
    check=True).stdout)
a, b = found["physical"]["pull_off"], found["pull_off"]
assert near(a["error_estimate_n"], b["error_estimate"] * force)
assert near(a["approach_error_estimate_m"], b["approach_error_estimate"] * eps)
for a, b in zip(found["physical"]["folds"], found["folds"]):
    assert near(a["error_estimate_m"], b["error_estimate"] * eps)
    assert near(a["load_error_estimate_n"], b["load_error_estimate"] * force)

# the same dimensionless scene, equal to the last bit
flags = [word for key in ("tabor", "amplitude", "wavelength", "radius", "outer_radius", "scheme", "nodes",
                          "approach_start", "approach_end")
         for word in ("--" + key.replace("_", "-"), str(i[key]))]
flags += ["--profile-approach", repr(-2.3e-10 / eps), "--want", "curve,profile", "--json"]
same = json.loads(subprocess.run([sys.argv[1], "solve"] + flags, capture_output=True, check=True).stdout)
assert "physical" not in same
for key in same:
    if key != "work":
        assert same[key] == d[key], key
LOOK
check 'SI and dimensionless results agree' "$python" look.py "$program"
expect 0 '' solve $body --scheme triangle --nodes 101
check 'the printed result has newton' grep -q '^pull-off force [0-9.e-]* N at approach [0-9.e-]* m' "$work/stdout"
check 'the printed result has the input' grep -q '^physical modulus 1.3385e+09 Pa work 0.0537 J/m^2 distance 3.1e-10 m radius 2.7e-08 m$' "$work/stdout"
expect 0 '' solve $body --preload-m 4e-10 --scheme triangle --nodes 101
check 'the preload is in the input' grep -q '^physical .* preload 4e-10 m$' "$work/stdout"
check 'the preloads of the pull-off are in metre and newton' \
  grep -qE '^preload  loading to approach [0-9.e-]+ m, load [0-9.e-]+ N, or more gives this pull-off$' "$work/stdout"
expect 0 '' solve --from-physical --modulus-pa inf --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 1e-7 --json
check 'the rigid sphere has the force of Bradley' "$python" -c '
import json, math
d = json.load(open("stdout"))
assert d["rigid"] and abs(d["physical"]["pull_off"]["force_n"] / (2 * math.pi * 0.05e-7) - 1) < 1e-9
assert d["physical"]["input"]["modulus_pa"] == "inf" and d["physical"]["units"]["traction_pa"] is None'

# near KEY VALUE ARGUMENT...: tests a value in the block physical of theory.
near() {
  key=$1 value=$2
  shift 2
  expect 0 '' theory "$@" --json
  check "$key of $* is $value" "$python" -c '
import json, sys
d = json.load(open("stdout"))["physical"]
assert abs(d[sys.argv[1]] / float(sys.argv[2]) - 1) < 1e-12, d' "$key" "$value"
}
# expected values by hand: 3/2 pi w R; a^3 = 9 pi w R^2/(8 E*)
near pull_off_force_n 6.832492782659762e-09 jkr $body
near pull_off_contact_radius_m 4.693123085913775e-09 jkr $body
near load_n -3.1415926535897932e-08 bradley --from-physical --work-j-per-m2 0.05 --distance-m 3e-10 \
  --radius-m 1e-7 --approach-m 0
near effective_work_j_per_m2 0.0537 kesari-lew $body --amplitude-m 0
near peak_tension_pa 171066746.4265558 lennard-jones --from-physical --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 1e-7
near pull_off_force_n 1.1640478568314679e-08 rigid --from-physical --work-j-per-m2 0.05 --distance-m 3e-10 \
  --radius-m 1e-7 --alpha 0.25 --amplitude-m 3e-10
expect 0 '' theory guduru $body --amplitude-m 1e-10 --wavelength-m 5e-9
check 'the printed result has units' grep -q '^pull_off_force_n  *[0-9.e-]* N$' "$work/stdout"

# Mixed and incomplete options are refused.
for verb in solve 'theory jkr'; do
  expect 2 'pulloff: --tabor is given with --from-physical: *' $verb $body --tabor 1
  expect 2 'pulloff: --radius is in units of epsilon: expected --radius-m with --from-physical' $verb $body --radius 3
  expect 2 'pulloff: --radius-m is in SI units: expected --from-physical, too' $verb --radius-m 3
  expect 2 'pulloff: --modulus-pa is in SI units: *' $verb --modulus-pa 3
  expect 2 'pulloff: --from-physical is given without --modulus-pa, --work-j-per-m2, --distance-m, --radius-m: *' $verb --from-physical
  expect 2 'pulloff: --from-physical is given without --work-j-per-m2, --radius-m: *' $verb --from-physical --modulus-pa 1e9 --distance-m 1e-9
  expect 2 'pulloff: --distance-m is 0: expected a finite number > 0' $verb --distance-m 0
  expect 2 'pulloff: --modulus-pa is -1: expected a finite number > 0, or inf' $verb --modulus-pa -1
  expect 2 'pulloff: the Tabor parameter is inf: expected a number within the range of doubles; *' $verb --from-physical \
    --modulus-pa 1e-300 --work-j-per-m2 1e300 --distance-m 1e-300 --radius-m 1e300
done
expect 2 'pulloff: --amplitude-m is given without --wavelength-m: expected both' solve $body --amplitude-m 1e-9
expect 2 'pulloff: --approach-end is in units of epsilon: *' solve $body --approach-end 0
expect 2 'pulloff: --profile-approach is in units of epsilon: *' solve $body --profile-approach 0
expect 2 'pulloff: --modulus-pa is inf: expected a finite number > 0' theory jkr --from-physical --modulus-pa inf \
  --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 1e-7
expect 2 'pulloff: --approach-m is 3e-10: expected less than --distance-m, 3e-10' theory bradley --from-physical \
  --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 1e-7 --approach-m 3e-10
expect 2 'pulloff: theory guduru needs --amplitude-m and --wavelength-m' theory guduru $body

# The line "inputs": what 1 % more of an input changes, against solves with a changed input.
cat >inputs.py <<'INPUTS'
import json, math, re, subprocess, sys

program = sys.argv[1]


def solve(options, *more):
    words = [word for name, value in options.items() for word in (f"--{name}", repr(value) if isinstance(value, float) else value)]
    return subprocess.run([program, "solve", *words, *more], capture_output=True, text=True, check=True).stdout


def stated(options, *more):
    """The changes in percent of each line `inputs`, by input."""
    lines = [line for line in solve(options, *more).splitlines() if line.startswith("inputs   1 % more ")]
    return [{name: float(value) for name, value in re.findall(r"([a-z]+) (?:changes the force by )?(-?[\d.e-]+) %", line[18:])}
            for line in lines]


def measured(options, name, force, *more):
    """The change in percent, from 0.5 % less to 0.5 % more."""
    ends = []
    for factor in (math.exp(-0.005), math.exp(0.005)):
        document = json.loads(solve({**options, name: options[name] * factor}, *more, "--json"))
        ends.append(math.log(force(document)))
    return 100 * (ends[1] - ends[0])


def compare(options, line, names, force, *more):
    changes = stated(options, *more)[line]
    assert set(changes) == set(names), changes
    for shown, name in names.items():
        difference = measured(options, name, force, *more)
        assert abs(changes[shown] - difference) < 2e-3, (shown, changes[shown], difference)


def load(document):
    return document["pull_off"]["force"]


def newtons(document):
    return document["physical"]["pull_off"]["force_n"]


wavy = {"tabor": 1.7, "amplitude": 0.6, "wavelength": 13.0, "radius": 90.0}
compare(wavy, 0, {name: name for name in wavy}, load)
compare({"coupling": 0.05, "profile": "cone:0.3"}, 0, {"coupling": "coupling"}, load)
tip = {"modulus-pa": 2e9, "work-j-per-m2": 0.05, "distance-m": 3e-10, "radius-m": 3e-8, "amplitude-m": 2e-10, "wavelength-m": 4e-9}
names = {"modulus": "modulus-pa", "work": "work-j-per-m2", "amplitude": "amplitude-m", "wavelength": "wavelength-m", "radius": "radius-m"}
compare(tip, 1, names, newtons, "--from-physical")
assert stated({"tabor": 0.0}) == stated({"tabor": 1.0, "scheme": "ring"}) == []
assert abs(stated({"tabor": 1.0})[0]["radius"]) < 1e-4, "of a smooth sphere the radius is only a unit"
INPUTS
check 'the changes that 1 % of each input makes' "$python" inputs.py "$program"
finish
