#!/bin/sh
# Results are compared with their pins to the last bit. A difference within rounding is counted, a greater one fails, and so
# does a tenth more work; with --identical every difference fails.
# shellcheck disable=SC1091,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null USER=tester
folder=$PULLOFF_DATA/cases
digests=$folder/pins/good.csv
sed -i 's/^  tabor: 0$/&.5/; s/^  scheme.*/  scheme: panel\n  tolerance: 1e-5/; /^  nodes/d; /^  radius/d
  s/^want/sweep: [{key: radius, values: [90, 100, 110]}]\nwant/; /checks:/,$d' \
  "$folder/good.yaml"
cat >>"$folder/good.yaml" <<'CHECK'
checks:
  - {quantity: energy_defect, reference: zero, tolerance: 1e-4, kind: abs, because: it must not be large}
CHECK

# ends CODE ARGUMENT...: tests the exit code where standard error has several lines
ends() {
  code=$1
  shift
  "$program" "$@" >"$work/stdout" 2>"$work/stderr"
  check "exit code $code of pulloff $*" test $? -eq "$code"
}
says() { check "the line $1" grep -q -e "$1" "$work/stdout"; }
silent() { check "no line $1" test 0 -eq "$(grep -c -e "$1" "$work/stdout")"; }

# alter SED-SCRIPT [FILE]: edits a table and corrects its checksum
alter() {
  sed -i "$1" "${2:-$digests}"
  seal "${2:-$digests}"
}

# Without stored digests there is nothing to compare, and nothing is identical.
expect 0 '*' verify good --output run
silent identical
expect 1 '*' verify good --output run --identical
says '^good: 3 results are not stored; pulloff bless good --reason TEXT stores them$'
expect 1 '*' verify good --output run --identical --tap
says '^not ok 4 - good stored_results/pin$'
expect 0 '*' bless good --reason first --output run
says '^cases/pins/good.csv: 3 results, 3 new$'
check 'one row a point' test 3 -eq "$(grep -c -E '^[0-2],[0-9a-f]{16},1\.[0-9]{14}[0-9]*(,[0-9]+){5}$' "$digests")"
expect 0 '*' verify good --output run
says '^3 of 3 results are identical to the last bit with the stored ones$'
expect 0 '*' verify good --output run --identical
expect 0 '*' verify good --output run --points 1-2
says '^2 of 2 results are identical'
expect 0 '*' verify good --output run --tap
says '^# 3 of 3 results are identical'
says '^ok 4 - good stored_results/pin$'
cp "$digests" first.csv
expect 0 '*' bless good --reason again --output run
check 'nothing is written' cmp "$digests" first.csv

# Another last bit: of another quantity than the force, and of the force.
alter 's/^1,./1,x/'
expect 0 '*' verify good --output run
says '^2 of 3 results are identical to the last bit with the stored ones, 1 differ: their pull-off forces by at most 0$'
force=$(sed -n 's/^1,[^,]*,\([^,]*\),.*/\1/p' "$digests")
pinned() { alter "s/^1,[^,]*,[^,]*/1,0123456789abcdef,$1/"; } # FORCE
pinned "${force%??????}999999"
expect 0 '*' verify good --output run
says '^2 of 3 results .* 1 differ: their pull-off forces by at most [0-9.]*e-1[0-9]$'
silent 'not the stored ones'
expect 1 '*' verify good --output run --identical
says '^good: 1 of 3 results are not the stored ones; the pull-off force of radius=100 differs most, by .*: zero can judge it$'
expect 1 '*' verify good --output run --identical --tap
says '^# good: 1 of 3 results'
says '^not ok 4 - good stored_results/pin$'
expect 1 '*' verify good --output run --identical --junit identical.xml
check 'a result that is not identical is a failed test' grep -q 'stored_results/pin"><failure' identical.xml
expect 0 '*' verify good --output run --tap
says '^ok 4 - good stored_results/pin$'

# An oracle whose name is part of that of another one was left out, and a table that does not exist was named.
cp "$folder/good.yaml" first.yaml
write_table "$PULLOFF_DATA/reference/zero_force.csv" radius,force 90,1.8 100,1.8 110,1.8
sed -i 's/^  - {quantity: energy_defect/  - {quantity: pull_off_force, reference: reference\/zero_force.csv, tolerance: 0.5, kind: abs, because: b}\
  - {quantity: pull_off_force, reference: reference\/published\/none.csv, tolerance: 0.5, kind: abs, because: b, stand_in: reference\/zero_force.csv}\n&/' \
  "$folder/good.yaml"
expect 1 '*' verify good --output other --identical
says ': zero_force, zero can judge it$'
mv first.yaml "$folder/good.yaml"

# More than rounding, and a force that was not there.
pinned "${force%????????????}999999999999"
expect 1 '*' verify good --output run
says '1 by more than rounding$'
expect 1 '*' verify good --output run --tap --junit junit.xml
says '^not ok 4 - good stored_results/pin$'
check 'JUnit has it, too' grep -q 'name="stored_results/pin"><failure' junit.xml
pinned -
expect 1 '*' verify good --output run
says '1 differ: their pull-off forces by at most inf, 1 by more than rounding$'
says 'only one of both results of radius=100 has a pull-off force: zero can judge it$'
alter '/^1,/d'
expect 0 '*' verify good --output run
says '^2 of 2 results are identical'
expect 0 '*' bless good --reason again --output run
says '^cases/pins/good.csv: 3 results, 1 new$'

# The table is damaged.
sed -i 's/^1,./1,x/' "$digests"
expect 4 'pulloff: cases/pins/good.csv:*: sha256 is *' verify good --output run
alter 's/^point,/colour,/'
expect 4 'pulloff: cases/pins/good.csv:*: expected the columns point,digest,pull_off_force,points,*' verify good --output run
cp first.csv "$digests"

# Other work fails with --identical, and if a counter of the case is a tenth above the stored ones.
points=$(sed -n 's/^1,[^,]*,[^,]*,\([^,]*\),.*/\1/p' "$digests")
worked() { alter "s/^\(1,[^,]*,[^,]*\),[^,]*/\1,$1/"; } # POINTS
worked $((points + 1))
expect 0 '*' verify good --output run
says '^3 of 3 results are identical to the last bit with the stored ones; 1 took other work$'
expect 1 '*' verify good --output run --identical
says '^good: 1 of 3 results took other work than the stored ones: points -[0-9.]* % in all$'
worked 1
expect 1 '*' verify good --output run
says '^good: 1 of 3 results took other work than the stored ones: points +[0-9.]* % in all$'
expect 1 '*' verify good --output run --tap
says '^not ok 4 - good stored_results/pin$'
worked -
expect 0 '*' verify good --output run --identical
expect 0 '*' bless good --reason 'the work is stored again' --output run
says '^cases/pins/good.csv: 3 results, 1 new$'

# Digests of other scenes are not compared: those of the same numbers were, and each result differed.
expect 0 '*' verify good --output run --identical --time-limit 500
says '^3 of 3 results are identical'
sed -i 's/\[90, 100, 110\]/[110, 100, 90]/' "$folder/good.yaml"
expect 0 '*' verify good --output run
silent 'results are\|scenes'
expect 1 '*' verify good --output run --identical
says '^good: its scenes are not those whose results were stored, and none is compared; pulloff bless good --reason TEXT stores '
expect 1 '*' verify good --output run --identical --tap
says '^not ok 4 - good stored_results/pin$'
expect 0 '*' bless good --reason 'the other way round' --output run
says '^cases/pins/good.csv: 3 results, 3 new$'
expect 0 '*' verify good --output run --identical
says '^3 of 3 results are identical'
alter '/^# scenes:/d'
expect 1 '*' verify good --output run --identical
says '^good: its scenes are not those'
expect 0 '*' bless good --reason 'without scenes' --output run
check 'bless adds the scenes' grep -q '^# scenes: [0-9a-f]\{64\}$' "$digests"

# Several cases at once, or a suite.
sed 's/^name: good/name: other/' "$folder/good.yaml" >"$folder/other.yaml"
ends 0 bless good other --reason both --output run
says '^cases/pins/other.csv: 3 results, 3 new$'
expect 2 'pulloff: cases and --suite are given: expected one of them' bless good --suite smoke --reason both
ends 0 bless --suite smoke --reason both --output run
says '^cases/pins/good.csv: 3 results, 0 new; nothing is written$'
ends 0 verify --suite smoke --output run --identical
says '^6 of 6 results are identical'
finish
