#!/bin/sh
# The section on a case folder of one's own: its commands, one after the other, in an empty folder. And pulloff seal.
# shellcheck disable=SC1091,SC2154
. "$(dirname "$0")/lib.sh"
mkdir bin empty
ln -s "$program" bin/pulloff
PATH=$work/bin:$PATH
PULLOFF_DATA=$here/../..
export PATH PULLOFF_DATA

awk '/^## A case folder of your own$/ { section = 1 } /^```sh$/ { inside = section; next } /^```$/ { inside = 0 } inside' \
  "$here/../../doc/cases.md" >commands
check 'the page has commands' test "$(grep -c pulloff commands)" -gt 8
(cd empty && sh -e ../commands) >stdout 2>stderr
check "the commands of the page: $(cat stderr)" test $? -eq 0
has() { check "printed: $1; there is: $(cat stdout stderr)" grep -qE "$1" stdout stderr; }
has 'my/data/tip.csv lacks 6 headers: expected the options --what, --source, --kind, --method, --units, --uncertainty'
has '^my/data/tip.csv is sealed'
has '^tips +4 +0 +0'
has '2 of 2 results are identical to the last bit'
has '^measured +1 +0 +0'
has '^rigid:tips .*coverage 1/2 points, 2/4 checks'
has 'rigid:tips pull_off_force, tabor=0.1: outside'
check 'verdicts for continuous integration' test "$(grep -c '<testcase ' empty/verdicts.xml)" = 5
# The recipe for GitHub wrote the verdicts for its viewer and did not keep them.
for recipe in gitlab-ci verify; do
  recipe=$here/../../doc/examples/ci/$recipe.yml
  check "$recipe verifies" grep -q 'pulloff verify .* --output verdicts --junit verdicts.xml' "$recipe"
  grep -v 'pulloff verify' "$recipe" >rest
  check "$recipe keeps the record" grep -qE '(paths: \[|^ *)verdicts\]?($|,)' rest
  check "$recipe keeps the verdicts" grep -q 'verdicts\.xml' rest
done
check 'pins are beside the case' test -s empty/my/pins/tips.csv

# The solver of the page without its repeats.
sed -i 's/range(asked\["repeats"\])/range(1)/' empty/my/rigid.py
check 'the solver of the page has repeats' grep -q 'range(1)' empty/my/rigid.py
expect 1 '' conform empty/my/rigid.yaml
check 'repeats that are lacking are wrong' grep -qE '^wrong +repeats: 1 answers to a request of 2 repeats' stdout

# A table of one's own: what other programs write, and what is wrong.
expect 2 'pulloff: seal needs the names of tables (see pulloff seal --help)' seal
expect 4 'pulloff: absent.csv cannot be opened: *' seal absent.csv
all="--what a --source b --kind oracle --method c --units d --uncertainty 0"
printf '\357\273\277tabor,force\r\n1,1.67\r\n2,1.58' >foreign.csv
# shellcheck disable=SC2086 # words are meant
expect 0 '' seal $all foreign.csv
check 'line ends and the byte order mark are removed' \
  sh -c '! grep -q "$(printf "\r")" foreign.csv && tail -n 1 foreign.csv | grep -qx 2,1.58 && head -c 1 foreign.csv | grep -q "#"'
cp foreign.csv before.csv
expect 0 '' seal foreign.csv
check 'a second time nothing changes' cmp foreign.csv before.csv
# A European table was refused by the number of its cells, and one in UTF-16 by its byte \xff, as those with a checksum are read strictly.
printf 'Instrument;X\ntabor;force;note\n0,5;1,75;"a, b"\n1;1,67;c\n' >european.csv
iconv -f utf-8 -t utf-16 european.csv >wide.csv
for table in european wide; do
  # shellcheck disable=SC2086
  expect 0 '' seal $all $table.csv
  tail -n 3 $table.csv >rows
  printf 'tabor,force,note\n0.5,1.75,"a, b"\n1,1.67,c\n' >plain
  check "$table: the sealed table is plain" cmp rows plain
  check "$table: text above the names becomes a header" grep -qx '# line 1: Instrument;X' $table.csv
done
sed -i 's/1.58/1.59/' foreign.csv
expect 0 '' seal --what other foreign.csv
check 'a header is replaced' grep -qx '# what: other' foreign.csv
printf 'tabor,force\n1,1.67,3\n' >ragged.csv
cp ragged.csv before.csv
# shellcheck disable=SC2086
expect 4 'pulloff: ragged.csv:*' seal $all ragged.csv
check 'a table that is refused is unchanged' cmp ragged.csv before.csv
check 'no other file is left' test -z "$(ls ./*.seal-* 2>/dev/null)"
# Cells that are no numbers in a column of numbers were sealed, and found once a check read them.
for row in 'tabor,force 1,nan:force is nan' 'tabor,force 1,two:force is two' 'tabor,force_nN 1,inf:force_nN is inf' \
  'tabor,force,mass 1,2,3 2,3,nan:mass is nan' 'tabor,force,mass 1,2,x 2,3,4:mass is x' \
  'tabor,force,force_uncertainty 1,2,-:force_uncertainty is -' 'kind,approach,load jump_in,1,text:load is text'; do
  # shellcheck disable=SC2086
  printf '%s\n' ${row%%:*} >numbers.csv
  cp numbers.csv before.csv
  # shellcheck disable=SC2086
  expect 4 "pulloff: numbers.csv:*: ${row#*:}: expected a finite number" seal $all numbers.csv
  check "$row: the table is unchanged" cmp numbers.csv before.csv
done
printf 'tabor,force\nsoft,1\n' >numbers.csv
# shellcheck disable=SC2086
expect 4 'pulloff: numbers.csv:*: tabor is soft: expected a finite number >= 0' seal $all numbers.csv
printf 'tabor,outer_radius,kind,name,force,note_load\n1,inf,jump_in,a tip,1.67,inf\n2,7,jump_out,b,1.6,-\n' >numbers.csv
# shellcheck disable=SC2086
expect 0 '' seal $all numbers.csv
for table in "$here"/../../reference/*.csv; do
  cp "$table" numbers.csv
  expect 0 '' seal numbers.csv
done
printf 'tabor,force\n1,1.67\n' >bare.csv
cat >case.yaml <<'END'
name: bare
title: A table without headers
suites: [own]
scene: {tabor: 1, radius: 100, outer_radius: inf, scheme: panel}
want: [pull_off]
checks: [{quantity: pull_off_force, reference: bare.csv, tolerance: 1, kind: abs, because: b}]
END
expect 4 'pulloff: bare.csv:1: 10 headers are missing: expected lines *: ...* above for what, source, kind, method, units, uncertainty, generator, command, date, sha256; pulloff seal adds them' verify case.yaml
# shellcheck disable=SC2086
expect 2 'pulloff: --what has several lines or a control character: expected one line' seal $all --what "a
b" bare.csv
finish
