#!/bin/sh
# Names of folders that are not ASCII: no check is lost from a document if a text would be cut inside a character, or if
# a name is not valid UTF-8, such as one written under Latin-1.
# shellcheck disable=SC1091,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"

# Prints the number of checks in a document, and tests that the document is valid UTF-8.
checks_of() { # FILE
  /usr/bin/python3 -c 'import json, sys; print(len(json.loads(open(sys.argv[1], "rb").read().decode())["checks"]))' "$1"
}

# Four checks, two of them against pins that do not exist. Their notes contain the name of the folder, cut to a length.
write_own() { # FILE
  sed 's/^name: good/name: own/' "$PULLOFF_DATA/cases/good.yaml" >"$1"
  cat >>"$1" <<'CASE'
  - {quantity: fold_count, reference: pin, tolerance: 1, kind: abs, because: to notice change}
  - {quantity: pull_off_force, reference: pin, tolerance: 1, kind: abs, because: to notice change}
  - {quantity: pull_off_approach, reference: reference/table.csv, tolerance: 1, kind: abs, because: it has a closed form}
CASE
}

try_folder() { # FOLDER WHAT
  mkdir "$1"
  write_own "$1/own.yaml"
  expect 1 'own: 1 points, 4 checks: outside' verify "$1/own.yaml" --output "$1/run"
  check "all checks are in the record: $2" test "$(checks_of "$1/run/own/record.json")" -eq 4
  expect 1 'own: 1 points, 4 checks: outside (kept)' \
    explain "$1/own.yaml" --all --json --output "$1/run"
  cp "$work/stdout" explained.json
  check "and all are explained: $2" test "$(checks_of explained.json)" -eq 4
  expect 1 'own: 1 points, 4 checks: outside (kept)' \
    verify "$1/own.yaml" --junit junit.xml --output "$1/run"
  check "the JUnit file is XML: $2" \
    /usr/bin/python3 -c 'import xml.dom.minidom; xml.dom.minidom.parse("junit.xml")'
}

# Characters of two, three and four bytes at every position relative to the cut.
for before in '' a ab abc; do
  for letter in ä € 😀; do
    name=$before
    while [ "$(printf %s "$name" | wc -c)" -lt 80 ]; do name=$name$letter; done
    try_folder "$name" "a long name of '$letter' after '$before'"
  done
done
try_folder "$(printf 'lat\344in')" 'a folder of Latin-1'
try_folder "$(printf 'lone\355\240\200')" 'a folder with half a surrogate'


# The program of a build folder finds the data of the source tree by a file beside it. It was a link, by which find -L,
# grep -R and backups of the source tree did not end.
check 'no link is beside the program' test -z "$(find "$(dirname "$program")" -type l)"
mkdir -p moved/bin
cp "$program" moved/bin/pulloff
cp -r "$PULLOFF_DATA" moved/source
echo ../source >moved/bin/data-folder.txt
check 'the data are found beside the program' \
  test "$(env -u PULLOFF_DATA moved/bin/pulloff list | tail -n +2 | cut -d ' ' -f 1)" = good
finish
