#!/bin/sh
# The documents of the library are those of the program, byte for byte but for the times.
# Usage: same.sh PROGRAM SOLVE_JSON SCENES_H
program=$1
library=$2
scenes=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0
failed=0

# options KEY VALUE...: prints them as options of the program
options() {
  while [ $# -gt 0 ]; do
    printf -- ' --%s %s' "$(printf %s "$1" | tr _ -)" "$2"
    shift 2
  done
}

# same VERB NAME WORDS: compares the documents; both commands have to end with the same kind of status.
same() {
  # Words are meant to split.
  # shellcheck disable=SC2086,SC2046
  "$program" $1 $(options $2) --json >"$work/program.json" 2>"$work/program.txt"
  code=$?
  # shellcheck disable=SC2086
  "$library" ${1#solve} $2 >"$work/library.json" 2>"$work/library.txt"
  [ $? -eq $((code > 0)) ] || code=differs
  sed '/"seconds"/d' "$work/program.json" >"$work/one"
  sed '/"seconds"/d' "$work/library.json" >"$work/two"
  if [ "$code" != differs ] && cmp -s "$work/one" "$work/two" && [ -s "$work/one" ]; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    printf 'FAILED: %s %s\n' "$1" "$2"
    diff "$work/one" "$work/two" | head -n 10
    cat "$work/program.txt" "$work/library.txt"
  fi
}

sed -n 's/^ *"\([a-z]* [0-9].*\)",$/\1/p' "$scenes" >"$work/scenes"
while read -r words; do
  case $words in
  # amplitude_ratio and law parameters in one word are no options of solve
  *amplitude_ratio*) continue ;;
  esac
  same solve "$words"
done <"$work/scenes"
same 'theory jkr' 'tabor 2.5 radius 77'
same 'theory guduru' 'tabor 5 amplitude 10 wavelength 20'
same 'theory compactness' 'amplitude 0 wavelength 20'
printf '%s passed, %s failed\n' "$passed" "$failed"
[ "$failed" -eq 0 ] && [ "$passed" -ge 14 ]
