#!/bin/sh
# Files written in addition to a result: if one cannot be written, the result is still printed. A symbolic link is
# kept, and so are permissions. An empty name is refused.
# shellcheck disable=SC1091,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"

force='^pull-off force 2 at approach'
for file in nowhere/curve.csv /dev/full .; do
  expect 4 "pulloff: $file cannot be written: *" solve --tabor 0 --curve "$file"
  check "the result is there when $file is not" grep -q "$force" stdout
  expect 4 "pulloff: $file cannot be written: *" solve --tabor 0 --profile "$file" --curve curve.csv
  check "and so is the other file" grep -q '^position,' curve.csv
  rm curve.csv
done
expect 4 'pulloff: nowhere/curve.csv cannot be written: *' solve --tabor 0 --curve nowhere/curve.csv --json
check 'the JSON document is printed' grep -q '"force": 2.0' stdout
"$program" verify good --junit nowhere/out.xml --tap >stdout 2>stderr
check 'a file of results that cannot be written is exit code 4' test $? = 4
check 'the message' grep -q '^pulloff: nowhere/out.xml cannot be written: ' stderr
check 'the verdicts are printed' grep -q '^ok 1 ' stdout

# The file - is standard output; the result is then on standard error.
for option in --curve --profile-csv --staircase; do
  "$program" solve --tabor 0 "$option" - >table.csv 2>result.txt
  check "$option -" test $? = 0
  "$program" solve --tabor 0 "$option" file.csv >/dev/null
  check "$option - is the table" cmp table.csv file.csv
  check "$option -: the result" grep -q "$force" result.txt
done
expect 2 'pulloff: standard output is asked for twice: *' solve --tabor 0 --curve - --json
expect 2 'pulloff: standard output is asked for twice: *' solve --tabor 0 --curve - --profile-csv -
check 'no file of this name' test ! -e -
"$program" solve --tabor 0 --curve - >/dev/full 2>result.txt
check 'standard output that cannot be written' test $? = 4

# Lengths in metres without --from-physical.
for lengths in '--radius 1e-7' '--amplitude 1e-9 --wavelength 2e-8'; do
  # shellcheck disable=SC2086 # words
  "$program" solve --tabor 0 --preload-load 1 $lengths >/dev/null 2>warning.txt
  check "a warning of $lengths" grep -q '^pulloff: warning: --.* epsilon, which looks like metres: for SI units, use --from-physical and --.*-m$' warning.txt
done
expect 0 '' solve --tabor 0 --radius 0.02
expect 0 '' solve --from-physical --modulus-pa inf --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 1e-7

for option in --curve --profile --profile-csv --staircase; do
  expect 2 "pulloff: $option is empty: expected the name of a file" solve --tabor 0 "$option" ''
done
expect 2 'pulloff: --junit is empty: expected the name of a file' verify good --junit ''
expect 2 'pulloff: --output is empty: expected the name of a folder' report --output ''
expect 2 'pulloff: --run is empty: expected the name of a folder' report --run ''

# Links to a file, to a link, to a file that does not exist, and to itself.
mkdir folder
echo old >folder/old.csv
chmod 600 folder/old.csv
ln -s folder/old.csv one
ln -s one two
ln -s new.csv folder/three
ln -s loop loop
expect 0 '' solve --tabor 0 --curve two
check 'the links stay' test -L one -a -L two
check 'the file has the curve' grep -q '^position,' folder/old.csv
check 'the file keeps its permissions' test "$(stat -c %a folder/old.csv)" = 600
expect 0 '' solve --tabor 0 --curve folder/three
check 'a link may lead to a file that does not exist' test -L folder/three -a -f folder/new.csv
expect 4 'pulloff: loop cannot be written: Too many levels of symbolic links' solve --tabor 0 --curve loop
check 'no temporary file is left' test "$(find . -name '*.part-*' | wc -l)" = 0
finish
