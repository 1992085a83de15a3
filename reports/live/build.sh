#!/bin/sh
# Makes build/live/live.html: the solver, compiled to WebAssembly from the sources in src/, and the page around it, in one
# file. Installs a compiler for WebAssembly with tools/setup.sh, and downloads the sources of the libraries that the solver
# uses (of GSL the tables of Gauss's rules, of nettle SHA-256, jansson) as Debian's source packages.
#
# Usage: build.sh [--no-install]
set -u
cd "$(dirname "$0")/../.." || exit 4
command_name=live
. tools/setup.sh
. tools/sources.sh
at=$build/live
mkdir -p "$at/objects"
start_log
[ "${1:-}" = --no-install ] ||
  install_packages clang lld wasi-libc libclang-rt-dev-wasm32 binaryen libgsl-dev libjansson-dev nettle-dev nodejs
get_sources

# write_ninja: prints the rules of the module. Every source file of the modules of libpulloff is in it, except for those that
# use OpenBLAS or a file system (machine/machine.c).
folder_of() { find src -type d -name "$1"; }
version=$(sed -n "s/^ *version: '\(.*\)',/\1/p" meson.build)
modules='library json series'
found=
while [ "$modules" != "$found" ]; do # with the modules on which these depend
  found=$modules
  modules=$(for module in $found; do
    echo "$module"
    sed -n "s|^  \['\([a-z]*/\)*$module', \[\([^]]*\)\].*|\2|p" src/meson.build | tr -d "',+" | tr ' ' '\n'
  done | sort -u | while read -r module; do [ -z "$(folder_of "$module")" ] || echo "$module"; done)
done
folders=$(for module in $modules; do folder_of "$module"; done)
write_ninja() {
  include='-Ireports/live/machine'
  for folder in $folders; do include="$include -I$folder"; done
  cat <<NINJA
builddir = $at
flags = --target=wasm32-wasi -O3 -msimd128 -DNDEBUG -ffp-contract=off -fno-math-errno -fvisibility=hidden -D_GNU_SOURCE $
  -D_WASI_EMULATED_SIGNAL -D_WASI_EMULATED_PROCESS_CLOCKS -idirafter $sources/include
rule own
  command = clang -std=c17 \$flags -Wall -Wextra -Wno-missing-field-initializers -DPULLOFF_VERSION=\"$version\" $include -MMD -MF \$out.d -c \$in -o \$out
  depfile = \$out.d
  deps = gcc
rule other
  command = clang -std=gnu17 \$flags -w -DHAVE_STDINT_H -DHAVE_UNISTD_H -DHAVE_SYS_TIME_H \$more -c \$in -o \$out
rule link
  command = clang --target=wasm32-wasi -mexec-model=reactor \$in -lwasi-emulated-signal -lwasi-emulated-process-clocks $
    -Wl,--export=malloc,--export=free,--gc-sections,--strip-all,--stack-first,-z,stack-size=1048576,--initial-memory=67108864 -o \$out.linked && $
    wasm-opt -O3 --enable-simd --enable-bulk-memory --enable-nontrapping-float-to-int --enable-sign-ext \$out.linked -o \$out
NINJA
  objects=
  add() { # RULE SOURCE OPTION
    object=$at/objects/$(printf '%s' "$2" | tr '/' '-').o
    objects="$objects $object"
    printf 'build %s: %s %s\n  more = %s\n' "$object" "$1" "$2" "${3:-}"
  }
  for folder in $folders; do
    for source in "$folder"/*.c; do
      case $source in */po_linear.c | */po_linear_start.c | */po_file.c | */po_machine.c | */po_windows.c) continue ;; esac
      add own "$source"
    done
  done
  for source in reports/live/machine/*.c; do add own "$source"; done
  add other "$sources/gsl/integration/glfixed.c"
  for name in error message stream; do add other "$sources/gsl/err/$name.c"; done
  for name in sha256 sha256-compress write-be32; do add other "$sources/nettle/$name.c" "-I$sources/nettle"; done
  for source in "$sources"/jansson/src/*.c; do add other "$source"; done
  echo "build $at/pulloff.wasm: link $objects"
}
write_ninja >"$at/build.ninja"
step 'Building for WebAssembly' ninja -f "$at/build.ninja" "$at/pulloff.wasm"
step 'Writing the page' python3 reports/live/assemble.py "$at/pulloff.wasm" "$version" "$build/run" "$at/live.html"
