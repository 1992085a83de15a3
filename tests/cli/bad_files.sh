#!/bin/sh
# Full disks, folders that cannot be created, missing programs: the exit code is 4, the message is one line, no file is
# written in part, and no earlier file is lost.
# shellcheck disable=SC1091,SC2013,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"

expect_output_failure() {
  "$program" "$@" >/dev/full 2>"$work/stderr"
  got=$?
  check "exit code 4 of pulloff $* on a full device" test "$got" -eq 4
  check 'one line' test "$(wc -l <"$work/stderr")" -eq 1
  check 'the message states the reason' grep -q 'No space left on device' "$work/stderr"
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
expect 4 'pulloff: blocked/good/points.jsonl cannot be read: Not a directory' run --output blocked
check 'the file in place of the folder is unchanged' test -f blocked/good

# If the disk fills up, an existing record is kept.
trap 'umount "$work/small" 2>/dev/null; rm -rf "$work"' EXIT
if [ "$(id -u)" -eq 0 ] && mkdir small && mount -t tmpfs -o size=64k,mode=700 tmpfs small 2>mount.err; then
  expect 0 '*' run --output small/run
  cp small/run/good/record.json kept.json
  cat /dev/zero >small/filler 2>/dev/null
  expect 4 'pulloff: small/run/good/* cannot be written: No space left on device' \
    run --output small/run --fresh
  check 'the old record is complete' cmp kept.json small/run/good/record.json
  check 'no temporary file is left' test "$(find small/run/good -name '*.part-*' | wc -l)" -eq 0
  umount small
else
  echo 'skipped: a full disk (needs root, and the right to mount)'
fi

# A named pipe that no other program has opened was waited for, without end, and signals did not end it.
mkfifo pipe
lonely='is a pipe that no program has opened for writing in 5 s: expected a file, or a pipe with a writer, which is read once'
expect 4 "pulloff: pipe $lonely" solve --tabor 0 --profile-file pipe
expect 4 "pulloff: ./pipe $lonely" run ./pipe --output run
expect 4 'pulloff: pipe cannot be written: no program has opened it for reading' solve --tabor 0 --curve pipe
# A pipe with a writer is a file. A table that was read from the standard input is not read again: follow and uncertain
# inputs make several scenes of it.
{ echo r,gap; seq 0 20 | awk '{ print 3 * $1 "," 0.045 * $1 * $1 }'; } >table.csv
expect 0 '' solve --tabor 0 --profile-file table.csv
grep pull-off stdout >from_file
{ sleep 1; cat table.csv; } >pipe &
expect 0 '' solve --tabor 0 --profile-file pipe
check 'the pull-off of a table from a named pipe' grep -qxFf from_file stdout
for words in 'solve --coupling 0.1+-0.01' 'follow --key coupling --from 0.1 --to 0.2 --points 3'; do
  # shellcheck disable=SC2086
  expect 0 '' $words --profile-file table.csv
  grep digest stdout >from_file
  # shellcheck disable=SC2086
  cat table.csv | "$program" $words --profile-file /dev/stdin >stdout 2>stderr
  check "$words of a table from the standard input" grep -qxFf from_file stdout
done

# A damaged record is written again.
expect 0 '*good: 1 point, 1 check: within' run --output run
expect 0 '*good: 1 point, 1 check: within (kept)' run --output run
printf '{"schema": ' >run/good/record.json
first='good: the record or a table beside it was altered or damaged; the stored results are intact, and it is written again'
expect 0 '*good: 1 point, 1 check: within (kept)' run --output run
first=
check 'the record is complete again' grep -q '"verdict": "within"' run/good/record.json

# The report, if a script, the records or a program is missing.
mkdir -p "$PULLOFF_DATA/reports" bin
expect 4 'pulloff: */reports/make_report.py does not exist: expected *' report --run run
printf 'import sys\nprint(sys.argv[1:])\nsys.exit(3)\n' >"$PULLOFF_DATA/reports/make_report.py"
expect 4 'pulloff: elsewhere does not exist: expected the records of a run (see pulloff run --help)' report --run elsewhere
program_path=$work/bin
expect 4 'pulloff: gnuplot was not found: expected it in PATH, to draw the figures' report --run run
program_path=
PULLOFF_PYTHON=$work/bin/python expect 4 \
  'pulloff: */bin/python was not found: expected Python, which writes the report' report --run run
printf '#!/bin/sh\n' >bin/gnuplot
chmod +x bin/gnuplot
program_path=$work/bin:$PATH
expect 3 '' report --run run --output report
check 'the script gets the folders' grep -q "'--run', 'run', '--output', 'report'" "$work/stdout"
finish
