#!/bin/sh
# Profiles, waves and coupling from the command line and in cases: equal scenes that are written in different ways,
# input that is refused, tables, SI units, and references that are of one profile only.
# shellcheck disable=SC1091,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
python=${PYTHON:-python3}

any='sphere, power:C,n, cone:t, punch:b,R or truncated:b,R; a table of radii and gaps by profile_file'
expect 2 "pulloff: --profile is wedge: expected $any" solve --profile wedge
expect 2 "pulloff: --profile is power:0.05: expected $any" solve --profile power:0.05
expect 2 "pulloff: --profile is cone:0.3,2: expected $any" solve --profile cone:0.3,2
expect 2 "pulloff: --profile is sphere:3: expected $any" solve --profile sphere:3
expect 2 'pulloff: power_n is not given: the profile power needs it' solve --profile power --power-c 0.05
expect 2 'pulloff: power_n is 0.5: expected a number from 1 to 40' solve --profile power:1,0.5
expect 2 'pulloff: punch_b is -1: expected a finite number > 0' solve --profile punch:-1,3
expect 2 'pulloff: --cone-t is 0: expected a finite number > 0' solve --profile cone --cone-t 0
expect 2 'pulloff: --power-c has no effect on the profile cone: expected --profile power' solve --profile cone:1 --power-c 3
expect 2 'pulloff: --punch-b has no effect on the profile sphere: expected --profile punch' solve --punch-b 3
expect 2 'pulloff: --table-scale has no effect on the profile sphere: expected --profile-file' solve --table-scale 2
wave='expected A,L: amplitude and wavelength, two numbers > 0'
expect 2 "pulloff: --wave is 1: $wave" solve --wave 1
expect 2 "pulloff: --wave is -1,20: $wave" solve --wave -1,20
expect 2 "pulloff: --wave is 1,0: $wave" solve --wave 1,0
expect 2 'pulloff: --wave is given more than 8 times: expected at most 8 waves' solve --wave 1,2 --wave 1,3 --wave 1,4 \
  --wave 1,5 --wave 1,6 --wave 1,7 --wave 1,8 --wave 1,9 --wave 1,10
expect 2 'pulloff: --wave is given 8 times beside --amplitude: expected at most 8 waves' solve --amplitude 1 \
  --wavelength 9 --wave 1,3 --wave 1,4 --wave 1,5 --wave 1,6 --wave 1,7 --wave 1,8 --wave 1,9 --wave 1,10
expect 2 'pulloff: both --coupling and --tabor are given: expected only one' solve --coupling 1 --tabor 1
expect 2 'pulloff: --coupling is -1: expected a finite number >= 0' solve --coupling -1
expect 2 'pulloff: *profile*' theory guduru --profile cone:0.3 --amplitude 1 --wavelength 9
# waves finer than the memory of any machine carries are refused at once
expect 3 'pulloff: the solve failed: the finest mesh needs * nodes or more and * GB of memory, and there are * GB: expected longer waves, *' solve --wave 0.1,1e-7
expect 2 'pulloff: both coupling and tabor are given: *' follow --key coupling --from 0.1 --to 1 --tabor 1
expect 2 'pulloff: --cone-t has no effect on the profile power: *' follow --key cone-t --from 1 --to 2 --profile power:1,2
expect 2 'pulloff: --key is profile: *' follow --key profile --from 1 --to 2

# Tables.
cat >tables.py <<'TABLES'
def write(name, rows, unit=1.0):
    with open(name, "w") as file:
        file.write("r,gap\n" + "".join(f"{r * unit!r},{f * unit!r}\n" for r, f in rows))

radii = [60 * k / 99 for k in range(100)]
sphere = [(r, r * r / 200) for r in radii]
write("sphere.csv", sphere)
write("metres.csv", sphere, 3e-10)
write("doubled.csv", sphere, 0.5)
write("short.csv", sphere[:7])
write("unsorted.csv", sphere[:20] + [sphere[18]] + sphere[20:])
write("offset.csv", sphere[1:])
write("metres_offset.csv", sphere[1:], 3e-10)
with open("nameless.csv", "w") as file:
    file.write("".join(f"{k},{k * k}\n" for k in range(20)))
write("flat.csv", [(r, min(f, 3.0)) for r, f in sphere])
write("coarse.csv", [(10.0 * k, 5.0 * k * k * (k % 2)) for k in range(9)] + [(90.0, 900.0)])
for name, bad in (("nan.csv", "nan"), ("words.csv", "x")):
    write(name, sphere[:20])
    with open(name) as file:
        lines = file.readlines()
    lines[5] = f"1.0,{bad}\n"
    with open(name, "w") as file:
        file.writelines(lines)
TABLES
"$python" tables.py
expect 4 'pulloff: nowhere.csv*' solve --profile-file nowhere.csv
expect 4 'pulloff: short.csv: 7 rows are too few for a profile: expected at least 8' solve --profile-file short.csv
expect 4 'pulloff: unsorted.csv:22: r is 10.9*: expected more than in the row before' solve --profile-file unsorted.csv
expect 4 'pulloff: metres_offset.csv:2: the first r is 1.8*e-10: expected 0' solve --from-physical --modulus-pa 2e9 \
  --work-j-per-m2 0.05 --distance-m 3e-10 --profile-file metres_offset.csv
expect 4 'pulloff: offset.csv:2: the first r is 0.6*: expected 0' solve --profile-file offset.csv
expect 4 'pulloff: nameless.csv:1: the column 1 is named 0: expected a line with the names of the columns before the rows' \
  solve --profile-file nameless.csv
expect 4 'pulloff: flat.csv:101: the last gap, less that on the axis, is 3: expected more than in the row before, and more than 0' \
  solve --profile-file flat.csv
expect 4 'pulloff: coarse.csv:*: without this row the gap changes; the change, in epsilon, is *' solve --profile-file coarse.csv
sed '/%%/,$d' "$here/../fuzz/corpus/profile/falls_at_the_end" >falls.csv
expect 4 'pulloff: falls.csv:26: the slope of the spline at the last r is 0: expected more than 0*' solve --profile-file falls.csv
expect 4 'pulloff: nan.csv:6: *nan*' solve --profile-file nan.csv
expect 4 'pulloff: words.csv:6: *x*' solve --profile-file words.csv
# What spreadsheets write is the same table: a byte order mark, quotes, blanks, CR LF, blank lines at the end.
mark=$(printf '\357\273\277')
sed "1s/^/$mark/" sphere.csv >mark.csv
sed '1s/.*/"r", "gap"/; 7s/\(.*\),\(.*\)/"\1","\2"/' sphere.csv >quotes.csv
sed 's/,/ ,  /; s/^/ /; s/$/\t/' sphere.csv >blanks.csv
sed "1s/^/$mark/; s/\$/\r/; \$s/\$/\n\r\n  \r/" sphere.csv >ends.csv
numbers_of() { "$program" solve --tabor 0 --profile-file "$1" 2>&1 | grep -E '^(pull-off|jump_|minimum)'; }
for file in mark quotes blanks ends; do
  check "$file.csv is the table sphere.csv" test "$(numbers_of $file.csv)" = "$(numbers_of sphere.csv)"
done
check 'it has a result' test -n "$(numbers_of sphere.csv)"
expect 2 'pulloff: both --profile and --profile-file are given: expected only one' solve --profile cone:1 \
  --profile-file sphere.csv
expect 2 'pulloff: --profile-file is empty: expected the name of a file' solve --profile-file ''
expect 4 'pulloff: nowhere.csv*' follow --key tabor --from 1 --to 2 --profile-file nowhere.csv

# The command in a table states the coupling that was given, and repeats the solve.
for given in '--coupling 0.07' '--coupling 0.0833333333333333' '--tabor 0.3'; do
  # shellcheck disable=SC2086 # two words
  expect 0 '' solve $given --profile cone:0.5 --want preload --staircase first.csv
  # shellcheck disable=SC2046 # words
  expect 0 '' $(sed -n 's/^# command: pulloff //p' first.csv) --staircase second.csv
  check "the command of a scene with $given repeats it" cmp -s first.csv second.csv
done
expect 0 '' solve --coupling 0.07 --profile cone:0.5 --want preload --staircase first.csv
check 'the command has the coupling' grep -q '^# command: pulloff solve --coupling 0.07 --outer-radius inf ' first.csv

cat >equal.py <<'LOOK'
import json, os, subprocess, sys

def run(*flags):
    return subprocess.run([sys.argv[1], *flags], check=True, capture_output=True, text=True).stdout

def solve(*flags):
    return json.loads(run("solve", "--json", *flags))

def near(a, b, times):
    """Whether two pull-offs differ by at most so many times the sum of their stated errors."""
    for key, error in (("force", "error_estimate"), ("approach", "approach_error_estimate")):
        x, y = a["pull_off"], b["pull_off"]
        assert abs(x[key] - y[key]) <= times * (x[error] + y[error]), (key, x, y)

cut = ("--tabor", "1.385", "--radius", "100", "--outer-radius", "50")
sphere = solve(*cut)
# as it was written before, as a power law, and as a table in three units
near(solve(*cut, "--profile", "sphere"), sphere, 0)
near(solve(*cut, "--profile", "power:0.005,2"), sphere, 1)
near(solve("--profile", "power:0.005;2", *cut), sphere, 1)
near(solve("--power-n", "2", *cut, "--power-c", "0.005", "--profile", "power"), sphere, 1)
table = solve(*cut, "--profile-file", "sphere.csv")
near(table, sphere, 1)
near(solve("--table-scale", "2", *cut, "--profile-file", "doubled.csv"), table, 1)
t = table["profile_table"]
assert t["rows"] == 100 and abs(t["end_radius"] - 60) < 1e-12 and abs(t["exponent"] - 2) < 1e-9, t
assert t["uncertainty"] < 1e-12 and len(t["sha256"]) == 64 and "profile_table" not in sphere, t
assert table["input"]["profile"] == "table" and table["input"]["profile_file"] == "sphere.csv"
assert table["input"]["table_scale"] == 1 and sphere["input"]["table_scale"] is None
assert sphere["input"]["profile"] == "sphere" and sphere["input"]["waves"] is None
assert "100 rows to radius 60, beyond which the gap is continued as r^2" in run("solve", *cut, "--profile-file", "sphere.csv")

# one wave is amplitude and wavelength, in the last bit
wavy = solve(*cut, "--amplitude", "0.3", "--wavelength", "11")
near(solve(*cut, "--wave", "0.3,11"), wavy, 0)
assert wavy["input"]["waves"] == "0.3@11"
# two waves of equal length add their amplitudes
near(solve(*cut, "--wave", "0.1,11", "--wave", "0.2,11"), wavy, 1)

# the coupling is the Tabor parameter of the radius, whatever the order; the radius of another profile is 1
c = repr((1.385 ** 3 / 100) ** 0.5)
near(solve("--coupling", c, "--outer-radius", "50"), sphere, 1)
cone = solve("--coupling", "0.05", "--profile", "cone:0.3")
assert cone["input"]["radius"] == 1 and cone["input"]["load_unit"] == "pi w epsilon"
assert abs(cone["input"]["tabor"] ** 1.5 - 0.05) < 1e-15
ten = [solve(*flags) for flags in (("--radius", "10", "--coupling", "0.05", "--profile", "cone:0.3"),
                                   ("--profile", "cone", "--cone-t", "0.3", "--coupling", "0.05", "--radius", "10"))]
assert all(d["input"]["load_unit"] == "pi w R" and d["input"]["radius"] == 10 for d in ten)
assert abs(10 * ten[0]["pull_off"]["force"] / cone["pull_off"]["force"] - 1) < 1e-5
assert sphere["input"]["load_unit"] == "pi w R" and "in pi w epsilon;" in run("solve", "--profile", "cone:0.3")

# SI units: lengths in metres, C in m^(1-n)
si = ("--from-physical", "--modulus-pa", "2e9", "--work-j-per-m2", "0.05", "--distance-m", "3e-10")
ball = solve(*si, "--radius-m", "3e-8", "--outer-radius-m", "1.5e-8")
for flags in (("--profile", "power:1.6666666666666666e7,2"), ("--profile-file", "metres.csv"),
              ("--profile", "power", "--power-n", "2", "--power-c", "1.6666666666666666e7")):
    other = solve(*si, "--radius-m", "3e-8", "--outer-radius-m", "1.5e-8", *flags)
    near(other, ball, 1)
    assert abs(other["physical"]["pull_off"]["force_n"] / ball["physical"]["pull_off"]["force_n"] - 1) < 1e-8
punch = solve(*si, "--profile", "punch:1.5e-9,6e-9", "--wave", "3e-11,3e-9")
i = punch["input"]
assert abs(i["punch_b"] - 5) < 1e-12 and abs(i["punch_r"] - 20) < 1e-12 and i["radius"] == 1, i
assert abs(i["amplitude"] - 0.1) < 1e-12 and abs(i["wavelength"] - 10) < 1e-12, i
assert punch["physical"]["input"]["profile"] == "punch:1.5e-09,6e-09"
assert abs(punch["physical"]["units"]["force_n"] - 3.141592653589793 * 0.05 * 3e-10) < 1e-25

# --profile still names the file of gap and traction if it is a path
run("solve", *cut, "--profile", "gap.csv", "--profile", "power:0.005,2")
run("solve", *cut, "--profile-csv", "again")
assert open("gap.csv").read().count("\n") > 20 and os.path.exists("again")
LOOK
check 'equal scenes' "$python" equal.py "$program"

# The references of the general problem.
expect 2 '*--from-physical is given without --radius-m*' solve --from-physical --modulus-pa 1e9 --work-j-per-m2 0.05 \
  --distance-m 3e-10
expect 2 '*--coupling is given with --from-physical*' solve --from-physical --coupling 1

# A parameter that is followed is what a trace of that scene finds.
cat >follow.py <<'LOOK'
import json, subprocess, sys

def run(*flags):
    return json.loads(subprocess.run([sys.argv[1], *flags, "--json"], check=True, capture_output=True).stdout)

for series, flag, key in ((("--profile", "truncated:5,20", "--coupling", "0.02"), "truncated-b", "truncated_b"),
                          (("--profile", "power", "--power-c", "0.005", "--coupling", "0.05"), "power-n", "power_n")):
    given = [f for f in series if f != "truncated:5,20"]
    if key == "truncated_b":
        given = ["--profile", "truncated", "--truncated-r", "20", "--coupling", "0.02"]
    points = run("follow", "--key", flag, "--from", "2", "--to", "2.3", "--points", "4", "--tolerance", "1e-4", *given)["points"]
    assert any(p["followed"] for p in points), key
    p = points[1]
    solved = run("solve", "--tolerance", "1e-4", *given, "--" + flag, repr(p["input"][key]))
    a, b = p["pull_off"], solved["pull_off"]
    assert abs(a["force"] - b["force"]) <= 2 * (a["error_estimate"] + b["error_estimate"]), (key, a, b)
LOOK
check 'a parameter of the profile is followed' "$python" follow.py "$program"

# Cases: the keys, paths relative to the case file, and the content of a table as part of what was solved.
cd "$work" || exit
restore
case=$PULLOFF_DATA/cases/good.yaml
set_scene() {
  restore
  cp "$work/sphere.csv" "$PULLOFF_DATA/cases/tip.csv"
  sed -i '/^  amplitude: 0$/d' "$case"
  for line; do
    sed -i "s/^  tabor: 0\$/  tabor: 0\n  $line/" "$case"
  done
}
set_scene 'profile: cone:0.3'
expect 1 '*outside*' verify good --output run --verbose
check 'another profile has no reference' grep -q missing_reference "$work/stdout"
set_scene 'profile: wedge'
expect 2 "pulloff: cases/good.yaml:*: scene.profile is wedge: expected $any" plan good
set_scene 'waves: 1@'
expect 2 'pulloff: cases/good.yaml:*: scene.waves is 1@: expected A@L*' plan good
set_scene 'coupling: 1'
expect 2 'pulloff: cases/good.yaml:*: scene.coupling is 1: expected only one of tabor and coupling' plan good
set_scene 'waves: 1@20' 'amplitude: 2' 'wavelength: 3'
expect 2 'pulloff: cases/good.yaml:*: scene.waves is 1@20: expected only waves, or amplitude and wavelength' plan good
set_scene 'profile_file: nowhere.csv'
expect 4 'pulloff: cases/good.yaml:*: scene.profile_file: */cases/nowhere.csv*' plan good
set_scene 'profile: cone:1' 'profile_file: tip.csv'
expect 2 'pulloff: cases/good.yaml:*: scene.profile_file is tip.csv: expected only one of profile and profile_file' \
  plan good
write_table "$PULLOFF_DATA/reference/table.csv" tabor,profile,waves,radius,force,approach '0,cone:0.3,-,-,7,0' \
  '0,power:0.005;2,-,-,200,0' '0,power:0.005;2,0.1@9,-,8,0' '0,sphere,-,100,2,0'
cp "$PULLOFF_DATA/reference/table.csv" general.csv
# The verdict of the rigid pull-off against a table of all profiles. Loads of other profiles are in pi w epsilon.
verdict_of() { # VERDICT KEY...
  verdict=$1
  shift
  set_scene "$@"
  sed -i '/^  radius: 100$/d' "$case" # that of the case without a profile
  cp general.csv "$PULLOFF_DATA/reference/table.csv"
  "$program" verify good --output run --verbose >stdout 2>&1
  check "$* is $verdict" grep -q "$verdict" stdout
}
verdict_of 'within' 'profile: sphere' 'radius: 1e2'
verdict_of 'within' 'profile: power:0.005,2'
verdict_of 'missing_reference' 'profile: power:0.005,2.5'
verdict_of 'missing_reference' 'profile: power:0.005,2' 'radius: 10'
verdict_of 'missing_reference' 'profile: power:0.005,2' 'waves: 0.1@8'
verdict_of 'outside' 'profile: power:0.005,2' 'waves: 0.1@9'

# The content of a table is part of what was solved; its path is not.
set_scene 'profile_file: tip.csv'
expect 0 '*outside' run good --output run
expect 0 '*outside (kept)' run good --output run
sed -i 's/^0.6060606060606061,.*/0.6060606060606061,0.0019/' "$PULLOFF_DATA/cases/tip.csv"
expect 0 '*outside' run good --output run
check 'the record describes the table' grep -q '"profile_table"' run/good/record.json
check 'its commands name the table relative to the case file' \
  grep -q '"command": "pulloff solve .*--profile-file tip.csv ' run/good/record.json
check 'so do its inputs' grep -q '"profile_file": "tip.csv"' run/good/record.json
sed -i 's/^want: .*/want: [pull_off, curve]/' "$case"
expect 0 '*' run "$PULLOFF_DATA/cases/good.yaml" --output elsewhere
check 'so does a curve' grep -q -- '--profile-file tip.csv ' elsewhere/good/curve-*.csv
finish
