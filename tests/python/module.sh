#!/bin/sh
# The installed Python module finds the installed library; pip installs the folder python/; the example runs.
# Usage: module.sh BUILD PREFIX
# shellcheck disable=SC1091,SC2154
. "$(dirname "$0")/../install/lib.sh"
python=/usr/bin/python3
module=$(dirname "$(dirname "$(find "$work/prefix" -path '*/pulloff/__init__.py')")")
example=$work/prefix/share/doc/pulloff/doc/examples/tour.py

check 'the module is installed' test -d "$module"
(cd "$source/python/pulloff" && ls ./*.py py.typed) >files.txt
check 'all of its files' sh -c 'cd "$0/pulloff" && ls $(cat "$1")' "$module" "$work/files.txt"
check 'the example with the installed module' alone PYTHONPATH="$module" $python -W error -B "$example"
cp output tour.txt
check 'its numbers' grep -q '^pull-off force 2.651192. +- ' tour.txt
check 'its figure is drawn' alone PYTHONPATH="$module" $python -B "$example" tour.svg
check 'its figure' test -s tour.svg
check 'the library is that of the installation' alone PYTHONPATH="$module" $python -B -c \
  'import pulloff._library as l, sys; sys.exit(not next(l.candidates()).startswith(sys.argv[1]))' "$work/prefix"
# On a system without dpkg-architecture meson installs libraries in lib64.
mkdir -p other/lib/python3/dist-packages other/lib64
cp -r "$module/pulloff" other/lib/python3/dist-packages/
cp "$(find "$work/prefix" -name libpulloff.so.0)" other/lib64/
check 'a library in lib64 is found' alone PYTHONPATH="$work/other/lib/python3/dist-packages" $python -B -c 'import pulloff'
if $python -c 'import setuptools, wheel, pip' 2>/dev/null; then
  cp -r "$source/python" package
  check 'pip installs the folder' $python -m pip install --quiet --no-build-isolation --no-deps --no-index --target site ./package
  check 'all files of the folder' sh -c 'cd site/pulloff && ls $(cat "$0")' "$work/files.txt"
  folder=$(dirname "$(find "$work/prefix" -name libpulloff.so)")
  # In a virtual environment the module finds the library of the program in PATH, or that which pkg-config names.
  $python -m venv --without-pip --system-site-packages env
  cp -r site/pulloff env/lib/python3*/site-packages/
  check 'the example in a virtual environment' alone env/bin/python -W error -B "$example"
  check 'the version of module and program' alone env/bin/python -B -c \
    'import pulloff, subprocess, sys; sys.exit("pulloff " + pulloff.__version__ != subprocess.getoutput("pulloff --version"))'
  check 'without the program in PATH' fails alone PATH=/usr/bin:/bin env/bin/python -B -c 'import pulloff'
  sed -i "s,^libdir=.*,libdir=$folder," "$folder/pkgconfig/pulloff.pc"
  check 'with pkg-config' alone PATH=/usr/bin:/bin PKG_CONFIG_PATH="$folder/pkgconfig" env/bin/python -B -c 'import pulloff'
  check 'without a library' fails alone PYTHONPATH="$work/site" PULLOFF_LIBRARY=/nowhere $python -B -c 'import pulloff'
  alone PYTHONPATH="$work/site" PULLOFF_LIBRARY=/nowhere $python -B -c 'import pulloff' >said.txt 2>&1
  check 'says what to do' grep -q 'ImportError: the C library of pulloff cannot be loaded .* set PULLOFF_LIBRARY' said.txt
fi
# A wheel has the library beside the module.
wheel=$($python "$source/python/wheel.py" "$(find "$work/prefix" -name libpulloff.so.0)" "$work")
$python -m venv --system-site-packages wheel && check 'pip installs a wheel' wheel/bin/pip -q install --no-index --no-deps "$wheel"
check 'its library is that beside the module' alone PATH=/usr/bin:/bin wheel/bin/python -I -B -c \
  'import pulloff._library as l, sys; sys.exit(not l.C._name.startswith(sys.argv[1]))' "$work/wheel/"
check 'the same input gives the same wheel' sh -c 'mv "$1" first.whl && "$0" "$2" "$3" . >/dev/null && cmp first.whl "$(basename "$1")"' \
  $python "$wheel" "$source/python/wheel.py" "$(find "$work/prefix" -name libpulloff.so.0)"
finish
