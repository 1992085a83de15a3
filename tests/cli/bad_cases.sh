#!/bin/sh
# Wrong case files: the message is one line with file, line, path, value and what was expected. The exit code is 2, and
# nothing is written.
# shellcheck disable=SC1091,SC2013,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
file=$PULLOFF_DATA/cases/good.yaml

# spoilt SED-SCRIPT MESSAGE: edits the good case and tests that it is refused.
spoilt() {
  restore
  sed -i "$1" "$file"
  expect 2 "pulloff: cases/good.yaml:$2" run --output out
  check 'nothing is written' test ! -e out
}

restore
expect 0 '*good: 1 point, 1 check: within' run --output out0
expect 2 'pulloff: no case is named nobody: expected one of good' run nobody
expect 2 'pulloff: cases and --suite are given: expected one of them' run good --suite smoke
expect 2 'pulloff: no case belongs to the suite extreme: expected one of smoke' run --suite extreme
expect 2 'pulloff: no case belongs to the suite empty: expected one of smoke' list --suite smoke,,smoke
expect 4 'pulloff: absent.yaml cannot be opened: No such file or directory' run absent.yaml

# Infinity as YAML spells it was refused where it is meant, and a byte order mark is no text.
for infinity in .inf .Inf .INF +.inf; do
  restore
  sed -i "s/outer_radius: inf/outer_radius: $infinity/" "$file"
  expect 0 '*good: 1 point, 1 check: within*' run --output out0
done
{ printf '\357\273\277' && cat "$file"; } >"$work/marked" && mv "$work/marked" "$file"
expect 0 '*good: 1 point, 1 check: within*' run --output out0
spoilt 's/outer_radius: inf/outer_radius: -.inf/' '8: scene.outer_radius is -.inf: expected a finite number > 0, or inf'
spoilt 's/outer_radius: inf/outer_radius: .nan/' '8: scene.outer_radius is .nan: expected a finite number > 0, or inf'
spoilt 's/outer_radius: inf/outer_radius: ".inf"/' '8: scene.outer_radius is .inf: expected a finite number > 0, or inf'

spoilt 's/radius: 100/radius: -3/' '7: scene.radius is -3: expected a finite number > 0'
spoilt 's/radius: 100/radius: .inf/' '7: scene.radius is .inf: expected a finite number > 0'
spoilt 's/radius: 100/radius: wide/' '7: scene.radius is wide: expected a finite number > 0'
spoilt 's/radius: 100/radius: [100]/' '7: scene.radius is a list: expected a finite number > 0'
spoilt 's/radius: 100/radius:/' '7: scene.radius is empty: expected a finite number > 0'
spoilt 's/radius: 100/&\n  morse_a: 3/' \
  '8: scene.morse_a is 3: expected a parameter of the law or the profile of a point or a line'
spoilt 's/^scene:/sweep: [{key: cone_t, values: [1, 2]}]\n&/' \
  '4: sweep[[]1[]] is *: expected a parameter of the law or the profile of a point or a line'
spoilt 's/nodes: 101/nodes: 3.5/' '10: scene.nodes is 3.5: expected a whole number > 0'
spoilt 's/nodes: 101/nodes: -5/' '10: scene.nodes is -5: expected a whole number > 0'
spoilt 's/scheme: triangle/scheme: cube/' '9: scene.scheme is cube: expected ring, triangle or panel'
spoilt 's/  radius: 100/  radios: 100/' \
  '7: scene.radios is unknown: expected one of tabor, amplitude, wavelength, radius, *; did you mean radius[?]'
spoilt '/  radius/d' '4: scene.radius is missing: expected a finite number > 0, here, in the sweep or in the sample'
spoilt 's/amplitude: 0/amplitude: 1/' \
  '4: scene.wavelength is missing: expected a finite number > 0, here, in the sweep or in the sample'
spoilt 's/  radius: 100/  radius: 100\n  radius: 50/' \
  '8: radius is given twice, first on line 7: expected it once'
spoilt 's/^name: good/name: good\nname: bad/' \
  '2: name is given twice, first on line 1: expected it once'
spoilt '/^name/d' '1: name is missing: expected letters, digits, _ and -'
spoilt 's/^name: good/name: ..\/good/' '1: name is ../good: expected letters, digits, _ and -'
spoilt 's/^name: good/name: solvers/' '1: name is solvers: expected another name: records of external solvers are in this folder'
spoilt '/^want/d' '*: want is missing: expected a list of pull_off, folds, extrema, curve, profile, hysteresis, diagnostics, preload, theories, loop'
spoilt 's/want: .*/want: pull_off/' '11: want is pull_off: expected a list of pull_off, *'
spoilt 's/want: .*/want: [pudding]/' \
  '11: want[[]1[]] is pudding: expected pull_off, folds, extrema, curve, profile, hysteresis, diagnostics, preload, theories or loop'
spoilt 's/want: .*/want: []/' '11: want is a list: expected a list of pull_off, *'
spoilt 's/suites: .*/suites: [smoke, "des,sert"]/' \
  '3: suites[[]2[]] is des,sert: expected letters, digits, _ and -'
spoilt 's/^title: .*/title: A\n"a.b[1]": 3/' '3: a.b[[]1[]] is unknown: expected one of name, *'
spoilt 's/^title: .*/title: A\n"": 3/' "3: '' is unknown: expected one of name, *"
spoilt 's/^want: .*/want: [pull_off, [folds]]/' '11: want[[]2[]] is a list: expected a list of pull_off, *'
spoilt 's/^title: .*/flavour: sweet/' '2: flavour is unknown: expected one of name, title, figure, *'
spoilt 's/^scene:/scene: 3\nscenery:/' '4: scene is 3: expected a mapping of scene keys'
spoilt 's/^want/repeats: 0\nwant/' '11: repeats is 0: expected a whole number from 1 to 1000'
spoilt 's/^want/sweep:\n  - key: colour\n    values: [1]\nwant/' \
  '12: sweep[[]1[]].key is colour: expected a key of the scene: tabor, amplitude, *, coupling'
spoilt 's/^want/sweep:\n  - key: tabor\n    values: [1]\nwant/' \
  '12: sweep[[]1[]].key is tabor: expected a key that the scene does not give'
spoilt 's/^want/sweep:\n  - key: approach_end\n    values: [1, nan]\nwant/' \
  '13: sweep[[]1[]].values[[]2[]] is nan: expected a finite number'
spoilt 's/^want/sweep:\n  - key: approach_end\n    values: [0.1, 0.10]\nwant/' \
  '13: sweep[[]1[]].values[[]2[]] is 0.10: expected each value once'
spoilt 's/^want/sweep:\n  - key: approach_end\nwant/' \
  '12: sweep[[]1[]].values is missing: expected a list of values, or from, to and count'
spoilt 's/pull_off_force/pull_on/' '13: checks[[]1[]].quantity is pull_on: expected pull_off_force, *'
spoilt 's/tolerance: 1e-9/tolerance: 0/' \
  '15: checks[[]1[]].tolerance is 0: expected a finite number > 0'
spoilt 's/tolerance: 1e-9/tolerance: .nan/' \
  '15: checks[[]1[]].tolerance is .nan: expected a finite number > 0'
spoilt 's/kind: abs/kind: roughly/' \
  '16: checks[[]1[]].kind is roughly: expected abs, rel or ulp'
spoilt 's/pull_off_force/solved_share/' \
  '14: checks[[]1[]].reference is reference/table.csv: expected every_scene, *'
spoilt 's/reference: .*/reference: every_scene/' \
  '14: checks[[]1[]].reference is every_scene: expected bradley or the path of a CSV file'
spoilt 's/pull_off_force/jumps/; s/reference: .*/reference: bradley/' \
  '14: checks[[]1[]].reference is bradley: expected the path of a CSV file, as only tables contain hysteresis'
spoilt 's/pull_off_force/solved_share/; s/reference: .*/reference: every_scene/; s/kind: abs/kind: rel/' \
  '16: checks[[]1[]].kind is rel: expected abs, as a share is absolute'
spoilt 's/pull_off_force/solved_share/; s/reference: .*/reference: every_scene/; s/1e-9/1/' \
  '15: checks[[]1[]].tolerance is 1: expected the share that may fail, below 1'
spoilt 's/pull_off_force/residual/' \
  '14: checks[[]1[]].reference is reference/table.csv: expected zero, *'
spoilt 's/reference: .*/reference: zero/' \
  '14: checks[[]1[]].reference is zero: expected bradley or the path of a CSV file'
spoilt 's/pull_off_force/moved_force/; s/reference: .*/reference: zero/; s/kind: abs/kind: rel/' \
  '16: checks[[]1[]].kind is rel: expected abs, as the reference is zero'
spoilt '/because/d' '*: checks[[]1[]].because is missing: expected the reason for the tolerance'
spoilt 's/because: .*/because: ""/' \
  '17: checks[[]1[]].because is empty: expected the reason for the tolerance'
spoilt 's/because: .*/because: "  "/' \
  '17: checks[[]1[]].because is   : expected the reason for the tolerance'
spoilt 's/because: .*/&\n    when: [{key: tabor, values: [3]}]/' \
  '18: checks[[]1[]].when is a list: expected a condition that holds for at least one point'
spoilt 's/because: .*/&\n    whence: 3/' '18: checks[[]1[]].whence is unknown: expected one of *'
spoilt 's/^  tabor: 0/\ttabor: 0/' '*: not YAML: found character that cannot start any token'
spoilt 's/^want: .*/want: [pull_off/' '*: not YAML: *'
spoilt 's/^  tabor: 0/  tabor: \&x 0\n  grading: *x/' '5: an alias refers to this value: expected none'
spoilt '$a---\nname: more' '*: a second document begins: expected one case a file'

restore
: >"$file"
expect 2 'pulloff: cases/good.yaml:1: the file is empty: expected a case' list
printf '\177ELF\002\001\000\000\000' >"$file"
expect 2 'pulloff: cases/good.yaml:1: the file is not text, it contains a zero byte, as UTF-16 does: expected a case in UTF-8' list
printf '\377\376\375name' >"$file"
expect 2 'pulloff: cases/good.yaml:1: not YAML: *' list
printf '%s\n' '- a' '- b' >"$file"
expect 2 'pulloff: cases/good.yaml:1: not a case: expected key: value' list

# libyaml read 100,000 open brackets for two minutes, as many anchors for more, and an unknown key was printed in full.
hostile() { # MESSAGE LINE COUNT ITEM: the case with a line that repeats an item
  restore
  awk -v line="$2" -v count="$3" -v item="$4" 'BEGIN { printf "%s", line; while (count-- > 0) printf item, count; print "" }' >>"$file"
  expect 2 "pulloff: cases/good.yaml:$1: expected a case" list
}
hostile '18: the file has more than 64 levels of lists and mappings' 'extra: ' 100000 '['
hostile '18: the file has more than 64 levels of lists and mappings' 'extra: ' 100000 '{a: '
hostile '19: the file has more than 64 levels of lists and mappings' 'extra:
  ' 100000 '- '
hostile '18: the file has more than 64 anchors' 'extra: [' 100000 '&a%d x, '
hostile '82: the file has more than 64 lines that begin with %' '' 100000 '%%TAG !a%d! b:\n'
restore
awk 'BEGIN { while (n++ < 100000) printf "key"; print ": 1" }' | sed 's/^/? /; s/: 1$//' >>"$file"
expect 2 'pulloff: cases/good.yaml:18: keykey*... is unknown: expected one of *' list
check 'the message is short' test "$(wc -c <stderr)" -lt 2000

restore
cp "$file" "$PULLOFF_DATA/cases/twin.yaml"
expect 2 'pulloff: cases/twin.yaml: name is good: expected another name, as cases/good.yaml has this one' \
  run good
restore
mv "$PULLOFF_DATA/cases" "$PULLOFF_DATA/elsewhere"
expect 4 'pulloff: the folder */cases cannot be read: No such file or directory' list
finish
