#!/bin/sh
# Makes wheels and compares the digests of their libraries with those of tests/bits/scenes.txt: on this processor by the module,
# installed by pip in a virtual environment; for aarch64 by qemu and for Windows by wine, by a C program with the library of the
# wheel; and those of the page's WebAssembly, by node. Prints a table.
#
# Usage: run.sh [--no-install] [--only WORD] [TARGET...]     TARGET: x86_64, aarch64, windows, page; default all
# --only: the scenes whose command line has this word. Exit status: 77 if the sources of the libraries cannot be had.
set -u
cd "$(dirname "$0")/../.." || exit 4
command_name=wheels
. tools/setup.sh
at=$(pwd)/build/wheels
no_install=
only=
while :; do
  case ${1-} in
  --no-install) no_install=--no-install ;;
  --only)
    only=$2
    shift
    ;;
  *) break ;;
  esac
  shift
done
[ $# -gt 0 ] || set -- x86_64 aarch64 windows page
wheels=
page=
packages=
for target in "$@"; do
  [ "$target" = page ] && page=yes || wheels="$wheels $target"
  case $target in
  aarch64) packages="$packages qemu-user-static" ;;
  windows) packages="$packages wine64" ;;
  x86_64) packages="$packages python3-venv" ;;
  esac
done
# Lists are meant to split.
# shellcheck disable=SC2086
if [ -n "$wheels" ]; then
  python/wheels.sh $no_install $wheels || { [ -f build/sources/complete ] || exit 77; exit 4; }
fi
[ -z "$page" ] || reports/live/build.sh $no_install || exit 4
log=$log_folder/wheels-run.log
: >"$log"
# shellcheck disable=SC2086
[ -n "$no_install" ] || install_packages $packages

# digest_of FILE COMMAND: the digest that a document prints of a command
digest_of() { awk -v command="$2" '$0 ~ "^[$] [a-z/]*pulloff " command "$" { seen = 1 } seen && $1 == "digest" { print $2; exit }' "$1"; }

# try_wheel WHEEL: a virtual environment without anything but NumPy, which is that of the system
try_wheel() {
  begin=$(milliseconds)
  rm -rf "$at/env"
  /usr/bin/python3 -m venv --system-site-packages "$at/env" && "$at/env/bin/pip" -q install --no-index --no-deps "$1" || return 1
  (cd / && "$at/env/bin/python" -I -c "import pulloff, pulloff._library as l; r = pulloff.solve(tabor=1); print(r['digest'], l.C._name)") >"$at/first.txt" || return 1
  printf '%-34s%10s\n' 'Wheel to first number' "$(seconds_since "$begin")"
  grep -q "^$(digest_of README.md 'solve --tabor 1') $at/env/" "$at/first.txt" || return 1
  test "$(cd / && "$at/env/bin/python" -I -c "import pulloff; print(pulloff.solve(tabor=3)['digest'])")" = "$(digest_of doc/guide.md 'solve --tabor 3')"
}

# The library of each wheel beside the program that solves with it.
set --
[ -z "$only" ] || set -- --only "$only"
for target in $wheels; do
  case $target in
  windows) wheel=$(echo "$at"/*-win_amd64.whl) program=solve_json.exe ;;
  *) wheel=$(echo "$at"/*_"$target".whl) program=solve_json ;;
  esac
  rm -rf "$at/$target/wheel"
  python3 -m zipfile -e "$wheel" "$at/$target/wheel" && folder=$at/$target/wheel/pulloff &&
    cp "$at/$target/$program" "$folder/" || fail "$wheel cannot be unpacked"
  case $target in
  x86_64)
    try_wheel "$wheel" || fail 'the wheel of x86_64 does not print the digests of README.md and doc/guide.md'
    set -- "$@" "x86_64 Linux, Python=$wheel=$at/env/bin/python -I tests/wheels/solve_json.py"
    ;;
  aarch64)
    set -- "$@" "aarch64 Linux, qemu=$wheel=qemu-aarch64-static -L /usr/aarch64-linux-gnu -E LD_LIBRARY_PATH=$folder $folder/$program"
    ;;
  windows)
    export WINEPREFIX="$at/wine" WINEDEBUG=-all
    /usr/lib/wine/wine64 wineboot >>"$log" 2>&1
    set -- "$@" "x86_64 Windows, wine=$wheel=/usr/lib/wine/wine64 $folder/$program"
    ;;
  esac
done
[ -z "$page" ] ||
  set -- "$@" "WebAssembly, node=build/live/pulloff.wasm=node tests/wheels/solve_json.mjs $(pwd)/reports/live/page/solver.js $(pwd)/build/live/pulloff.wasm"
python3 tests/wheels/digests.py "$@"
