#!/bin/sh
# Completion in bash and zsh offers the verbs, options and cases of the program.
# shellcheck disable=SC1091,SC2016,SC2154
. "$(dirname "$0")/lib.sh"

# offered WORD...: prints what bash offers for the last word, one per line, sorted.
offered() {
  alone bash -c '. "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _pulloff; printf "%s\n" "${COMPREPLY[@]}"' \
    "$work/prefix/share/bash-completion/completions/pulloff" "$@" | sort
}

# offers WHAT EXPECTED WORD...: tests that exactly these words, in sorted order, are offered.
offers() {
  what=$1
  expected=$2
  shift 2
  check "$what" test "$(offered "$@" | xargs)" = "$expected"
}

verbs=$(alone pulloff --help | sed -n 's/^  \([a-z][a-z-]*\)  *[a-z].*/\1/p' | sort | xargs)
check 'there are verbs' test "$(echo "$verbs" | wc -w)" -ge 11
offers 'verbs' "--help --version $verbs" pulloff ''
offers 'a verb' solve pulloff so
offers 'options' '--preload --preload-load --preload-load-n --preload-m' pulloff solve --prel
offers 'the second option of a line' --mie-n pulloff solve --mie-n
offers 'lengths in metres' '--radius --radius-m' pulloff solve --from-physical --rad
offers 'the values of an option' 'panel ring triangle' pulloff solve --scheme ''
offers 'values with parameters' 'lennard-jones mie: morse:' pulloff solve --law ''
offers 'values of a list' 'curve diagnostics history hysteresis loop preload profile theories' pulloff solve --want ''
offers 'a value that is no number' inf pulloff solve --outer-radius ''
offers 'keys' 'mie-m mie-n modulus-pa morse-a' pulloff follow --key m
offers 'values of a closed form' 'lennard-jones mie: morse:' pulloff theory jkr --law ''
offers 'values of an option of a series' 'lennard-jones mie: morse:' pulloff follow --law ''
offers 'suites' 'extreme' pulloff bless --suite ex
offers 'a value in SI units' inf pulloff solve --modulus-pa ''
offers 'cases after an option without a value' 'fig14 fig14_any' pulloff run --fresh fig14
offers 'cases' smoke pulloff plan smo
offers 'closed forms' 'kesari-lew' pulloff theory ke
mkdir a-folder
touch a-file
offers 'files' 'a-file a-folder' pulloff solve --curve a-
offers 'folders' a-folder pulloff report --output a-

# Every option that the help of a verb mentions at the beginning of a line is offered.
for verb in $verbs; do
  expected=$(alone pulloff "$verb" --help | grep -o -E '^  (-h, )?--[a-z0-9-]+' | grep -o -e '--.*' | sort)
  check "$verb has options" test -n "$expected"
  offered pulloff "$verb" -- >offered.txt
  for option in $expected; do check "$verb $option" grep -q -x -e "$option" offered.txt; done
done

if command -v zsh >/dev/null; then
  for line in 'pulloff so:lve' 'pulloff solve --toler:ance' 'pulloff plan smok:e' 'pulloff theory kes:ari-lew' 'pulloff solve --mie-n:'; do
    check "zsh: $line" alone COMPLETIONS="$work/prefix/share/zsh/site-functions" zsh -f "$here/complete.zsh" "${line%:*}" "${line#*:}"
  done
fi
finish
