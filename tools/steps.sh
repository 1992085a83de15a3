# shellcheck shell=sh disable=SC2154
# Sourced by tools/setup.sh: the steps of a command. What a step prints goes to the log; the terminal gets a live line,
# with how far the step and the whole are, and then one line a step with its time. Where standard error is no terminal
# the live line is a plain one now and then.
# `step_labels`, one a line, are the steps there may be, in their order; none: steps are not counted.

step_labels=
step_times= # the file with the seconds each step took the last time; none: they are not kept
step_open=  # the step of which nobody knows how long it will take until it tells itself
step_least= # yes: that time is of a run that kept much, so a step is expected to take no less than the first time

# Seconds between plain lines: a log shows life without filling up.
plain_interval=60

milliseconds() { date +%s%N | cut -c 1-13; }
whole_begin=$(milliseconds)

# seconds_since START: elapsed time with one decimal
seconds_since() {
  elapsed=$(($(milliseconds) - $1))
  printf '%d.%d s' $((elapsed / 1000)) $((elapsed % 1000 / 100))
}

# span SECONDS: as pulloff says it
span() {
  if [ "$1" -lt 90 ]; then printf '%d s' "$1"; else printf '%d min %02d s' $(($1 / 60)) $(($1 % 60)); fi
}

start_log() {
  mkdir -p "$log_folder" || fail "cannot create the folder $log_folder"
  : >"$log" || fail "cannot write $log"
}

# numbered LABEL: with its place among the steps
numbered() {
  [ -z "$step_labels" ] || printf '%s\n' "$step_labels" |
    awk -v label="$1" '$0 == label { n = NR } END { if (n) printf "[%d/%d] ", n, NR }'
  printf '%s' "$1"
}

# first_time LABEL: about how many seconds it takes when nothing is kept, on two cores
first_time() {
  case $1 in
  'Installing packages') echo 90 ;;
  Configuring) echo 10 ;;
  Building) echo 60 ;;
  'Running the cases') echo 700 ;;
  'Planting faults') echo 300 ;;
  'Judging the claims') echo 90 ;;
  'Writing the report') echo 60 ;;
  *) echo 0 ;;
  esac
}

# expected_time LABEL: the seconds it took the last time, if that is known
expected_time() {
  expected=
  [ -z "$step_times" ] || [ ! -r "$step_times" ] ||
    expected=$(awk -F '\t' -v label="$1" '$1 == label { print $2 }' "$step_times")
  first=$(first_time "$1")
  if [ -z "$expected" ] || { [ -n "$step_least" ] && [ "$expected" -lt "$first" ]; }; then expected=$first; fi
  printf '%d' "$expected"
}

# is_open LABEL: whether nobody knows how long this step or one after it will take
is_open() {
  [ -n "$step_open" ] && printf '%s\n' "$step_labels" |
    awk -v label="$1" -v open="$step_open" '$0 == label { seen = 1 } seen && $0 == open { found = 1 } END { exit !found }'
}

# time_after LABEL: the same of all steps after it
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

# own_progress: the last line in which the command of the step told how far it is, "3/8 solves, 5 s elapsed, about
# 2 min 10 s remaining (...)", as "SECONDS 3/8 solves"
own_progress() {
  tail -n "+$((lines_before + 2))" "$log" | tail -c 4000 |
    sed -n 's/^\([0-9]*\/[0-9]* [a-z]*\), .* elapsed, about \(.*\) remaining.*/\2 \1/p' | tail -n 1 |
    awk '{ if ($2 == "min") print 60 * $1 + $3, $5, $6; else print $1, $3, $4 }'
}

# progress_line LABEL LATER: how far the step and the whole are; LATER seconds are expected after the step
progress_line() {
  told=$(own_progress)
  now=$(milliseconds)
  if [ -n "$told" ]; then
    left=${told%% *}
    told=": ${told#* }"
  elif is_open "$1"; then
    left=unknown
  else
    left=$(($(expected_time "$1") - (now - step_begin) / 1000))
    [ "$left" -gt 0 ] || left=0
  fi
  [ "$left" = unknown ] || left=$((left + $2))
  printf '%s%s, %s since the start' "$(numbered "$1")" "$told" "$(span $(((now - whole_begin) / 1000)))"
  case $left in
  0 | unknown) ;;
  *) printf ', about %s left' "$(span "$left")" ;;
  esac
}

# watch_step LABEL: tells about the step until it is ended, or the shell is gone
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
  # A milder signal can be lost: a shell just begun has not yet put aside the traps of the one that began it.
  kill -KILL "$watcher" 2>/dev/null
  wait "$watcher" 2>/dev/null
  watcher=
  [ ! -t 2 ] || printf '\r\033[K' >&2
}

# try_step LABEL COMMAND...: runs the command quietly; sets step_status.
try_step() {
  label=$1
  shift
  step_begin=$(milliseconds)
  lines_before=$(wc -l <"$log")
  printf '== %s: %s\n' "$label" "$*" >>"$log"
  watch_step "$label" &
  watcher=$!
  "$@" >>"$log" 2>&1 </dev/null
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

# step LABEL COMMAND...: the same; when it fails, shows the end of what it printed, and ends.
step() {
  try_step "$@"
  [ "$step_status" -ne 0 ] || return 0
  tail -n "+$((lines_before + 2))" "$log" | tail -n 40 >&2
  fail "$label failed with status $step_status; the whole output is in $log"
}
