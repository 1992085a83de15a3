#!/bin/sh
# Sweeps given by their ends, groups of keys, references for another scene, and closed forms along a sweep.
# shellcheck disable=SC1091,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
file=$PULLOFF_DATA/cases/good.yaml

# column FILE NAME ROW: prints a cell of a table; the first row is 1.
column() {
  grep -v '^#' "$1" | awk -F, -v name="$2" -v row="$3" \
    'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) c = i } NR == row + 1 { print $c }'
}

# same WHAT A B TOLERANCE: tests that two numbers agree to a relative tolerance.
same() {
  check "$1: $2 and $3" awk -v a="$2" -v b="$3" -v t="$4" \
    'BEGIN { d = a - b; exit !(a != "" && b != "" && (d < 0 ? -d : d) <= t * (b < 0 ? -b : b)) }'
}

# from_theory KEY ARGUMENT...: prints a result of `pulloff theory`.
from_theory() {
  key=$1
  shift
  "$program" theory "$@" --json | sed -n "s/^ *\"$key\": \\([^,]*\\),*/\\1/p"
}

restore
write_table "$PULLOFF_DATA/reference/table.csv" alpha,amplitude,tabor,force,approach \
  0.25,1,0,0.74105588164102001,0.0918 4,2.385,0,0.30543829,0.03
cat >"$file" <<'CASE'
name: good
title: Groups and lines
suites: [smoke]
scene: {radius: 61.3, outer_radius: inf, scheme: panel, tolerance: 1e-6, tabor: 1e-4}
sweep:
  - {key: alpha, values: [0.25, 4]}
  - {key: amplitude, values: [1]}
want: [pull_off]
lines:
  - name: rigid
    theory: rigid
    sweep:
      - {key: alpha, from: 0.01, to: 100, count: 5, scale: log}
      - {key: amplitude, values: [1, 2.385]}
  - name: curve
    theory: guduru
    sweep:
      - {key: tabor, values: [2.385]}
      - {key: wavelength, values: [11]}
      - {key: amplitude_ratio, values: [0.063]}
      - {key: contact_radius, from: 0, to: 40, count: 41}
checks:
  - quantity: pull_off_force
    reference: reference/table.csv
    as_if: [{key: tabor, values: [0]}]
    tolerance: 1e-5
    kind: rel
    because: the surface yields a little
    when: [{key: alpha, values: [0.25]}]
CASE
expect 0 '*good: 2 points, 1 check: within' run --output out
record=out/good/record.json
rigid=out/good/line-rigid.csv
curve=out/good/line-curve.csv
check 'the record names both closed forms' grep -q line-curve.csv "$record"
check 'ten rows' test "$(grep -vc '^#' "$rigid")" -eq 11
check 'forty-one rows' test "$(grep -vc '^#' "$curve")" -eq 42
same 'alpha of a decade' "$(column "$rigid" alpha 5)" 1 1e-15
same 'rigid' "$(column "$rigid" pull_off_force 6)" "$(from_theory pull_off_force rigid --alpha 1 --amplitude 2.385)" 1e-14
same 'guduru' "$(column "$curve" load 18)" "$(from_theory load guduru --tabor 2.385 --wavelength 11 \
  --amplitude 0.693 --radius 61.3 --contact-radius 17)" 1e-13
# alpha = A R/lambda^2 = 4
same 'wavelength of a group' "$(awk '/"wavelength"/ { gsub(/[",]/, ""); l = $2 } END { print l * l }' "$record")" \
  "$(awk 'BEGIN { print 61.3 / 4 }')" 1e-5

# bad SED-SCRIPT MESSAGE: edits the case and tests that it is refused.
cp "$file" kept.yaml
bad() {
  sed "$1" kept.yaml >"$file"
  expect 2 "pulloff: cases/good.yaml:$2" run --output none
}
bad 's/from: 0.01/from: 0/' '*: lines[[]1[]].sweep[[]1[]].from is 0: expected a finite number > 0, as the scale is log'
bad 's/to: 100/to: 0.001/' '*: lines[[]1[]].sweep[[]1[]].to is 0.001: expected a finite number > from'
bad 's/count: 5/count: 1/' '*: lines[[]1[]].sweep[[]1[]].count is 1: expected a whole number from 2 to 10000'
bad 's/scale: log/scale: round/' '*: lines[[]1[]].sweep[[]1[]].scale is round: expected linear or log'
bad 's/1, 2.385/1, -2/' '*: lines[[]1[]].sweep[[]2[]].values[[]2[]] is -2: expected a finite number >= 0'
bad 's/1, 2.385/1, two/' '*: lines[[]1[]].sweep[[]2[]].values[[]2[]] is two: expected a *number*'
bad 's/count: 41/count: 41, values: [1]/' '*values*: expected either values, or from, to and count'
bad 's/theory: rigid/theory: alchemy/' '*: lines[[]1[]].theory is alchemy: expected bradley, *'
bad 's/name: curve/name: rigid/' '*: lines[[]2[]].name is rigid: expected each name once'
bad 's/key: contact_radius/key: approach/' '*: lines[[]2[]].sweep[[]4[]].key is approach: expected tabor, *'
bad 's/key: amplitude, values: .1, 2.*/key: radius, values: [1]}/' '*: lines[[]1[]].theory is rigid: expected an amplitude > 0'
bad 's/key: amplitude, values: .1\]/key: amplitude_ratio, values: [1]/' '*: sweep[[]2[]].key is amplitude_ratio: expected one of alpha *'
bad 's/key: amplitude, values: .1\]/key: wavelength, values: [1]/' '*: sweep[[]2[]].key is wavelength: expected each key swept once'
bad 's/as_if: .*/as_if: [{key: tabor, values: [0, 1]}]/' '*: checks[[]1[]].as_if[[]1[]].values is a list: expected one value'
bad 's/as_if: .*/as_if: [{key: colour, values: [0]}]/' '*: checks[[]1[]].as_if[[]1[]].key is colour: expected a key of the scene: tabor, *'

# Laws, profiles and couplings in the sweep of a line, and in the record of a swept case.
cat >"$file" <<'CASE'
name: good
title: Lines of laws and profiles
suites: [smoke]
scene: {outer_radius: inf, scheme: panel, tolerance: 1e-4, coupling: 0.05, approach_end: 1}
sweep:
  - together: [{profile: "power:0.001,4", law: "mie:4,10"}]
want: [pull_off]
lines:
  - name: profiles
    theory: jkr
    sweep:
      - {key: profile, values: ["cone:0.3", "power:0.001,4", sphere]}
      - {key: coupling, values: [0.05, 0.5]}
  - name: laws
    theory: maugis
    sweep:
      - {key: law, values: ["mie:4,10", "morse:1"]}
      - {key: profile, values: ["cone:0.3"]}
      - {key: cone_t, values: [0.2, 0.3]}
checks:
  - {quantity: solved_share, reference: every_scene, tolerance: 1e-9, kind: abs, because: the scene must be solved}
CASE
expect 0 '*good: 1 point, 1 check: within' run --output out --fresh
profiles=out/good/line-profiles.csv
laws=out/good/line-laws.csv
check 'a profile in a table' test "$(column "$profiles" profile 3)" = 'power:0.001;4'
same 'JKR of a power law' "$(column "$profiles" pull_off_force 4)" \
  "$(from_theory pull_off_force jkr --profile power:0.001,4 --coupling 0.5)" 1e-14
same 'JKR of a sphere beside other profiles' "$(column "$profiles" pull_off_force 6)" 1.5 1e-12
same 'Maugis-Dugdale of a law' "$(column "$laws" pull_off_force 3)" \
  "$(from_theory pull_off_force maugis --law morse:1 --profile cone:0.2 --coupling 0.05)" 1e-14
check 'the record has laws and profiles with their parameters' \
  sh -c 'grep -q "\"law\": \"mie:4,10\"" "$1" && grep -q "\"profile\": \"power:0.001,4\"" "$1"' - "$record"
cp "$file" kept.yaml
bad 's/theory: jkr/theory: guduru/' '*: lines[[]1[]].sweep[[]1[]].key is profile: expected tabor, *'
bad 's/"cone:0.3", "p/"cone:-1", "p/' '*: lines[[]1[]].sweep (profile=cone:-1): *'
bad 's/key: cone_t/key: power_n/' '*: lines[[]2[]].sweep[[]3[]].key is power_n: expected a parameter of *'
sed -e '/^  - name: laws/,/cone_t/d' -e 's/theory: jkr/theory: kesari-lew/' -e 's/key: profile, .*/key: amplitude, values: [1]}/' \
  -e 's/^scene: {/&profile: "cone:0.3", /' -e 's/profile: "power[^}]*law/law/' kept.yaml >"$file"
expect 2 'pulloff: cases/good.yaml:*: lines[[]1[]].theory is kesari-lew: expected one of rigid, jkr, maugis and persson-brener*' run --output none
finish
