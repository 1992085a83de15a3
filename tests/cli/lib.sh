# Functions for the tests of the command line. Sourced with the program as $1. The tests run in the folder $work, which
# is removed at the end.
# shellcheck shell=sh disable=SC2034
here=$(cd "$(dirname "$0")" && pwd)
program=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 99
passed=0
failed=0
first=

tell() { # ok|not-ok, what was tried, what went wrong
  if [ "$1" = ok ]; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    printf 'FAILED: %s\n  %s\n' "$2" "$3"
    [ -s "$work/stderr" ] && sed 's/^/  stderr: /' "$work/stderr"
  fi
}

# expect CODE MESSAGE ARGUMENT...: tests that the program ends with the exit code CODE and that standard error is the one
# line MESSAGE (a shell pattern; '': nothing). Lines of progress, which a slow machine prints, are ignored. If
# $program_path is set, the program gets it as PATH.
expect() {
  code=$1
  message=$2
  shift 2
  PATH=${program_path:-$PATH} "$program" "$@" >"$work/stdout" 2>"$work/stderr"
  got=$?
  sed -i '/^[0-9]*\/[0-9]* [a-z]*, .* elapsed/d' "$work/stderr"
  if [ -n "$first" ]; then
    check "the first line is: $first" test "$(head -n 1 "$work/stderr")" = "$first"
    sed -i 1d "$work/stderr"
  fi
  line=$(cat "$work/stderr")
  lines=$(wc -l <"$work/stderr")
  if [ "$got" -ne "$code" ]; then
    tell not-ok "pulloff $*" "exit code $got: expected $code"
  elif [ -n "$message" ] && [ "$lines" -ne 1 ]; then
    tell not-ok "pulloff $*" "$lines lines on standard error: expected 1"
  else
    # shellcheck disable=SC2254 # a pattern is meant
    case $line in
    $message) tell ok ;;
    *) tell not-ok "pulloff $*" "expected: $message" ;;
    esac
  fi
}

# mends CASE NUMBER CODE MESSAGE ARGUMENT...: as expect; a line before MESSAGE says that so many results of the case were
# altered.
mends() {
  [ "$2" = 1 ] && were='was altered or damaged and is' || were='were altered or damaged and are'
  first="$1: $2 stored result$([ "$2" = 1 ] || echo s) $were solved again"
  shift 2
  expect "$@"
  first=
}

# check WHAT COMMAND...: tests that the command succeeds.
check() {
  what=$1
  shift
  if "$@"; then tell ok; else tell not-ok "$what" "$*"; fi
}

# fails COMMAND...: succeeds if the command fails.
fails() { ! "$@"; }

# hears: succeeds if the program $child catches SIGINT.
hears() { [ $((0x$(sed -n 's/^SigCgt:[[:space:]]*//p' "/proc/$child/status") & 2)) -ne 0 ]; }

# wait_for COMMAND...: repeats the command until it succeeds, for at most about 20 s.
wait_for() {
  tries=0
  until "$@" || [ $tries -gt 400 ]; do
    sleep 0.05
    tries=$((tries + 1))
  done
}

finish() {
  printf '%s passed, %s failed\n' "$passed" "$failed"
  [ "$failed" -eq 0 ]
}
