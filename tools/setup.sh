# shellcheck shell=sh disable=SC2154
# Sourced by ./reproduce, ./check and .ci/run: installs what is missing, configures, builds.
# Everything a step prints goes to the log; the terminal gets one line a step with its time.
# The caller sets `command_name` and stands in the root of the source tree.

build=build
log_folder=$build/log
log=$log_folder/$command_name.log

fail() {
  printf '%s: %s\n' "$command_name" "$*" >&2
  exit "${fail_status:-4}"
}

milliseconds() { date +%s%N | cut -c 1-13; }

# seconds_since START: elapsed time with one decimal
seconds_since() {
  elapsed=$(($(milliseconds) - $1))
  printf '%d.%d s' $((elapsed / 1000)) $((elapsed % 1000 / 100))
}

start_log() {
  mkdir -p "$log_folder" || fail "cannot create the folder $log_folder"
  : >"$log" || fail "cannot write $log"
}

# step LABEL COMMAND...: runs the command quietly; when it fails, shows the end of what it printed.
step() {
  label=$1
  shift
  step_begin=$(milliseconds)
  lines_before=$(wc -l <"$log")
  printf '%-34s' "$label"
  printf '== %s: %s\n' "$label" "$*" >>"$log"
  "$@" >>"$log" 2>&1 </dev/null
  step_status=$?
  if [ "$step_status" -ne 0 ]; then
    printf 'failed\n'
    tail -n "+$((lines_before + 2))" "$log" | tail -n 40 >&2
    fail "$label failed with status $step_status; the whole output is in $log"
  fi
  printf '%10s\n' "$(seconds_since "$step_begin")"
}

# step_progress LABEL COMMAND...: as step, for a command that tells its progress on standard error:
# on a terminal that is shown live. Sets step_status instead of failing.
step_progress() {
  label=$1
  shift
  step_begin=$(milliseconds)
  printf '== %s: %s\n' "$label" "$*" >>"$log"
  if [ -t 2 ]; then
    printf '%s\n' "$label"
    "$@" >>"$log" </dev/null
    step_status=$?
    printf '%-34s' ''
  else
    printf '%-34s' "$label"
    "$@" >>"$log" 2>&1 </dev/null
    step_status=$?
  fi
  if [ "$step_status" -eq 0 ]; then
    printf '%10s\n' "$(seconds_since "$step_begin")"
  else
    printf '%10s  (status %d, see %s)\n' "$(seconds_since "$step_begin")" "$step_status" "$log"
  fi
}

# listed_packages: the names in tools/packages
listed_packages() { sed -e 's/#.*//' -e '/^[[:space:]]*$/d' tools/packages; }

# missing_packages NAME...: those that are not installed, on one line
missing_packages() {
  for package in "$@"; do
    state=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) || state=absent
    [ "$state" = installed ] || printf '%s ' "$package"
  done
}

apt_install() {
  # A list that cannot be refreshed is not yet a failure: what is needed may be known already.
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q update ||
    printf 'apt-get update failed; trying to install all the same\n'
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends \
    -o DPkg::Lock::Timeout=300 install "$@"
}

# install_packages NAME...: installs those that are missing; with none missing calls nothing.
install_packages() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    fail "this is not a Debian system (no dpkg-query and apt-get): install the equivalents of" \
      "the packages in tools/packages and rerun with --no-install"
  fi
  missing=$(missing_packages "$@")
  [ -n "$missing" ] || return 0
  as_root=
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      fail "neither root nor sudo: have someone install ${missing% }"
    sudo -n true 2>/dev/null || sudo true ||
      fail "sudo was refused: have someone install ${missing% }"
    as_root=sudo
  fi
  # The word list is meant to split.
  # shellcheck disable=SC2086
  set -- $missing
  step "Installing packages ($#)" apt_install "$@"
}

# forget_foreign_build DIR: a build folder configured for a tree at another place, or whose
# configuration was cut short, is configured anew; runs and reports in it stay.
forget_foreign_build() {
  if [ -f "$1/meson-private/coredata.dat" ]; then
    if [ ! -f "$1/build.ninja" ] || [ "$(cat "$1/source-tree" 2>/dev/null)" != "$(pwd -P)" ]; then
      rm -rf "$1/meson-private" "$1/meson-info" "$1/build.ninja"
    fi
  fi
}

# configure_and_build DIR LABEL MESON-OPTION...
configure_and_build() {
  folder=$1
  suffix=$2
  shift 2
  forget_foreign_build "$folder"
  if [ ! -f "$folder/build.ninja" ]; then
    step "Configuring$suffix" meson setup "$folder" "$@"
    pwd -P >"$folder/source-tree"
  fi
  step "Building$suffix" meson compile -C "$folder"
}

# prepare: the set-up both commands share
prepare() {
  start_log
  if [ "$install" = yes ]; then
    # shellcheck disable=SC2046
    install_packages $(listed_packages)
  fi
  configure_and_build "$build" ''
}
