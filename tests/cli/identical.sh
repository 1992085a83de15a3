#!/bin/sh
# Results are compared with their stored digests to the last bit. A difference within rounding is counted, a greater one
# fails; with --identical every difference fails, also of a pin.
# shellcheck disable=SC1091,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null USER=tester
folder=$PULLOFF_DATA/cases
digests=$folder/pins/good.digests.csv
sed -i 's/^  tabor: 0$/&.5/; s/^  scheme.*/  scheme: panel\n  tolerance: 1e-5/; /^  nodes/d; /^  radius/d
  s/^want/sweep: [{key: radius, values: [90, 100, 110]}]\nwant/; s/reference: .*/reference: pin/; /tolerance: 1e-9/d; /kind:/d; /because/d' \
  "$folder/good.yaml"
cat >>"$folder/good.yaml" <<'CHECK'
  - {quantity: work, reference: pin}
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

# Without stored digests there is nothing to compare.
expect 1 '*' verify good --output run
silent identical
expect 1 '*' verify good --output run --identical
says '^good: pull_off_force/pin/radius=90 has no pin$'
expect 0 '*' bless good --reason first --output run
says '^cases/pins/good.digests.csv: 3 digests, 3 new$'
check 'one row a point' test 3 -eq "$(grep -c -E '^[0-2],[0-9a-f]{16},1\.[0-9]{14}' "$digests")"
expect 0 '*' verify good --output run
says '^3 of 3 results are identical to the last bit with the stored ones$'
expect 0 '*' verify good --output run --identical
expect 0 '*' verify good --output run --points 1-2
says '^2 of 2 results are identical'
expect 0 '*' verify good --output run --tap
says '^# 3 of 3 results are identical'
cp "$digests" first.csv
expect 0 '*' bless good --reason again --output run
check 'nothing is written' cmp "$digests" first.csv

# Another last bit: of another quantity than the force, and of the force.
alter 's/^1,./1,x/'
expect 0 '*' verify good --output run
says '^2 of 3 results are identical to the last bit with the stored ones, 1 differ: their pull-off forces by at most 0$'
force=$(sed -n 's/^1,.*,//p' "$digests")
alter "s/^1,.*/1,0123456789abcdef,${force%??????}999999/"
expect 0 '*' verify good --output run
says '^2 of 3 results .* 1 differ: their pull-off forces by at most [0-9.]*e-1[0-9]$'
silent 'not the stored ones'
expect 1 '*' verify good --output run --identical
says '^good: 1 of 3 results are not the stored ones; the pull-off force of radius=100 differs most, by .*: zero can judge it$'
expect 1 '*' verify good --output run --identical --tap
says '^# good: 1 of 3 results'

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
alter "s/^1,.*/1,0123456789abcdef,${force%????????????}999999999999/"
expect 1 '*' verify good --output run
says '1 by more than rounding$'
alter "s/^1,.*/1,0123456789abcdef,-/"
expect 1 '*' verify good --output run
says '1 differ: their pull-off forces by at most inf, 1 by more than rounding$'
alter '/^1,/d'
expect 0 '*' verify good --output run
says '^2 of 2 results are identical'
expect 0 '*' bless good --reason again --output run
says '^cases/pins/good.digests.csv: 3 digests, 1 new$'

# The table is damaged.
sed -i 's/^1,./1,x/' "$digests"
expect 4 'pulloff: cases/pins/good.digests.csv:*: sha256 is *' verify good --output run
alter 's/^point,/colour,/'
expect 4 'pulloff: cases/pins/good.digests.csv:*: expected the columns point, digest, pull_off_force' verify good --output run
cp first.csv "$digests"

# A pin whose last bits moved passes, but not with --identical; nor does a counter.
pins=$folder/pins/good.csv
cp "$pins" first_pins.csv
alter "s/^\(.*,pull_off_force,1.*\)../\111/" "$pins"
expect 0 '*' verify good --output run --verbose
says 'pull_off_force .* pin *within'
says 'work_points .* pin *identical'
expect 1 '*' verify good --output run --identical
says '^good: pull_off_force/pin/radius=90 is not its pin: 1\.[0-9]* for 1\.[0-9]*$'
cp first_pins.csv "$pins"
points=$(sed -n 's/^100,work.points,//p' "$pins")
alter "s/^100,work.points,.*/100,work\/points,$((points + 1))/" "$pins"
expect 0 '*' verify good --output run
expect 1 '*' verify good --output run --identical
says "^good: work/pin/radius=100/points is not its pin: $points for $((points + 1))$"

# Digests of other scenes are not compared: those of the same numbers were, and each result differed.
cp first_pins.csv "$pins"
expect 0 '*' verify good --output run --identical --time-limit 500
says '^3 of 3 results are identical'
sed -i 's/\[90, 100, 110\]/[110, 100, 90]/' "$folder/good.yaml"
expect 0 '*' verify good --output run
silent 'results are\|scenes'
expect 1 '*' verify good --output run --identical
says '^good: its scenes are not those whose results were stored, and none is compared; pulloff bless good --reason TEXT stores '
expect 0 '*' bless good --reason 'the other way round' --output run
says '^cases/pins/good.digests.csv: 3 digests, 3 new$'
check 'every blessing is kept' test 2 -eq "$(grep -c '^# blessing' "$digests")"
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
says '^cases/pins/other.digests.csv: 3 digests, 3 new$'
expect 2 'pulloff: cases and --suite are given: expected one of them' bless good --suite smoke --reason both
ends 0 bless --suite smoke --reason both --output run
says '^cases/pins/good.digests.csv: 3 digests, 0 new$'
ends 0 verify --suite smoke --output run --identical
says '^6 of 6 results are identical'
finish
