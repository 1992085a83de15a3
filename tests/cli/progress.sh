#!/bin/sh
# A solve and a series of more than a second show their progress on a terminal, and erase it; short ones show nothing.
# shellcheck disable=SC1091,SC2034,SC2154
. "$(dirname "$0")/lib.sh"

# on_terminal ARGUMENT...: runs the program on a terminal; lines of progress end in carriage returns.
on_terminal() {
  script -qec "\"$program\" $*" /dev/null </dev/null | tr '\r' '\n' >terminal.txt
}

if command -v script >/dev/null; then
  long='--tabor 8 --amplitude 8 --wavelength 16 --preload inf --tolerance 1e-9 --time-limit 2.5'
  on_terminal solve "$long"
  check 'a solve' grep -q -E '^[0-9]+ points, approach -?[0-9.e+-]+, load -?[0-9.e+-]+, [0-9]+ s elapsed' terminal.txt
  check 'the line is erased' grep -q -E '^ {20,}$' terminal.txt
  on_terminal follow --key tabor --from 1 --to 8 --points 600 --amplitude 1 --wavelength 20
  check 'a series' grep -q -E '^[0-9]+/600 scenes, [0-9]+ s elapsed' terminal.txt
  # shellcheck disable=SC2086 # words
  "$program" solve $long >out.txt 2>err.txt
  check 'nothing without a terminal' test "$(grep -c elapsed err.txt)" = 0
fi
finish
