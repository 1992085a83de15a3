# Creates a data folder with one correct case that is solved quickly and one correct reference table, to be damaged.
# shellcheck shell=sh disable=SC2154
export PULLOFF_DATA="$work/data"
mkdir -p "$PULLOFF_DATA/cases" "$PULLOFF_DATA/reference"

write_case() { # FILE
  cat >"$1" <<'CASE'
name: good
title: A rigid sphere
suites: [smoke]
scene:
  tabor: 0
  amplitude: 0
  radius: 100
  outer_radius: inf
  scheme: triangle
  nodes: 101
want: [pull_off]
checks:
  - quantity: pull_off_force
    reference: reference/table.csv
    tolerance: 1e-9
    kind: abs
    because: it has a closed form
CASE
}

# Writes a table with these rows and a header with the correct checksum.
write_table() { # FILE COLUMNS ROW...
  into=$1
  shift
  printf '%s\n' "$@" >"$work/rows"
  cat >"$into" <<TABLE
# what: pull-off of the rigid sphere
# source: by hand
# kind: oracle
# method: closed form
# units: those of the harness
# uncertainty: 0
# generator: none
# command: none
# date: 2026-11-21
TABLE
  cat "$work/rows" >>"$into"
  seal "$into"
}

# Writes the correct checksum into a table, above the line of column names.
seal() { # FILE
  sed -i '/^# sha256:/d' "$1"
  line=$(grep -n -m 1 -v '^#' "$1" | cut -d: -f1)
  sed -i "${line}i # sha256: $(sha256sum <"$1" | cut -d' ' -f1)" "$1"
}

restore() {
  rm -rf "$PULLOFF_DATA/cases" "$PULLOFF_DATA/reference"
  mkdir -p "$PULLOFF_DATA/cases" "$PULLOFF_DATA/reference"
  write_case "$PULLOFF_DATA/cases/good.yaml"
  write_table "$PULLOFF_DATA/reference/table.csv" tabor,force,approach 0,2,0
  echo table.csv >"$PULLOFF_DATA/reference/index.txt"
}
restore
