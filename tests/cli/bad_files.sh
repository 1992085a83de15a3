#!/bin/sh
# Disks that are full, folders that cannot be, tools that are absent: exit code 4, one line, nothing
# half-written, nothing lost.
# shellcheck disable=SC1091,SC2013,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"

expect_output_failure() {
  "$program" "$@" >/dev/full 2>"$work/stderr"
  got=$?
  check "exit code 4 of pulloff $* on a full device" test "$got" -eq 4
  check 'one line' test "$(wc -l <"$work/stderr")" -eq 1
  check 'that says why' grep -q 'No space left on device' "$work/stderr"
}
expect_output_failure solve --tabor 0
expect_output_failure solve --tabor 0 --json
expect_output_failure list
expect_output_failure --help

expect 4 'pulloff: /dev/full cannot be written: No space left on device' \
  solve --tabor 0 --curve /dev/full
expect 4 'pulloff: nowhere/curve.csv cannot be written: No such file or directory' \
  solve --tabor 0 --curve nowhere/curve.csv
: >file
expect 4 'pulloff: the folder file cannot be created: file: Not a directory' run --output file
expect 4 'pulloff: the folder file/run cannot be created: file*: Not a directory' run --output file/run
mkdir -p blocked
: >blocked/good
expect 4 'pulloff: the folder blocked/good cannot be created: *Not a directory' run --output blocked
check 'what was in the way is still there' test -f blocked/good

# A record that is there survives a disk that fills up.
trap 'umount "$work/small" 2>/dev/null; rm -rf "$work"' EXIT
if [ "$(id -u)" -eq 0 ] && mkdir small && mount -t tmpfs -o size=64k,mode=700 tmpfs small 2>mount.err; then
  expect 0 '*' run --output small/run
  cp small/run/good/record.json kept.json
  cat /dev/zero >small/filler 2>/dev/null
  expect 4 'pulloff: small/run/good/* cannot be written: No space left on device' \
    run --output small/run --fresh
  check 'the old record is whole' cmp kept.json small/run/good/record.json
  check 'nothing is left beside it' test "$(find small/run/good -name '*.part-*' | wc -l)" -eq 0
  umount small
else
  echo 'skipped: a full disk (needs root, and the right to mount)'
fi

# A damaged record is solved again.
expect 0 '*good: 1 points, 1 checks: within' run --output run
expect 0 '*good: 1 points, 1 checks: within (kept)' run --output run
printf '{"schema": ' >run/good/record.json
expect 0 '*good: 1 points, 1 checks: within' run --output run
check 'the record is whole again' grep -q '"verdict": "within"' run/good/record.json

# The report, without what it needs.
mkdir -p "$PULLOFF_DATA/reports" bin
expect 4 'pulloff: */reports/make_report.py cannot be read: it is not there' report --run run
printf 'import sys\nprint(sys.argv[1:])\nsys.exit(3)\n' >"$PULLOFF_DATA/reports/make_report.py"
expect 4 'pulloff: there is no run in elsewhere: expected one (pulloff run)' report --run elsewhere
program_path=$work/bin
expect 4 'pulloff: gnuplot is not there: expected it on PATH to draw figures' report --run run
program_path=
PULLOFF_PYTHON=$work/bin/python expect 4 \
  'pulloff: */bin/python is not there: expected Python to write the report' report --run run
printf '#!/bin/sh\n' >bin/gnuplot
chmod +x bin/gnuplot
program_path=$work/bin:$PATH
expect 3 '' report --run run --output report
check 'the script is told where' grep -q "'--run', 'run', '--output', 'report'" "$work/stdout"
finish
