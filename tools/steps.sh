# shellcheck shell=sh disable=SC2154
# Sourced by tools/setup.sh: runs the steps of a command. The output of a step goes to the log. While a step runs, a
# line on the terminal shows the progress of the step and of the command; when it has ended, one line shows its time. If
# standard error is not a terminal, a progress line is printed every `plain_interval` seconds.
# `step_labels`: the names of all steps in their order, one per line; empty: steps are not numbered.

step_labels=
step_times= # file with the duration of each step in the last run, in seconds; empty: durations are not kept
step_open=  # the step whose duration is unknown until its own progress lines estimate it
step_least= # not empty: everything is computed again, so a step is expected to take at least as long as the first time

# Seconds between progress lines if standard error is not a terminal.
plain_interval=60

milliseconds() { date +%s%N | cut -c 1-13; }
whole_begin=$(milliseconds)

# seconds_since START: prints the elapsed time in seconds with one decimal
seconds_since() {
  elapsed=$(($(milliseconds) - $1))
  printf '%d.%d s' $((elapsed / 1000)) $((elapsed % 1000 / 100))
}

# span SECONDS: prints a duration in the format of pulloff run
span() {
  if [ "$1" -lt 90 ]; then printf '%d s' "$1"; else printf '%d min %02d s' $(($1 / 60)) $(($1 % 60)); fi
}

start_log() {
  mkdir -p "$log_folder" || fail "cannot create the folder $log_folder"
  : >"$log" || fail "cannot write $log"
}

# numbered LABEL: prints the label with its number among the steps
numbered() {
  [ -z "$step_labels" ] || printf '%s\n' "$step_labels" |
    awk -v label="$1" '$0 == label { n = NR } END { if (n) printf "[%d/%d] ", n, NR }'
  printf '%s' "$1"
}

# first_time LABEL: prints the approximate duration of a first run, in seconds, on two cores
first_time() {
  case $1 in
  'Installing packages') echo 90 ;;
  Configuring) echo 10 ;;
  Building) echo 60 ;;
  'Running the cases') echo 450 ;;
  'Planting faults') echo 70 ;;
  'Judging the claims') echo 40 ;;
  'Making the page') echo 60 ;;
  'Writing the report') echo 15 ;;
  *) echo 0 ;;
  esac
}

# expected_time LABEL: prints the duration in the last run, or else that of a first run, in seconds
expected_time() {
  expected=
  [ -z "$step_times" ] || [ ! -r "$step_times" ] ||
    expected=$(awk -F '\t' -v label="$1" '$1 == label { print $2 }' "$step_times")
  first=$(first_time "$1")
  if [ -z "$expected" ] || { [ -n "$step_least" ] && [ "$expected" -lt "$first" ]; }; then expected=$first; fi
  printf '%d' "$expected"
}

# is_open LABEL: whether the duration of this step or of a later one is unknown
is_open() {
  [ -n "$step_open" ] && printf '%s\n' "$step_labels" |
    awk -v label="$1" -v open="$step_open" '$0 == label { seen = 1 } seen && $0 == open { found = 1 } END { exit !found }'
}

# time_after LABEL: prints the expected duration of all later steps, in seconds
time_after() {
  after=0
  found=
  while IFS= read -r later; do
    [ -z "$found" ] || after=$((after + $(expected_time "$later")))
    [ "$later" != "$1" ] || found=yes
  done <<LABELS
$step_labels
LABELS
  printf '%d' "$after"
}

remember_time() { # LABEL SECONDS
  [ -n "$step_times" ] || return 0
  {
    [ ! -r "$step_times" ] || awk -F '\t' -v label="$1" '$1 != label' "$step_times"
    printf '%s\t%d\n' "$1" "$2"
  } >"$step_times.new" && mv "$step_times.new" "$step_times"
}

# own_progress: reads the last progress line of the command that the step runs, such as "3/8 solves, 5 s elapsed, about
# 2 min 10 s remaining (...)", and prints it as "REMAINING-SECONDS 3/8 solves"
own_progress() {
  tail -n "+$((lines_before + 2))" "$log" | tail -c 4000 |
    sed -n 's/^\([0-9]*\/[0-9]* [a-z]*\), .* elapsed, about \(.*\) remaining.*/\2 \1/p' | tail -n 1 |
    awk '{ if ($2 == "min") print 60 * $1 + $3, $5, $6; else print $1, $3, $4 }'
}

# progress_line LABEL LATER: prints the progress of the step and of the command; LATER is the expected duration of the
# later steps, in seconds
progress_line() {
  own=$(own_progress)
  now=$(milliseconds)
  if [ -n "$own" ]; then
    left=${own%% *}
    own=": ${own#* }"
  elif is_open "$1"; then
    left=unknown
  else
    left=$(($(expected_time "$1") - (now - step_begin) / 1000))
    [ "$left" -gt 0 ] || left=0
  fi
  [ "$left" = unknown ] || left=$((left + $2))
  printf '%s%s, %s since the start' "$(numbered "$1")" "$own" "$(span $(((now - whole_begin) / 1000)))"
  case $left in
  0 | unknown) ;;
  *) printf ', about %s left' "$(span "$left")" ;;
  esac
}

# watch_step LABEL: prints progress until it is ended or the shell that started it has ended
watch_step() {
  later=$(time_after "$1")
  ticks=0
  while sleep 1 >/dev/null 2>&1 && kill -0 $$ 2>/dev/null; do
    ticks=$((ticks + 1))
    if [ -t 2 ]; then
      columns=$(stty size <&2 2>/dev/null | cut -d ' ' -f 2)
      printf '\r%.*s\033[K' "$((${columns:-80} - 1))" "$(progress_line "$1" "$later")" >&2
    elif [ $((ticks % plain_interval)) -eq 0 ]; then
      printf '%s\n' "$(progress_line "$1" "$later")" >&2
    fi
  done
}

end_watch() {
  [ -n "${watcher:-}" ] || return 0
  # SIGTERM could be lost: a subshell that has just been started still has the traps of its parent.
  kill -KILL "$watcher" 2>/dev/null
  wait "$watcher" 2>/dev/null
  watcher=
  [ ! -t 2 ] || printf '\r\033[K' >&2
}

# try_step LABEL COMMAND...: runs the command with its output in the log, and sets step_status.
try_step() {
  label=$1
  shift
  step_begin=$(milliseconds)
  lines_before=$(wc -l <"$log")
  printf '== %s: %s\n' "$label" "$*" >>"$log"
  watch_step "$label" &
  watcher=$!
  # In a subshell, so that a message of a trap is not redirected where the command is a function.
  ("$@") >>"$log" 2>&1 </dev/null
  step_status=$?
  end_watch
  printf '%-40s%10s' "$(numbered "$label")" "$(seconds_since "$step_begin")"
  if [ "$step_status" -eq 0 ]; then
    printf '\n'
    remember_time "$label" $((($(milliseconds) - step_begin + 500) / 1000))
  else
    printf '  (status %d, see %s)\n' "$step_status" "$log"
  fi
}

# step LABEL COMMAND...: the same; if the command fails, prints the end of its output and exits.
step() {
  try_step "$@"
  [ "$step_status" -ne 0 ] || return 0
  tail -n "+$((lines_before + 2))" "$log" | tail -n 40 >&2
  fail "$label failed with status $step_status; the whole output is in $log"
}
