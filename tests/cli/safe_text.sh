#!/bin/sh
# Text from outside: no control character in a case, a table, an argument or the name of a file reaches the terminal or
# ends a text early. Characters beyond ASCII stay readable.
# shellcheck disable=SC1091,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
python=${PYTHON:-python3}
escape=$(printf '\033[31m')

# Tests that neither output stream has a control character.
clean() {
  cat stdout stderr >both
  check "what '$1' prints is clean" "$python" -c '
import sys
text = open("both", encoding="utf-8").read()
assert all(c == "\n" or ord(c) >= 32 and not 127 <= ord(c) < 160 for c in text), repr(text)'
}

case=$PULLOFF_DATA/cases/good.yaml
cp "$case" whole.yaml
spoilt() { # SED-SCRIPT BYTE
  sed "$1" whole.yaml >"$case"
  for verb in list 'plan good' 'run good'; do
    # shellcheck disable=SC2086 # two words are meant
    expect 2 "pulloff: cases/good.yaml:*: a text contains the control character $2: expected none" $verb
    clean "$verb"
  done
}
spoilt 's/^name: .*/name: "go\\0od"/' '\\x00'
spoilt 's/^title: .*/title: "\\e[31mred"/' '\\x1b'
spoilt 's/^title: .*/title: "a title\\e]0;of the window\\a"/' '\\x1b'
spoilt 's/^title: .*/title: "\\x9b31mred"/' '\\xc2'
spoilt 's/^title: .*/"tit\\0le": text/' '\\x00'
cp whole.yaml "$case"
sed -i 's/^title: .*/title: "Kugel, glatt — größer, 球"/' "$case"
expect 0 '' plan good
check 'characters beyond ASCII are kept' grep -q 'größer, 球' stdout
cp whole.yaml "$case"

expect 2 'pulloff: --tabor is \\x1b[[]31m1: expected *' solve --tabor "${escape}1"
clean solve
expect 2 'pulloff: --tabor is größer: expected *' solve --tabor größer
expect 2 'pulloff: --tabor is gr\\xf6\\xdfer: expected *' solve --tabor "$(printf 'gr\366\337er')"
expect 2 'pulloff: --tabor is empty: expected *' solve --tabor ''
# A long value is cut at a character, not inside one.
long=$(printf 'x%.0s' $(seq 79))
expect 2 "pulloff: --tabor is $long...: expected *" solve --tabor "${long}öö"
expect 2 'pulloff: unknown verb \\x1b[[]31m: expected *' "$escape"
expect 2 'pulloff: no closed form is named \\x1b[[]31m: expected *' theory "$escape"
expect 2 'pulloff: unexpected argument \\x1b[[]31m of solve *' solve "$escape"
expect 2 'pulloff: unknown option --\\x1b[[]31m *' solve "--$escape"
expect 4 'pulloff: nowhere/\\x1b[[]31m cannot be written: *' solve --tabor 0 --curve "nowhere/$escape"
expect 4 'pulloff: *\\x1b[[]31m.yaml*' plan "./$escape.yaml"
clean plan

# A table must be text, but its name may contain any character.
printf '# what: \033[31mred\n' >"$PULLOFF_DATA/reference/red.csv"
cp "$PULLOFF_DATA/reference/red.csv" "$PULLOFF_DATA/reference/$escape.csv"
expect 4 '*' list --references
check 'a table must be text' grep -q 'red.csv:1: the byte \\x1b is a control character or not UTF-8: expected text' stdout
clean 'list --references'
finish
