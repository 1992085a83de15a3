#!/bin/sh
# What the documents print, a reader may type: commands run, the example of a case is one, and the output shown is that
# of today, but for work, times and digits beyond the tolerance.
# shellcheck disable=SC1091,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
root=$here/../..

# commands DOCUMENT: the indented ones that solve, follow or evaluate, one a line, from the verb on
commands() {
  sed -e ':join' -e '/\\$/{N;s/\\\n */ /;b join' -e '}' "$1" |
    sed -n -e 's/^ *\(build\/src\/cli\/\)\{0,1\}pulloff \(\(solve\|follow\|theory\) -*[a-z].*\)/\2/p'
}

# shown COMMAND: the block of output that follows the command in the README
shown() {
  sed -e ':join' -e '/\\$/{N;s/\\\n */ /;b join' -e '}' "$root/README.md" |
    awk -v command="    build/src/cli/pulloff $1" '
      inside && /^```/ { exit }
      inside
      found && !inside && NF { if (/^```$/) inside = 1; else exit }
      $0 == command { found = 1 }'
}

# alike A B: word for word; numbers to 1e-6, relatively, and small ones, such as errors, by their size. Tells the first
# that is not.
alike() {
  paste -d '\n' "$1" "$2" | awk '
    function size(x) { return x < 0 ? -x : x }
    function near(a, b) {
      return size(a - b) <= 1e-6 * size(b) ||
        (size(a) < 1e-5 && size(b) < 1e-5 && size(a) <= 100 * size(b) && size(b) <= 100 * size(a))
    }
    NR % 2 { words = split($0, first); next }
    /^work/ { next }
    {
      wrong = NF == words ? "" : $0
      for (i = 1; i <= NF && wrong == ""; ++i) {
        a = first[i]
        b = $i
        gsub(/,$/, "", a)
        gsub(/,$/, "", b)
        if (a != b && !(a + 0 != 0 && b + 0 != 0 && near(a + 0, b + 0))) wrong = b ": expected " a
      }
      if (wrong != "") { print wrong; exit 1 }
    }'
}

# The data of this tree: the example of a case names its tables.
PULLOFF_DATA=$root
export PULLOFF_DATA
awk '/^```yaml/ { inside = 1; next } /^```/ && inside { exit } inside' "$root/cases/README.md" >"$work/example.yaml"
expect 0 '' plan "$work/example.yaml"
check 'the example has a point left out' grep -q -x '  leave out 1 scene: why not' "$work/stdout"

for document in README.md src/cli/pulloff.1; do
  commands "$root/$document" | sed 's/\\-/-/g' | sort -u >"$work/commands"
  check "$document has commands" test -s "$work/commands"
  while IFS= read -r typed; do
    # shellcheck disable=SC2086 # words are meant
    expect 0 "" $typed
    shown "$typed" >"$work/shown"
    [ ! -s "$work/shown" ] || check "README shows what $typed prints" alike "$work/shown" "$work/stdout"
  done <"$work/commands"
done
check 'the README shows output' test -n "$(shown 'solve --tabor 1')"
finish
