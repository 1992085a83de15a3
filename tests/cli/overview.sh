#!/bin/sh
# What verify prints: a line a case, what does not pass with the command that explains it, the totals; every check with
# --verbose; on a terminal no line for each case before that.
# shellcheck disable=SC1091,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
python=${PYTHON:-python3}
line() { check "line $1: $2" test "$(sed -n "$1p" "$work/stdout")" = "$2"; }
lines() { check "$1 lines" test "$(wc -l <"$work/stdout")" -eq "$1"; }

# The rigid sphere to the last bits: the tolerance says nothing, which passes and is shown.
expect 0 'good: 1 point, 1 check: within' verify
lines 3
check 'slack is shown' grep -qE '^good +1 +0 +0 +[0-9.]+ +0\.000  pull_off_force, scene; 1 slack$' "$work/stdout"
line 3 '1 check passes (1 slack), 0 do not, 0 solves failed'

write_table "$PULLOFF_DATA/reference/table.csv" tabor,force,approach 0,2.0000000005,0
expect 0 'good: 1 point, 1 check: within*' verify
lines 3
check 'the columns' grep -qE '^case +pass +fail +unsolved +seconds +\|err\|/tol +of the worst check$' "$work/stdout"
check 'the case' grep -qE '^good +1 +0 +0 +[0-9.]+ +0\.500  pull_off_force, scene$' "$work/stdout"
line 3 '1 check passes, 0 do not, 0 solves failed'
expect 0 '*' verify --verbose
check 'a line a check' grep -qE '^good +pull_off_force +scene .* within$' "$work/stdout"

# A failure: what, where, how far off, and a command that explains it, also with another folder for the records.
write_table "$PULLOFF_DATA/reference/table.csv" tabor,force,approach 0,2.000000003,0
expect 1 '*' verify --output "a folder"
lines 5
check 'the case fails' grep -qE '^good +0 +1 +0 +[0-9.]+ +3\.000  pull_off_force, scene$' "$work/stdout"
line 3 'good pull_off_force, scene: outside, 3 times the tolerance (reference/table.csv)'
line 4 "    pulloff explain good --point 0 --output 'a folder'"
line 5 '0 checks pass, 1 does not (1 outside), 0 solves failed'
eval "\"$program\" $(sed -n '4s/ *pulloff//p' "$work/stdout")" >explained 2>"$work/stderr"
check 'the command explains it' grep -q -x 'good pull_off_force scene: outside' explained

# Of several results of a check the worst is shown. One without a number is worse than any other.
cat >>"$PULLOFF_DATA/cases/good.yaml" <<'CASE'
sweep: [{key: radius, values: [100, 200, 300]}]
CASE
sed -i '/^  radius: 100/d' "$PULLOFF_DATA/cases/good.yaml"
write_table "$PULLOFF_DATA/reference/table.csv" radius,force,approach 100,2.000000003,0 200,2.000000005,0 300,2,0
expect 1 '*' verify
lines 5
line 3 'good pull_off_force, radius=200: outside, 5 times the tolerance (reference/table.csv); 2 results of this check do not pass, this is the worst'
line 4 '    pulloff explain good --point 1'
write_table "$PULLOFF_DATA/reference/table.csv" radius,force,approach 100,2.000000003,0 200,2.000000005,0
expect 1 '*' verify
line 3 'good pull_off_force, radius=300: missing_reference (reference/table.csv): the reference does not contain this scene; nearest is line 13: radius 200 instead of 300; 3 results of this check do not pass, this is the worst'

# Solves that failed: the first, and its command.
restore
sed -i 's/scheme: .*/scheme: panel/; s/nodes: 101/tolerance: 1e-6/; s/^  tabor: 0/  tabor: 1/' "$PULLOFF_DATA/cases/good.yaml"
printf 'sweep: [{key: time_limit, values: [1e-9, 2e-9, 3600]}]\n' >>"$PULLOFF_DATA/cases/good.yaml"
write_table "$PULLOFF_DATA/reference/table.csv" tabor,force,approach 1,1.670664777,0
sed -i 's/tolerance: 1e-9/tolerance: 1e-4/' "$PULLOFF_DATA/cases/good.yaml"
expect 3 '*' verify
check 'one check passes, two have no result, two solves failed' grep -qE '^good +1 +2 +2 ' "$work/stdout"
check 'the first' grep -q '^good solve, time_limit=1e-9: failed: after 1e-09 s .*; 2 solves failed, this is the first$' "$work/stdout"
check 'its command' test 2 -eq "$(grep -c -x '    pulloff explain good --point 0' "$work/stdout")"

# On a terminal the overview is all that stays; with --verbose the line of each case stays, too.
restore
cat >terminal.py <<'TERMINAL'
import os, pty, sys
received = []
def read(fd):
    data = os.read(fd, 4096)
    received.append(data)
    return data
code = os.waitstatus_to_exitcode(pty.spawn(sys.argv[1:], read))
text = b"".join(received).decode().replace("\r\n", "\n")
shown = [line.rsplit("\r", 1)[-1] for line in text.split("\n")]
print(sum("good: 1 point" in line for line in shown), "0/1 solve" in text, code, file=open("seen", "w"))
TERMINAL
"$python" terminal.py "$program" verify --fresh >/dev/null </dev/null
check 'progress, and nothing left of it' test "$(cat seen)" = '0 True 0'
"$python" terminal.py "$program" verify --fresh --verbose >/dev/null </dev/null
check 'progress, and the line of the case' test "$(cat seen)" = '1 True 0'

# The overview of the whole paper fits a screen of 40 lines: a line of ./reproduce before it, a head, the cases, the
# totals, and a line of ./reproduce after it. The list has a head, too.
PULLOFF_DATA=$here/../.. "$program" list --suite paper,precision,extreme >cases
check 'a screen for the paper' test "$(wc -l <cases)" -le 37
finish
