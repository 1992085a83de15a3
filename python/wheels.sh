#!/bin/sh
# Makes wheels of the module with libpulloff in them, which need the C library and NumPy alone: build/wheels/*.whl. The library is
# compiled from src/ with the sources of GSL, nettle and jansson (tools/sources.sh); for the other targets with Debian's cross
# compilers.
#
# Usage: wheels.sh [--no-install] [TARGET...]      TARGET: x86_64, aarch64 (Linux), windows; default all
set -u
cd "$(dirname "$0")/.." || exit 4
command_name=wheels
. tools/setup.sh
. tools/sources.sh
at=$build/wheels
install=yes
if [ "${1:-}" = --no-install ]; then
  install=no
  shift
fi
[ $# -gt 0 ] || set -- x86_64 aarch64 windows

# packages_of TARGET: the packages beside those of tools/packages
packages_of() {
  case $1 in
  aarch64) echo gcc-aarch64-linux-gnu libc6-dev-arm64-cross ;;
  windows) echo gcc-mingw-w64-x86-64-posix ;;
  esac
}

# cross_file PROCESSOR SYSTEM SUFFIX OPTION LINK-OPTION: the compiler is ${prefix}gccSUFFIX
cross_file() {
  cat <<INI >"$at/$target.ini"
[binaries]
c = '${prefix}gcc$3'
ar = '${prefix}ar'
strip = '${prefix}strip'
[host_machine]
system = '$2'
cpu_family = '$1'
cpu = '$1'
endian = 'little'
[built-in options]
c_args = [$4]
c_link_args = [$5]
INI
}

# make_wheel TARGET: compiles the library and tests/library/solve_json.c, and packs
make_wheel() {
  target=$1
  prefix=
  library=src/library/libpulloff.so.0
  licences="$sources/gsl/COPYING $sources/nettle/COPYING.LESSERv3 $sources/jansson/LICENSE"
  case $target in
  x86_64) ;;
  aarch64)
    prefix=aarch64-linux-gnu-
    cross_file aarch64 linux '' '' ''
    ;;
  windows)
    # Without warnings: GCC does not know that printf is that of mingw-w64. The other targets show those that apply.
    prefix=x86_64-w64-mingw32-
    cross_file x86_64 windows -posix "'-w'" "'-static'"
    library=src/library/libpulloff-0.dll
    licences="$licences /usr/share/doc/mingw-w64-common/copyright"
    ;;
  *) fail "unknown target $target: expected x86_64, aarch64 or windows" ;;
  esac
  build_targets='pulloff:shared_library solve_json'
  set -- -Dstandalone="$sources" -Dtests=false
  [ -z "$prefix" ] || set -- "$@" --cross-file "$at/$target.ini"
  configure_and_build "$at/$target" ", $target" "$@"
  # Symbols for debugging would be a tenth of the file.
  "${prefix}strip" -s -o "$at/$target/stripped" "$at/$target/$library" || fail "no library for $target"
  # The list of licences is meant to split.
  # shellcheck disable=SC2086
  python3 python/wheel.py "$at/$target/stripped" "$at" $licences || fail "no wheel for $target"
}

mkdir -p "$at"
start_log
if [ "$install" = yes ]; then
  # The lists are meant to split.
  # shellcheck disable=SC2046
  install_packages $(listed_packages tools/packages) $(for target in "$@"; do packages_of "$target"; done)
fi
get_sources
for target in "$@"; do make_wheel "$target"; done
