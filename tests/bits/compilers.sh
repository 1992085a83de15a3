#!/bin/sh
# Builds the program with GCC without optimisation, and with Clang at its highest level, and compares the digests; those of GCC at
# its highest level, at which meson builds a release, are compared by the test `bits`. The folder with the builds is kept. Called by
# .ci/run, which has installed both compilers.
set -u
cd "$(dirname "$0")/../.." || exit 4
folder=build-compilers
variants=
for variant in gcc-0 clang-3; do
  at=$folder/$variant
  if [ ! -f "$at/build.ninja" ]; then
    CC=${variant%-*} meson setup "$at" -Dtests=false -Dbuildtype=plain -Doptimization="${variant#*-}" >"$folder-$variant.log" 2>&1 ||
      { cat "$folder-$variant.log"; exit 4; }
    rm "$folder-$variant.log"
  fi
  meson compile -C "$at" src/cli/pulloff:executable >"$at/log" 2>&1 || { cat "$at/log"; exit 4; }
  variants="$variants $variant=$at/src/cli/pulloff"
done
# shellcheck disable=SC2086 # a list
exec python3 tests/bits/bits.py $variants
