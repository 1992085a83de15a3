#!/bin/sh
# Plots: as characters, and as figures by gnuplot in three formats.
# shellcheck disable=SC1091,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
root=$(cd "$here/../.." && pwd)
export PULLOFF_DATA="$root"
# The locale in which gnuplot warns of characters, unless the program gives it another.
export LC_ALL=C

expect 0 '' plot --tabor 1
check 'the legend' grep -q '^ *equilibria \*\*\*\* *loading #### *unloading \$\$\$\$ *jump ---- *pull-off  X$' stdout
check 'one pull-off' test "$(grep -v pull-off stdout | grep -o X | wc -l)" = 1
check 'no line is too long' awk 'NR > 1 && length($0) > 80 { exit 1 }' stdout
check 'no control characters' test 0 -eq "$(LC_ALL=C grep -c '[[:cntrl:]]' stdout)"
expect 0 '' plot --tabor 1 --want curve
check 'the legend of a branch' grep -q '^ *unstable \*\*\*\* *stable #### *fold  o *pull-off  X$' stdout
check 'two folds' test "$(grep '|' stdout | grep -o o | wc -l)" -ge 2
expect 0 '' plot --tabor 3 --amplitude 1 --wavelength 20 --stiffness 0.3
check 'through a spring over the base and over the approach' test "$(grep -c -e 'against position of the base in epsilon$' \
  -e 'against approach in epsilon$' stdout)" = 2
expect 0 '' plot --tabor 1 --want profile,preload
check 'the profile and the staircase' test "$(grep -c -e '^ *traction in' -e '^ *pull-off force in' stdout)" = 2
check 'and no curve' fails grep -q '^ *load in' stdout
expect 0 '' plot --tabor 0.5 --profile cone:0.5 --preload inf
check 'the unit of the load' grep -q '^ *load in pi w epsilon against' stdout

if command -v gnuplot >/dev/null; then
  # drawn FILE: tests that it is an image of its kind with something in it
  drawn() {
    case $1 in
    *.svg) grep -q '</svg>' "$1" && [ "$(grep -c '<path' "$1")" -gt 10 ] ;;
    *.png) head -c 8 "$1" | od -c | grep -q 'P   N   G' && [ "$(wc -c <"$1")" -gt 5000 ] ;;
    *.pdf) head -c 5 "$1" | grep -q '%PDF-' && [ "$(wc -c <"$1")" -gt 5000 ] ;;
    esac
  }
  for file in a.svg a.png a.pdf; do
    expect 0 '' plot --tabor 3 --amplitude 1 --wavelength 20 $file
    check "$file" drawn $file
    check 'nothing is printed' test ! -s stdout
  done
  check 'the caption is the command' grep -q 'pulloff solve --tabor 3 --amplitude 1 --wavelength 20' a.svg
  expect 0 '' plot --profile cone:0.5 --coupling 0.07 cone.svg
  check 'the caption states the coupling that was given' grep -q 'pulloff solve --coupling 0.07 --outer-radius inf --profile cone' cone.svg
  expect 0 '' solve --tabor 1 --want profile,hysteresis,preload --plot all.svg
  check 'the result is printed' grep -q '^pull-off force 1.67066' stdout
  check 'all panels' test "$(grep -c -e 'approach Δ†/ε' -e 'radius' -e 'preload, largest' all.svg)" -ge 3
  # What a figure needs ended the search beyond the preload, and changed the steps of the trace: another result.
  for words in '' '--want hysteresis' '--stiffness 0.1' '--json'; do
    expect 0 '' solve --tabor 1.7 $words
    grep -v -e '^work' -e '"seconds"' stdout >alone
    expect 0 '' solve --tabor 1.7 $words --plot beside.svg
    grep -v -e '^work' -e '"seconds"' stdout >with_plot
    check "the result of solve $words does not depend on --plot" cmp alone with_plot
    check 'and the figure is drawn' drawn beside.svg
  done
  # shellcheck disable=SC2086
  tip='--from-physical --modulus-pa 5e9 --work-j-per-m2 0.08 --distance-m 3e-10 --radius-m 3e-8'
  expect 0 '' plot $tip --amplitude-m 4e-10 --wavelength-m 6e-9 --preload-load-n 2e-9 --stiffness-n-per-m 2 tip.svg
  check 'axes in SI units' test "$(grep -c -e 'position of the base' -e '(nm)' -e '(nN)' tip.svg)" -ge 3
  check 'the caption in SI units' grep -q 'R = 30 nm, w = 80 mJ/m², E\* = 5 GPa, ε = 0.3 nm, A = 0.4 nm, λ = 6 nm, preload = 2 nN, spring = 2 N/m' tip.svg
  expect 0 '' compare $tip --plot theories.svg
  check 'a row for each theory' test "$(grep -c -e 'JKR' -e 'DMT' -e 'Maugis-Dugdale' theories.svg)" -ge 3
  expect 0 '' follow --key tabor --from 0.5 --to 1 --points 4 --plot series.svg
  check 'a series' drawn series.svg
  check 'its axes' test "$(grep -c -e '>tabor<' -e 'pull-off force/πwR' series.svg)" -ge 2
  expect 0 '' follow --of folds --key tabor --from 1.2 --to 1 --points 4 --plot folds.svg
  check 'folds' test "$(grep -c -e '>jump_in<' -e '>jump_out<' folds.svg)" -ge 2
  expect 0 '' solve --tabor 0 --plot rigid.svg
  check 'a rigid sphere' drawn rigid.svg
  expect 0 '' plot --tabor 0 --plot given.svg
  check 'the figure may be given as to solve' drawn given.svg
  expect 4 'pulloff: nowhere/a.svg cannot be written: *' solve --tabor 1 --plot nowhere/a.svg
  check 'the result is printed although the figure is not' grep -q '^pull-off force 1.67066' stdout
  expect 0 '*' plot --case fig04 --run run fig04.svg
  check 'a run' drawn fig04.svg
  expect 0 '*' plot --case fig04 --run run --plot again.svg
  check 'its figure as an option' drawn again.svg
  expect 0 '*' plot --case fig04 --run run
  check 'a run as characters' grep -q '^ *pull-off force in pi w R against tabor$' stdout
  check 'no file is left' test "$(find . -name 'figure*' | wc -l)" = 0
  mkdir empty
  program_path=$work/empty
  expect 4 'pulloff: gnuplot was not found: *' plot --tabor 0 b.svg
  program_path=
fi
expect 2 'pulloff: --plot is a.gif: expected the name of a file that ends in .svg, .png or .pdf' solve --plot a.gif
expect 2 'pulloff: fig04 is no figure: expected *; a case is given by --case' plot fig04
expect 2 'pulloff: --run is given without --case: expected both' plot --run run
expect 2 'pulloff: --json has no effect on plot: *' plot --json
# These files were not written, and the exit code was 0.
expect 2 'pulloff: --curve has no effect on plot: *' plot --tabor 0 --curve curve.csv
expect 2 'pulloff: --profile-csv has no effect on plot: *' plot --tabor 0 --profile profile.csv
expect 2 'pulloff: --staircase has no effect on plot: *' plot --tabor 0 --staircase steps.csv
expect 2 'pulloff: b.svg is one file too many: *' plot --tabor 0 --plot a.svg b.svg
expect 2 'pulloff: theories is no panel of a plot: *' plot --tabor 0 --want curve,theories
expect 2 'pulloff: options of a scene have no effect on a case: *' plot --case fig04 --tabor 2
expect 2 'pulloff: b.svg is one file too many: expected only one figure' plot --tabor 1 a.svg b.svg
expect 2 'pulloff: unknown option --run of solve *' solve --run run
. "$here/data.sh"
# A map of two numbers; seven of one number and eight of the other are curves.
write_map() { # FROM TO COUNT of the radius
  cat >"$PULLOFF_DATA/cases/good.yaml" <<CASE
name: good
title: A map
suites: [smoke]
scene: {scheme: panel, tolerance: 1e-2, wavelength: 20, radius: 100, outer_radius: inf}
sweep:
  - {key: amplitude_ratio, from: $1, to: $2, count: $3, scale: log}
  - {key: tabor, from: 0.2, to: 0.9, count: 8, scale: linear}
follow: tabor
want: [pull_off]
checks:
  - {quantity: solved_share, reference: every_scene, tolerance: 0.5, kind: abs, because: all have}
CASE
}
ln -s "$root/reports" "$PULLOFF_DATA/reports"
write_map 0.001 0.03 8
expect 0 '*' plot --case good --run map
cp stdout map.text
check 'the map says what it shows' grep -q '^ *pull-off force in pi w R, \.:-=+\*#%@ from [0-9.]* in steps of [0-9.]*$' map.text
cat >map.py <<'MAP'
import json, math

points = json.load(open("map/good/record.json"))["points"]
rows = ["".join(line.split("|")[1].split()) for line in open("map.text") if line.count("|") == 2]
rows = [row for row in rows if row]
assert len(points) == 64 and len(rows) == 8 and all(len(row) == 8 for row in rows), rows
ratios = sorted({p["input"]["amplitude_ratio"] if "amplitude_ratio" in p["input"] else p["input"]["amplitude"] for p in points})
tabors = sorted({p["input"]["tabor"] for p in points})
forces = [p["pull_off"]["force"] for p in points]
low, high = min(forces), max(forces)
for p in points:
    row = rows[7 - ratios.index(p["input"].get("amplitude_ratio", p["input"]["amplitude"]))]
    shade = row[tabors.index(p["input"]["tabor"])]
    level = (p["pull_off"]["force"] - low) / (high - low) * 9
    expected = {".:-=+*#%@"[min(8, max(0, math.floor(level + by)))] for by in (-1e-6, 1e-6)}
    assert shade in expected, (p["label"], shade, expected)
assert len(set("".join(rows))) > 4
MAP
check 'every cell has the shade of its force' python3 map.py
if command -v gnuplot >/dev/null; then
  for file in map.svg map.png map.pdf; do
    expect 0 '*' plot --case good --run map $file
    check "$file" drawn $file
  done
  check 'a cell for each point' test "$(grep -c 'fill = .rgb(' map.svg)" -ge 64
  # boxes that overlap the axes did not count: all forces above those of the other cells had the brightest colour
  check 'the colours reach to the greatest force' test "$(grep -c "fill = 'rgb(253, 231,  37)'" map.svg)" -le 2
  check 'the axes' test "$(grep -c -e 'tabor' -e 'amplitude_ratio' -e 'pull-off force/πwR' map.svg)" -ge 3
  # gnuplot ended at an apostrophe, because it stood beside a backslash or in a name; a word behind @ was a macro.
  title='it'\''s a\'\'\''b "q" @x a @places `id` $y #z {/:Bold b}_c^d~e %d µm'
  printf '%s\n' "$title" >title
  sed -i "s/^title: .*/title: |-/; /^title:/r title" "$PULLOFF_DATA/cases/good.yaml"
  sed -i "/^title:/{n;s/^/  /}" "$PULLOFF_DATA/cases/good.yaml"
  expect 0 '*' plot --case good --run map named.svg
  check 'the title as it is' python3 -c 'import html, sys; sys.exit(sys.argv[1] not in html.unescape(open("named.svg").read()))' "$title"
  { echo r,gap; seq 0 20 | awk '{ print 3 * $1 "," 0.045 * $1 * $1 }'; } >"it's \\ @x.csv"
  expect 0 '' plot --tabor 0 --profile-file "it's \\ @x.csv" file.svg
  check 'the name of a file as a shell reads it' grep -qF "'it'\\''s \\ @x.csv'" file.svg
fi
write_map 0.001 0.03 7
expect 0 '*' plot --case good --run curves
check 'few values of one number are curves' grep -q '^ *pull-off force in pi w R against tabor$' stdout
write_case "$PULLOFF_DATA/cases/good.yaml"
"$program" plot --case good --run own >out 2>err
check 'a case without a sweep' test $? -eq 2
check 'its message' grep -q 'pulloff: no number varies in the case good: expected' err
finish
