#!/bin/sh
# The examples compile against the installed library, shared and static, by pkg-config, and run.
# shellcheck disable=SC1091,SC2016,SC2154
. "$(dirname "$0")/lib.sh"
PKG_CONFIG_PATH=$(dirname "$(find "$work/prefix" -name pulloff.pc)")
export PKG_CONFIG_PATH
examples=$work/prefix/share/doc/pulloff/doc/examples
folder=$(dirname "$(find "$work/prefix" -name libpulloff.so)")
[ "$3" = none ] && sanitize= || sanitize=-fsanitize=$3

config() { pkg-config --define-variable=prefix="$work/prefix" "$@" pulloff; }

# compile PROGRAM SOURCE FLAG...: the words of the flags are meant to split.
compile() {
  made=$1
  from=$2
  shift 2
  # shellcheck disable=SC2046,SC2086
  ${CC:-cc} -std=c99 -D_POSIX_C_SOURCE=200809L -Wall -Wextra -Wpedantic -Werror $sanitize $(config --cflags) "$from" -o "$made" "$@"
}

check 'the version' test "$(config --modversion)" = "$(prefix/bin/pulloff --version | cut -d ' ' -f 2)"
check 'the symbols have a version and no other name is exported' sh -c \
  'nm -D --defined-only "$0" | grep -v -e " pulloff_[a-z_]*@@PULLOFF_0$" -e " A PULLOFF_0$" | (! grep .)' "$folder/libpulloff.so"
check 'the name of the library' sh -c 'objdump -p "$0" | grep -q "SONAME *libpulloff.so.0$"' "$folder/libpulloff.so"

found=0
for file in "$examples"/*.c; do
  name=$(basename "$file" .c)
  found=$((found + 1))
  # shellcheck disable=SC2046
  check "$name compiles" compile "$name" "$file" $(config --libs) -pthread -lm
  # shellcheck disable=SC2046
  check "$name compiles with the static library" compile "$name-static" "$file" "$folder/libpulloff.a" \
    $(config --static --libs | sed 's/-lpulloff//') -pthread
  check "$name does not need the shared library if it is static" sh -c '! objdump -p "$0" | grep -q "NEEDED *libpulloff"' "$name-static"
  check "$name runs" alone LD_LIBRARY_PATH="$folder" ./"$name"
  cp output "$name.txt"
  check "$name runs with the static library" alone ./"$name-static"
  cp output "$name-static.txt"
  check "$name prints the same with both" cmp "$name.txt" "$name-static.txt"
  check "$name prints something" test -s "$name.txt"
done
check 'there are examples' test "$found" -ge 3

alone LD_LIBRARY_PATH="$folder" ./pull_off tabor=3 amplitude=1 wavelength=20 >pull_off.txt
alone pulloff solve --tabor 3 --amplitude 1 --wavelength 20 >program.txt
check 'the pull-off is that of the program' test "$(sed -n 's/^pull-off force \([0-9.]*\) .*/\1/p' pull_off.txt)" = \
  "$(sed -n 's/^pull-off force \([0-9.]*\) .*/\1/p' program.txt)"
alone LD_LIBRARY_PATH="$folder" ./pull_off tabor=-3 >pull_off.txt 2>&1
check 'a wrong value is refused' test $? -eq 1
check 'its message' grep -q '^tabor is -3: expected a finite number >= 0$' pull_off.txt
if command -v "${CXX:-c++}" >/dev/null; then
  printf '#include <pulloff.h>\nint main() { return pulloff_version()[0] == 0; }\n' >main.cc
  # shellcheck disable=SC2046,SC2086
  check 'the header in C++' "${CXX:-c++}" -Wall -Wextra -Werror $sanitize $(config --cflags) main.cc -o main $(config --libs)
fi
# The mex file, if Octave and its compiler are there (octave-dev).
if command -v mkoctfile >/dev/null && [ -z "$sanitize" ]; then
  # shellcheck disable=SC2046
  check 'the mex file compiles' mkoctfile --mex -Wall -Wextra -Werror -o pulloff_mex.mex "$examples/matlab/pulloff_mex.c" $(config --cflags --libs)
  cp "$examples/matlab/pull_off.m" .
  alone LD_LIBRARY_PATH="$folder" octave-cli --norc pull_off.m >octave.txt 2>&1
  check 'the example runs in Octave' test $? -eq 0
  check 'its digest is that of the program' grep -q \
    "^$(alone pulloff solve --tabor 3 --amplitude 1 --wavelength 20 --want curve | grep '^digest' | tr -s ' ')$" octave.txt
  check 'a wrong value is an error in Octave' grep -q '^refused: .*tabor is -3: expected a finite number >= 0$' octave.txt
fi
finish
