#!/bin/sh
# Traction–separation laws from the command line and in cases: limits that hold for every law, parameters that are
# refused, and references that are of one law only.
# shellcheck disable=SC1091,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
python=${PYTHON:-python3}

expect 2 'pulloff: --law is mie:9: expected lennard-jones, mie:m,n or morse:a' solve --law mie:9
expect 2 'pulloff: mie_n is 3: expected a number > mie_m, 9, and at most 60' solve --law mie:9,3
expect 2 'pulloff: mie_m is not given: expected it with the law mie' solve --law mie --mie-n 9
expect 2 'pulloff: mie_n is not given: expected it with the law mie' solve --law mie --mie-m 4
expect 2 'pulloff: morse_a is not given: expected it with the law morse' solve --law morse
expect 2 'pulloff: morse_a is 60: expected a number from 0.05 to 50' solve --law morse:60
expect 2 'pulloff: mie_m is 1.5: *unbounded surface*expected more than 2, or an outer radius' solve --law mie:1.5,9
expect 2 'pulloff: --morse-a has no effect on the law mie: expected --law morse' solve --law mie:4,10 --morse-a 3
expect 2 'pulloff: --mie-m has no effect on the law lennard-jones: expected --law mie' solve --mie-m 3
expect 2 'pulloff: --key is law: *' follow --key law --from 1 --to 2
expect 2 'pulloff: --mie-n has no effect on the law morse: expected --law mie' follow --key mie-n --from 4 --to 5 --law morse:1

# Without a singularity the load of a rigid sphere grows without bound: the trace to an approach of 30 never ended.
expect 2 'pulloff: *preload is 30: expected less than 3, the greatest approach of rigid bodies' \
  solve --tabor 0 --law morse:2 --preload 30
expect 0 '' solve --tabor 0 --law morse:2 --preload 2.9
expect 0 '' solve --tabor 0 --law morse:2 --preload-load 1e9

# A rigid sphere pulls off with 2 at approach 0 for every law (Derjaguin), a soft one tends to JKR; the Mie law (3, 9)
# is that of the paper, and a law set by parts is the same as one set at once.
cat >limits.py <<'LOOK'
import json, subprocess, sys

def solve(*flags):
    return json.loads(subprocess.run([sys.argv[1], "solve", "--json", *flags], check=True, capture_output=True).stdout)

laws = ("lennard-jones", "mie:4,10", "mie:2.5,12", "morse:0.5", "morse:1", "morse:3")
for law in laws:
    rigid = solve("--tabor", "0", "--law", law)
    assert abs(rigid["pull_off"]["force"] - 2) <= rigid["pull_off"]["error_estimate"] < 1e-9, law
    assert abs(rigid["pull_off"]["approach"]) < 1e-8, law
    soft = solve("--tabor", "14", "--law", law, "--want", "diagnostics")
    assert 1.5 < soft["pull_off"]["force"] < 1.53, (law, soft["pull_off"])
    d = soft["diagnostics"]
    assert d["residual"] < 1e-9 and d["energy_defect"] < 1e-3, (law, d)
    assert d["reverse_trace"]["same"] and len(soft["folds"]) >= 2, law
    assert soft["input"]["law"] == law.split(":")[0]
paper, mie = solve("--tabor", "2.385"), solve("--tabor", "2.385", "--law", "mie:3,9")
assert abs(paper["pull_off"]["force"] - mie["pull_off"]["force"]) < 1e-9
assert paper["input"]["mie_m"] is None and mie["input"]["mie_n"] == 9
parts = solve("--tabor", "2.385", "--mie-n", "9", "--law", "mie", "--mie-m", "3")
assert parts["pull_off"] == mie["pull_off"]
# the waves of a cut surface, the tail of an unbounded one, and a mesh that stays
for flags in (["--outer-radius", "60"], [], ["--scheme", "triangle", "--nodes", "301", "--outer-radius", "60"]):
    for law in ("mie:4,10", "morse:1"):
        wavy = solve("--tabor", "1.385", "--amplitude", "0.3", "--wavelength", "11", "--law", law, *flags)
        assert wavy["status"] == "ok", (law, flags)
LOOK
check 'limits of every law' "$python" limits.py "$program"

# The tip of a cone under a law of short range lies between the axis and the first node of the mesh that a trace begins
# with: the mesh must see it. Soft cones tend to JKR.
cat >tips.py <<'LOOK'
import json, subprocess, sys

def solve(*flags):
    return json.loads(subprocess.run([sys.argv[1], "solve", "--json", *flags], check=True, capture_output=True).stdout)

for law, slope, coupling in (("morse:3.145", "0.2198", "13.13"), ("morse:3.939", "0.07987", "3.876")):
    scene = ("--profile", "cone:" + slope, "--coupling", coupling)
    jkr = subprocess.run([sys.argv[1], "theory", "jkr", *scene], check=True, capture_output=True, text=True).stdout
    force = float(jkr.split()[1])
    found = solve("--law", law, *scene)
    assert found["status"] == "ok" and abs(found["pull_off"]["force"] / force - 1) < 1e-4, (law, found["pull_off"], force)
LOOK
check 'tips under laws of short range' "$python" tips.py "$program"

# A parameter that is followed is what a trace of that scene finds.
expect 0 '' follow --law mie:4,10 --key mie-n --from 7 --to 12 --points 6 --tabor 0.7 --tolerance 1e-5 --json
cp "$work/stdout" line.json
cat >follow.py <<'LOOK'
import json, subprocess, sys

points = json.load(open("line.json"))["points"]
assert [p["followed"] for p in points] == [False, True, True, True, True, False]
for p in points[1:5:2]:
    n = repr(p["input"]["mie_n"])
    solved = json.loads(subprocess.run([sys.argv[1], "solve", "--law", "mie:4," + n, "--tabor", "0.7", "--tolerance", "1e-5",
                                        "--json"], check=True, capture_output=True).stdout)
    a, b = p["pull_off"], solved["pull_off"]
    assert abs(a["force"] - b["force"]) <= a["error_estimate"] + b["error_estimate"], (n, a, b)
LOOK
check 'a parameter of the law is followed' "$python" follow.py "$program"

# A table that names no law is of Lennard-Jones; one that names one is of that law.
cd "$work" || exit
restore
sed -i 's/^  tabor: 0$/  tabor: 0\n  law: "mie:4,10"/' "$PULLOFF_DATA/cases/good.yaml"
expect 1 '*outside*' verify good --output run --verbose
check 'another law has no reference' grep -q missing_reference "$work/stdout"
write_table "$PULLOFF_DATA/reference/table.csv" tabor,law,force,approach '0,mie:4;10,2,0' '0,mie:4;12,3,0'
expect 0 '*within*' verify good --output run --verbose
sed -i 's/mie:4,10/mie:4,12/' "$PULLOFF_DATA/cases/good.yaml"
expect 1 '*outside*' verify good --output run --verbose
check 'the row of the law is compared' grep -q 'expected *3\|oracle *outside' "$work/stdout"
write_table "$PULLOFF_DATA/reference/table.csv" tabor,law,profile,waves,force,approach '0,mie:4;12,cone:0.3,-,7,0' \
  '0,mie:4;12,sphere,0.4@12,8,0' '0,mie:4;12,sphere,-,2,0'
expect 0 '*within*' verify good --output run --verbose
sed -i 's/mie:4,12/mie:4,3/' "$PULLOFF_DATA/cases/good.yaml"
expect 2 '*mie_n is 3: expected a number > mie_m*' verify good --output run

finish
