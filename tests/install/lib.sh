# Functions for the tests of an installation. Sourced with the build folder as $1 and the configured prefix as $2:
# installs into $work/prefix, which is another one. The tests run in the folder $work, which is removed at the end.
# shellcheck shell=sh disable=SC2034
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
source=$(cd "$here/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 99
passed=0
failed=0

# check WHAT COMMAND...: tests that the command succeeds.
check() {
  what=$1
  shift
  if "$@" >"$work/output" 2>&1; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    printf 'FAILED: %s\n  %s\n' "$what" "$*"
    sed 's/^/  /' "$work/output"
  fi
}

# fails COMMAND...: succeeds if the command fails.
fails() { ! "$@"; }

meson install -C "$build" --no-rebuild --quiet --strip --destdir "$work/root" || exit 99
mv "$work/root$2" "$work/prefix" || exit 99

# alone COMMAND...: runs a command without any variable of the environment of the tests that could lead to the source.
alone() { env -i PATH="$work/prefix/bin:/usr/bin:/bin" HOME="$work" ${LANG:+LANG="$LANG"} OPENBLAS_NUM_THREADS=1 "$@"; }

finish() {
  printf '%s passed, %s failed\n' "$passed" "$failed"
  [ "$failed" -eq 0 ]
}
