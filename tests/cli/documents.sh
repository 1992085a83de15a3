#!/bin/sh
# What the documents print, a reader may type: every command runs, the output shown is that of today, and the example
# of a case is a case. documents.py says what is compared.
# shellcheck disable=SC1091,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
root=$here/../..
python=${PYTHON:-python3}

# The data of this tree: the example of a case names its tables.
PULLOFF_DATA=$root
export PULLOFF_DATA
awk '/^```yaml/ { inside = 1; next } /^```/ && inside { exit } inside' "$root/doc/cases.md" >"$work/example.yaml"
expect 0 '' plan "$work/example.yaml"
check 'the example has a point left out' grep -q -x '  leave out 1 scene: why not' "$work/stdout"
check 'the commands of the documents' "$python" "$here/documents.py" "$program" "$root"
finish
