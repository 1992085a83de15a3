#!/bin/sh
# Wrong reference tables (damaged rows and headers: tests/harness/test_base.c): the message is one line with file and line. The
# exit code is 4 if the table is unreadable or damaged, and 2 if the case needs a column or a row that the table does not have.
# shellcheck disable=SC1091,SC2013,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
table=$PULLOFF_DATA/reference/table.csv

refused() { # CODE MESSAGE
  expect "$1" "pulloff: $2" verify good --output out
  check 'nothing is solved' test ! -e out/good
  restore
}

rm "$table"
refused 4 '*/reference/table.csv cannot be opened: No such file or directory'
rm "$table" && mkdir "$table"
refused 4 '*/reference/table.csv cannot be read: Is a directory'
printf 'a\000b\n' >"$table"
refused 4 'reference/table.csv is not a text file: it contains a NUL byte, as *'
sed -i 's/^0,2,0/0,2.1,0/' "$table"
refused 4 'reference/table.csv:10: sha256 is *: expected *, the digest of all other lines*'
sed -i 's/^# uncertainty: 0/# uncertainty: 1/' "$table"
refused 4 'reference/table.csv:10: sha256 is *: expected *, the digest of all other lines*'
sed -i '/^# units/d' "$table"
refused 4 'reference/table.csv:10: the header units is missing: expected *'
sed -i 's/^# units:.*/# units:/' "$table"
refused 4 'reference/table.csv:5: the header units is empty'
sed -i 's/^# kind:.*/# kind: rumour/' "$table" && seal "$table"
refused 4 'reference/table.csv:3: kind is rumour: expected oracle or published'
write_table "$table" tabor,approach 0,0
refused 4 'reference/table.csv:11: the column force is missing'
write_table "$table" tabor,force,approach 0,2,0 1,2,3,4
refused 4 'reference/table.csv:13: the row has 4 cells: expected 3, separated by commas (decimal commas need another separator)'
write_table "$table" tabor,force,approach 0,two,0
refused 4 'reference/table.csv:12: force is two: expected a finite number'
write_table "$table" tabor,force,approach 0,nan,0
refused 4 'reference/table.csv:12: force is nan: expected a finite number'
write_table "$table" tabor,force,approach -1,2,0
refused 4 'reference/table.csv:12: tabor is -1: expected a finite number >= 0'
write_table "$table" tabor,force,approach 0,2,0 0,2,0
refused 4 'reference/table.csv:13: a second row for the same scene: expected one'
write_table "$table" tabor,force,approach,force_uncertainty 0,2,0,1e-6
refused 2 'cases/good.yaml:15: checks[[]1[]].tolerance is 1e-9: expected at least 1e-06, *'

# A tolerance relative to a value that is 0, or 0 within its uncertainty, was "inf times the tolerance" of a wrong
# program. It is an error of the case: with every kind of value, and units in the last place are relative, too.
relative() { # KIND QUANTITY COLUMNS ROW VALUE
  restore
  write_table "$table" "$3" "$4"
  sed -i "s/quantity: .*/quantity: $2/; s/kind: abs/kind: $1/" "$PULLOFF_DATA/cases/good.yaml"
  expect 2 "pulloff: cases/good.yaml:15: checks[[]1].kind is $1, but reference/table.csv has the value $5, to which no tolerance can be relative: expected kind: abs, with a tolerance in the unit of $2" \
    plan good
}
for kind in rel ulp; do
  relative $kind pull_off_approach tabor,force,approach 0,2,0 0
  relative $kind pull_off_approach tabor,force,approach,uncertainty 0,2,0,0 0
  relative $kind pull_off_force tabor,force,approach,force_uncertainty 0,2,0,3 '2 with an uncertainty of 3'
  relative $kind hysteresis_loss tabor,energy_lost,uncertainty 0,0,0 0
  relative $kind extrema tabor,kind,approach,load,uncertainty 0,minimum,0,-2,0 0
  relative $kind jumps tabor,phase,approach,load_before,load_after,energy_lost,uncertainty 0,loading,1,2,0,3,0 0
done
restore
sed -i 's/quantity: .*/quantity: pull_off_approach/; s/reference: .*/reference: bradley/; s/kind: abs/kind: rel/' "$PULLOFF_DATA/cases/good.yaml"
expect 2 'pulloff: cases/good.yaml:15: checks[[]1].kind is rel, but bradley has the value 0, to which *' verify good --output out
restore

# A row of a table by its name, for any scene: its columns problem, quantity, value and half_width.
named() { # ROW
  restore
  write_table "$table" problem,quantity,value,half_width easy,pull_off_force,2,1e-12 easy,radius,3,1e-12 hard.1,pull_off_force,1.9,1e-6
  sed -i "s|reference: reference/table.csv|reference: \"reference/table.csv#$1\"|" "$PULLOFF_DATA/cases/good.yaml"
}
named easy:pull_off_force
expect 0 '' plan good
check 'rows of other problems are no matter' sh -c "! grep -q 'rows of' '$work/stdout'"
expect 0 '*' verify good --output out --tap
check 'the check has the name of the row' grep -q '^ok 1 - good pull_off_force/easy:pull_off_force/scene$' "$work/stdout"
named easy:radius
expect 1 '*' verify good --output out
check 'another number is outside' grep -q outside "$work/stdout"
named hard.1:pull_off_force
expect 2 'pulloff: cases/good.yaml:15: checks[[]1[]].tolerance is 1e-9: expected at least 1e-06, *' verify good --output out
named easy:force
expect 4 'pulloff: reference/table.csv:11: no row easy:force: expected PROBLEM:QUANTITY of the columns problem and quantity' plan good
named easy
expect 4 'pulloff: reference/table.csv:11: no row easy: expected *' plan good
named easy:pull_off_force
sed -i 's/quantity: pull_off_force/quantity: extrema/' "$PULLOFF_DATA/cases/good.yaml"
expect 2 'pulloff: reference/table.csv#easy:pull_off_force has one number: expected a quantity that is one, not extrema' plan good
restore

# The plan says which rows of a table no scene of the case has.
write_table "$table" tabor,force,approach 0,2,0 1,1.6,0 2,1.5,0 3,1.5,0 5,1.5,0
expect 0 '' plan good
check "all rows but one: $(cat "$work/stdout")" \
  grep -q '^  no scene of the case is that of 4 of 5 rows of reference/table.csv: lines 13-16$' "$work/stdout"
sed -i '/^  tabor: 0/d; s/^want/sweep: [{key: tabor, values: [0, 2, 5]}]\nwant/' "$PULLOFF_DATA/cases/good.yaml"
expect 0 '' plan good
check 'two rows' grep -q '2 of 5 rows of reference/table.csv: lines 13, 15$' "$work/stdout"
sed -i 's/values: .0, 2, 5./values: [0, 1, 2, 3, 5]/' "$PULLOFF_DATA/cases/good.yaml"
expect 0 '' plan good
check 'no row' sh -c "! grep -q 'rows of' '$work/stdout'"
restore

# If a reference has no row for the scene, the verdict is missing_reference. It does not pass, but it is no error.
write_table "$table" tabor,force,approach 1,1.6,0
expect 1 '*' verify good --output out
check 'the verdict says so' grep -q missing_reference "$work/stdout"
restore
write_table "$table" tabor,force,approach 0,1.9,0
expect 1 '*' verify good --output out
check 'a wrong number is outside' grep -q outside "$work/stdout"
expect 1 '*' verify good --output out --tap --junit junit.xml
check 'not ok in TAP' grep -q '^not ok 1 - good pull_off_force/table/scene$' "$work/stdout"
check 'a failure in JUnit' grep -q '<failure message="outside: obtained 2,' junit.xml
restore
expect 0 '*' verify good --output out --tap
check 'ok in TAP' grep -q '^ok 1 - good pull_off_force/table/scene$' "$work/stdout"

# Checks of the same number with other tolerances have names of their own; those of other points keep theirs.
sed -i '/^  tabor: 0/d; s/^want/sweep: [{key: tabor, values: [0, 1e-6]}]\nwant/' "$PULLOFF_DATA/cases/good.yaml"
write_table "$table" tabor,force,approach 0,2,0 1e-6,2,0
cat >>"$PULLOFF_DATA/cases/good.yaml" <<'CHECKS'
    when: [{key: tabor, values: [0]}]
  - {quantity: pull_off_force, reference: reference/table.csv, tolerance: 1e-8, kind: abs, because: it is tried}
  - {quantity: solved_share, reference: every_scene, tolerance: 0.1, kind: abs, because: it is tried}
  - {quantity: solved_share, reference: every_scene, tolerance: 0.2, kind: abs, because: it is tried}
CHECKS
expect 0 '*' verify good --output out --tap
number=pull_off_force/table/tabor share=solved_share/every_scene
check "names: $(cat "$work/stdout")" [ "$(sed -n 's/^ok . - good //p' "$work/stdout")" = \
  "$(printf '%s\n' $number=0 $number=0/check-2 $number=1e-6 $share $share/check-4)" ]
finish
