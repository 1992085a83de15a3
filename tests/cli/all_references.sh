#!/bin/sh
# Tests every reference table of the source tree, even one that no case uses. If it is deleted, truncated, or one digit
# is altered, the program detects it and names the table.
# shellcheck disable=SC1091,SC2013,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
source=$here/../..
export PULLOFF_DATA="$work/data"
mkdir -p "$PULLOFF_DATA/cases"
cp "$source"/cases/smoke.yaml "$PULLOFF_DATA/cases" # the list reads every case, and takes most of its time for that
cp -r "$source/reference" "$PULLOFF_DATA"
rm -rf "$PULLOFF_DATA/reference/make"
folder=$PULLOFF_DATA/reference

expect 0 '' list --references
check 'every table of the source is in the index' test 0 -eq "$(grep -c 'not in the index' "$work/stdout")"
tables=$(cd "$source/reference" && ls -- *.csv)
count=$(echo "$tables" | wc -l)
check 'there are tables' test "$count" -ge 12

# damaged MESSAGE COMMAND...: does the same damage to every table, whose name is the last argument of the command; tests that the
# list says it of each, and restores them.
damaged() {
  says=$1
  shift
  for name in $tables; do "$@" "$folder/$name"; done
  expect 4 'pulloff: *' list --references
  check "each table: $says" test "$count" -eq "$(grep -c "^reference/[a-z0-9_]*\.csv .*damaged: .*$says" "$work/stdout")"
  (cd "$source/reference" && cp -- *.csv "$folder")
}
header() { grep -n -m 1 -v '^#' "$1" | cut -d: -f1; } # FILE: the line of the names of its columns
shorten() { sed -i '$s/,[^,]*$//' "$1"; }
narrow() { sed -i "$(header "$1"),\$s/,[^,]*\$//" "$1"; }
alter() { # one digit, in the last number of a row in the middle
  middle=$((($(header "$1") + $(wc -l <"$1")) / 2 + 1))
  digit=$(sed -n "${middle}s/.*\([0-9]\)[^0-9]*\$/\1/p" "$1")
  sed -i "${middle}s/$digit\([^0-9]*\)\$/$(((digit + 1) % 10))\1/" "$1"
}
damaged 'No such file or directory' rm
damaged 'sha256 is .*: expected ' sed -i '$d'
damaged 'the row has .* cell.*: expected ' shorten
damaged 'sha256 is ' narrow
damaged 'the last line has no newline: the file is truncated' truncate -s -2
damaged 'sha256 is ' alter
damaged 'sha256 is ' sed -i '/^# uncertainty/ s/: /: 0/'
damaged 'sha256 is ' sed -i 's/^# kind: oracle/# kind: published/'

# Without a case, verify checks all tables before it solves anything. With a case, it checks the tables of the case.
sed -i '$d' "$folder/struve.csv"
expect 4 'pulloff: reference/struve.csv:*: sha256 is *' verify --suite smoke --output out
check 'nothing is solved' test ! -e out
"$program" verify smoke --output out >"$work/stdout" 2>"$work/stderr"
check 'a case that does not use it is run' test -s out/smoke/record.json
rm "$folder/kernel.csv"
expect 4 'pulloff: *reference/kernel.csv cannot be opened: * (and 1 more: *' verify --suite smoke --output out2
cp "$source/reference/struve.csv" "$source/reference/kernel.csv" "$folder"
rm "$folder/index.txt"
expect 4 'pulloff: *reference/index.txt cannot be opened: *' list --references
cp "$source/reference/index.txt" "$folder"
cp "$folder/struve.csv" "$folder/mine.csv"
expect 0 '' list --references
check 'a table that is not in the index is shown' grep -q '^reference/mine.csv .*not in the index' "$work/stdout"
finish
