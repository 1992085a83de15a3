#!/bin/sh
# ./reproduce in a folder with substitute programs: which options it refuses, which parts it runs, and how it reports its
# steps.
# shellcheck disable=SC1091,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
root=$here/../..
tree=$work/tree
mkdir -p "$tree/build/src/cli" "$tree/build/tests/cost" "$tree/tests/mutation" "$tree/reports/figures" "$tree/reports/claims" "$tree/cases" "$work/bin"
cp "$root/reproduce" "$tree"
cp -r "$root/tools" "$tree"
for figure in 03 05 06; do : >"$tree/reports/figures/fig$figure.gp"; done
make_case() { printf 'name: %s\nfigure: "%s"\nsuites: [%s] # which\n' "$1" "$2" "$3" >"$tree/cases/$1.yaml"; }
make_case fig03 3 'smoke, paper'
make_case fig06 6 paper
make_case fig06_paper 6 paper
make_case timing '' precision
mv "$tree/cases/timing.yaml" "$tree/cases/precise.yaml"

# The substitute programs write their arguments to a file. The first case fails if a certain file exists.
cat >"$tree/build/src/cli/pulloff" <<'PROGRAM'
#!/bin/sh
echo "$*" >>asked
case $1 in run | verify) ;; *) exit 0 ;; esac
echo 'a verdict'
echo '3/8 solves, 5 s elapsed, about 2 min 10 s remaining (fig03 tabor=1)' >&2
sleep "$(cat slow 2>/dev/null || echo 0)"
exit "$(cat code 2>/dev/null || echo 0)"
PROGRAM
printf '#!/bin/sh\necho "cost $*" >>asked\n' >"$tree/build/tests/cost/measure_cost"
chmod +x "$tree/build/src/cli/pulloff" "$tree/build/tests/cost/measure_cost"
printf '#!/bin/sh\n' >"$work/bin/meson"
chmod +x "$work/bin/meson"
PATH=$work/bin:$PATH
cat >"$tree/tests/mutation/run.py" <<'PROGRAM'
import sys
print("faults", *sys.argv[1:], file=open("asked", "a"))
PROGRAM
cat >"$tree/reports/claims/run.py" <<'PROGRAM'
import os, sys
print("claims", *sys.argv[1:], file=open("asked", "a"))
print("made-claim 1.57 reproduced")
sys.exit(int(open("judged").read()) if os.path.exists("judged") else 0)
PROGRAM
printf 'import sys\nprint("sheet", *sys.argv[1:], file=open("asked", "a"))\n' >"$tree/reports/make_sheet.py"
mkdir -p "$tree/reports/papers/wavy_sphere"
cat >"$tree/reports/papers/wavy_sphere/claims.toml" <<'LIST'
get.a = { case = "timing", when = { tabor = 1 }, at = "pull_off.force" }
get.b = { case = "fig03", at = "folds.#" }
get.c = { case = "timing", at = "folds.#" }
LIST
: >"$tree/build/build.ninja"
mkdir -p "$tree/build/meson-private"
: >"$tree/build/meson-private/coredata.dat"
(cd "$tree" && pwd -P) >"$tree/build/source-tree"

reproduce() { # CODE ARGUMENT...
  code=$1
  shift
  rm -f "$tree/asked"
  "$tree/reproduce" "$@" >"$work/stdout" 2>"$work/stderr"
  check "exit code $code of ./reproduce $*" test $? -eq "$code"
}
refused() { # MESSAGE ARGUMENT...
  message=$1
  shift
  reproduce 2 "$@"
  check "one line: $message" test "$(cat "$work/stderr")" = "reproduce: $message (see ./reproduce --help)"
  check 'no step was started' test ! -e "$tree/asked"
}
asked() { check "asked: $1" grep -q -x -e "$1" "$tree/asked"; }
not_asked() { check "not asked: $1" test "$(grep -c -e "$1" "$tree/asked")" -eq 0; }

refused 'unknown option --frobnicate' --frobnicate
refused '--jobs needs a number' --jobs
refused '--jobs is -2: expected a whole number' --jobs -2
refused '--jobs is empty: expected a whole number' --jobs ''
refused '--only needs the name of a part' --only
refused '--only needs the name of a part' --only ''
known='fig03, fig05, fig06, fig06_paper, paper, precision, smoke, timing'
refused "--only is fig99: expected claims, faults, cost, solvers, live or one of $known" --only fig99
refused "--only is fig: expected claims, faults, cost, solvers, live or one of $known" --only fig03,fig
check 'a refused command writes no log' test ! -e "$tree/build/log"
reproduce 0 --help
for option in --only --fresh --verbose --jobs --no-install; do
  check "the help has $option" grep -q -e "^  $option" "$work/stdout"
done

reproduce 0 --no-install
asked 'verify --suite paper,precision,extreme,general --output build/run'
asked 'faults --reuse --build build'
asked 'claims --program build/src/cli/pulloff --run build/run --brief'
asked 'report --run build/run --output build/report'
asked 'sheet --output build/report'
check 'each program is asked once' test "$(wc -l <"$tree/asked")" -eq 5
check 'the verdicts are printed after the steps' test "$(tail -n 3 "$work/stdout" | head -n 2 | tr '\n' ,)" = 'made-claim 1.57 reproduced,a verdict,'
check 'steps are counted' grep -q -x '\[4/7\] Running the cases  *[0-9.]* s' "$work/stdout"
check 'the last step is counted' grep -q -x '\[7/7\] Writing the report  *[0-9.]* s' "$work/stdout"
reproduce 0 --no-install --verbose
asked 'verify --suite paper,precision,extreme,general --output build/run --verbose'
not_asked '^claims .*--brief'
mkdir -p "$tree/build/claims/kept"
reproduce 0 --no-install --fresh --jobs 3
check '--fresh removes the kept results of the claims' test ! -e "$tree/build/claims"
asked 'verify --suite paper,precision,extreme,general --output build/run --jobs 3 --fresh'
asked 'faults --build build --jobs 3'
asked 'report --run build/run --output build/report --fresh'

reproduce 0 --no-install --only fig06 --only timing
asked 'verify fig06 fig06_paper timing --output build/run'
asked 'report .*'
not_asked faults
not_asked claims
check 'only the selected steps are run' grep -q '^\[5/5\] Writing the report ' "$work/stdout"
reproduce 0 --no-install --only fig3,smoke
asked 'verify fig03 fig03 --output build/run'
reproduce 0 --no-install --only fig05
asked 'report .*'
not_asked '^verify'
# A part that is no case makes what it is about, and no report, if there is no record of a case: a report of nothing was a
# failure with status 4, after the page or the matrix of faults had been made.
reproduce 0 --no-install --only faults
asked 'faults --reuse --build build'
not_asked '^report'
check 'why there is no report' grep -q -x 'No report, because build/run has no record of a case: .*' "$work/stdout"
check 'no step of a report' grep -q '^\[4/4\] Planting faults ' "$work/stdout"
mkdir -p "$tree/build/run/fig03"
: >"$tree/build/run/fig03/record.json"
reproduce 0 --no-install --only faults
asked 'report .*'
not_asked '^verify'

# --only claims runs the cases whose results the claims use.
reproduce 0 --no-install --only claims
asked 'verify fig03 timing --output build/run'
asked 'claims --program build/src/cli/pulloff --run build/run --brief'
asked 'report .*'
not_asked faults
check 'the verdicts on the paper are printed' grep -q -x 'made-claim 1.57 reproduced' "$work/stdout"
reproduce 0 --no-install --only faults,claims
asked 'verify fig03 timing --output build/run'
asked 'faults --reuse --build build'
check 'all steps' grep -q '^\[7/7\] Writing the report ' "$work/stdout"

# The example solvers are asked only if it is asked for.
not_asked solver
mkdir -p "$tree/build/run/solvers/newton"
reproduce 0 --no-install --only solvers --fresh
check 'records of solvers are made again' [ ! -e "$tree/build/run/solvers" ]
asked 'run smoke fig03_paper fig04_paper --fresh --output build/run'
asked 'run smoke --solver reference/solvers/newton.yaml .*--solver reference/solvers/paper.yaml@251 .* --output build/run'
asked 'run fig03_paper --points 0-3 --solver reference/solvers/newton.yaml .*--solver reference/solvers/wrong.yaml --output build/run'
asked 'run fig04_paper --points 0,6,11,15,19,21 --solver reference/solvers/newton.yaml .* --output build/run'
asked 'run solver_times --solver reference/solvers/wrong.yaml --output build/run'
asked 'run solver_times --points 0-11 --solver pulloff .*--solver reference/solvers/paper.yaml@251 --solver reference/solvers/copson.yaml@1 --output build/run'
asked 'run solver_times --solver pulloff .*--solver reference/solvers/paper.yaml@251 --output build/run'
asked 'report .*'
not_asked faults
not_asked claims
check 'two steps of the solvers' grep -q '^\[6/6\] Writing the report ' "$work/stdout"

# The cost is measured only if it is asked for.
not_asked '^cost'
reproduce 0 --no-install --only cost
asked 'cost build/cost/cost.json'
asked 'report .*'
not_asked '^verify'

# The published rows are judged if their folder is given, and only then.
refused '--data needs the name of a folder' --only rate --data
refused "--data is $work/none: no such folder" --only rate --data "$work/none"
refused '--data has no effect without --only rate' --only cost --data "$work"
mkdir -p "$tree/reports/rate"
printf 'import sys\nopen("asked", "a").write("rows " + " ".join(sys.argv[1:]) + "\\n")\nprint("judged rows")\n' >"$tree/reports/rate/judge.py"
printf 'name: rate_wavy\nsuites: [rate]\n' >"$tree/cases/rate_wavy.yaml"
reproduce 0 --no-install --only rate
asked 'verify rate_wavy --output build/run'
not_asked '^rows'
reproduce 0 --no-install --only rate --data "$work" --jobs 3
asked "rows build/src/cli/pulloff $work build/rate --jobs 3"
check 'the verdicts of the rows are printed' grep -q -x 'judged rows' "$work/stdout"
rm "$tree/cases/rate_wavy.yaml"

# The page with the solver is made if it is asked for; once it exists, with every report, and before it.
mkdir -p "$tree/reports/live"
printf '#!/bin/sh\necho "page $*" >>asked\nmkdir -p build/live\necho page >build/live/live.html\n' >"$tree/reports/live/build.sh"
chmod +x "$tree/reports/live/build.sh"
not_asked '^page'
reproduce 0 --no-install --only live
check 'the page, then the report and the sheet' test "$(cut -d ' ' -f 1 "$tree/asked" | tr '\n' ' ')" = 'page report sheet '
asked 'page --no-install'
check 'the page is beside the report' test -s "$tree/build/report/live.html"
reproduce 0 --no-install --only cost
asked 'page --no-install'
rm -r "$tree/build/report/live.html" "$tree/build/run/fig03"
reproduce 0 --no-install --only live
not_asked '^report'
check 'the page without a report' grep -q -x 'Page: build/report/live.html' "$work/stdout"
rm "$tree/build/report/live.html"

# Failures are reported, and the exit code states them.
for code in 1 3; do
  echo "$code" >"$tree/code"
  reproduce "$code" --no-install --only fig03
  check 'the report is written although a check or a solve failed' grep -q "Running the cases .*(status $code, see build/log/reproduce.log)" "$work/stdout"
  asked 'report .*'
done
echo 130 >"$tree/code"
reproduce 130 --no-install --only fig03
check 'interrupted' grep -q 'interrupted; finished points are kept: run the command again to continue' "$work/stderr"
not_asked '^report'
echo 2 >"$tree/code"
reproduce 4 --no-install --only fig03
not_asked '^report'
rm "$tree/code"
for code in 1 3; do
  echo "$code" >"$tree/judged"
  reproduce 0 --no-install
  asked 'report .*'
done
echo 2 >"$tree/judged"
reproduce 4 --no-install
check 'a faulty list of claims' grep -q 'the claims could not be judged' "$work/stderr"
rm "$tree/judged"
reproduce 0 --no-install

# Progress: a line at intervals, with the progress of the step and the durations of the later steps in the last run.
# Durations are kept only for complete runs, because parts take less time.
check 'durations are kept' test "$(cut -f 1 "$tree/build/log/reproduce.seconds" | sort | tr '\n' ,)" = \
  'Building,Judging the claims,Planting faults,Running the cases,Writing the report,'
sed -i 's/^plain_interval=.*/plain_interval=1/' "$tree/tools/steps.sh"
printf 'Planting faults\t20\nJudging the claims\t11\nWriting the report\t7\n' >"$tree/build/log/reproduce.seconds"
echo 2.5 >"$tree/slow"
reproduce 0 --no-install
check 'remaining time: 130 s of this step, 38 s of the later steps' \
  grep -q -x '\[4/7\] Running the cases: 3/8 solves, [1-4] s since the start, about 2 min 48 s left' "$work/stderr"
reproduce 0 --no-install --only fig03
check 'remaining time of a part: 130 s of this step, 15 s of the report' \
  grep -q -x '\[4/5\] Running the cases: 3/8 solves, [1-4] s since the start, about 2 min 25 s left' "$work/stderr"
printf '#!/bin/sh\nsleep 2.5\n' >"$work/bin/meson"
reproduce 0 --no-install --only fig03
check 'no remaining time before the cases of a part report progress' \
  grep -q -x '\[3/5\] Building, [0-9]* s since the start' "$work/stderr"
reproduce 0 --no-install --only fig05
check 'the duration of the report is known' grep -q -x '\[3/4\] Building, [0-9]* s since the start, about .* left' "$work/stderr"
printf '#!/bin/sh\n' >"$work/bin/meson"
if command -v script >/dev/null; then
  (cd "$tree" && script -qec './reproduce --no-install' /dev/null </dev/null) >"$work/screen" 2>&1
  check 'on a terminal the progress line is updated in place' grep -q "$(printf '\r')\[4/7\] Running the cases: 3/8 solves, " "$work/screen"
fi

# Ctrl-C: the run ends, no report is written, and no more progress is printed. Python starts the command, because a shell
# starts background jobs with SIGINT ignored and cannot undo this.
echo 20 >"$tree/slow"
cat >"$work/start.py" <<'START'
import os, signal, sys
signal.signal(signal.SIGINT, signal.SIG_DFL)
signal.signal(signal.SIGPIPE, signal.SIG_DFL)
os.setsid()
os.chdir(sys.argv[1])
os.execv("./reproduce", ["./reproduce", "--no-install"])
START
rm -f "$tree/asked"
/usr/bin/python3 "$work/start.py" "$tree" >"$work/stdout" 2>"$work/stderr" &
child=$!
sleep 2
kill -INT -$child
wait $child
check 'exit code 130' test $? -eq 130
check 'the message says what is kept' grep -q 'interrupted; finished points are kept' "$work/stderr"
not_asked '^report'
finish
