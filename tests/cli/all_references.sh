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

# noticed NAME MESSAGE: tests that the list and standard error name the damaged table, and restores it.
noticed() {
  expect 4 "pulloff: $2" list --references
  check "the list says that $1 is damaged" grep -q "^reference/$1 .*damaged: " "$work/stdout"
  check 'no other table is damaged' test 1 -eq "$(grep -c damaged "$work/stdout")"
  cp "$source/reference/$1" "$folder/$1"
}

# Changes every digit of the lines of a sed address.
alter() { # ADDRESS FILE
  sed -i "$1 { y/0123456789/1234567890/; }" "$2"
}

expect 0 '' list --references
check 'every table of the source is in the index' test 0 -eq "$(grep -c 'not in the index' "$work/stdout")"
tables=$(cd "$source/reference" && ls -- *.csv)
check 'there are tables' test "$(echo "$tables" | wc -l)" -ge 12
for name in $tables; do
  file=$folder/$name
  columns=$(grep -n -m 1 -v '^#' "$file" | cut -d: -f1)
  rm "$file"
  noticed "$name" "*reference/$name cannot be opened: No such file or directory"
  sed -i '$d' "$file"
  noticed "$name" "reference/$name:*: sha256 is *: expected *, the digest of all other lines*"
  sed -i '$s/,[^,]*$//' "$file"
  noticed "$name" "reference/$name:*: the row has * cell*: expected *"
  sed -i "$columns,\$s/,[^,]*\$//" "$file"
  noticed "$name" "reference/$name:*: sha256 is *"
  truncate -s -2 "$file"
  noticed "$name" "reference/$name:*: the last line has no newline: the file is truncated"
  # one digit is altered, in the last number of a row in the middle and in the uncertainty in the header
  middle=$(((columns + $(wc -l <"$file")) / 2 + 1))
  digit=$(sed -n "${middle}s/.*\([0-9]\)[^0-9]*\$/\1/p" "$file")
  sed -i "${middle}s/$digit\([^0-9]*\)\$/$(((digit + 1) % 10))\1/" "$file"
  check "a digit of $name differs" test 2 -eq "$(diff "$file" "$source/reference/$name" | grep -c '^[<>]')"
  noticed "$name" "reference/$name:*: sha256 is *"
  alter '/^# uncertainty/' "$file"
  noticed "$name" "reference/$name:*: sha256 is *"
  sed -i 's/^# kind: oracle/# kind: pin/' "$file"
  noticed "$name" "reference/$name:*: sha256 is *"
done

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
