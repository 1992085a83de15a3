#!/bin/sh
# An installed program works without the source tree, from any folder: its cases, reference data and report are found
# relative to the program.
# shellcheck disable=SC1091,SC2016,SC2154
. "$(dirname "$0")/lib.sh"
data=$work/prefix/share/pulloff

# Debug information, which meson leaves in a static library, has paths.
find "$work/prefix" -name '*.a' -exec strip --strip-debug {} +
# A path begins where the text before it is no part of a path: a tree at /pulloff is not PREFIX/share/pulloff.
whole() { printf '(^|[^[:alnum:]_./~-])%s(/|[^[:alnum:]_.-]|$)' "$(printf '%s' "$1" | sed 's/[^[:alnum:]/]/\\&/g')"; }
check 'no path of the source tree is installed' fails env LC_ALL=C \
  grep -rlaE -e "$(whole "$source")" -e "$(whole "$build")" "$work/prefix"
check 'nothing outside the prefix is installed' test -z "$(find "$work/root" -type f)"
check 'no compiled Python is installed' test -z "$(find "$work/prefix" -name '*.pyc')"
check 'the version' sh -c 'test "$(prefix/bin/pulloff --version)" = "pulloff $0"' \
  "$(meson introspect "$build" --projectinfo | sed 's/.*"version": "\([^"]*\)".*/\1/')"
check 'cases' alone pulloff plan smoke fig03
check 'every table is there' alone pulloff list --references
check 'every table is intact and in the index' sh -c '! grep -q -v -e "intact *$" -e "^table " "$0"' "$work/output"
cp "$data/reference/bradley.csv" bradley.csv
echo 1,2,3 >>"$data/reference/bradley.csv"
check 'the tables are those of the installation' fails alone pulloff list --references
mv bradley.csv "$data/reference/bradley.csv"
check 'the checks pass' alone pulloff verify smoke --output run
ln -s "$work/prefix/bin/pulloff" link
check 'by a symbolic link' alone ./link plan smoke
check 'PULLOFF_DATA has precedence' fails alone PULLOFF_DATA="$work/nowhere" pulloff plan smoke

# The report, if its Python packages are installed.
if [ "$4" = true ] && command -v gnuplot >/dev/null; then
  chmod -R a-w "$work/prefix"
  check 'the report' alone PULLOFF_PYTHON=/usr/bin/python3 PYTHONDONTWRITEBYTECODE=1 pulloff report --run run --output report
  chmod -R u+w "$work/prefix"
  check 'its pages' test -s report/report.html -a -s report/report.pdf
  check 'claims of the paper' alone PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$data/reports/claims/run.py" --run run \
    --program "$work/prefix/bin/pulloff" --claim eq4-compactness
fi

check 'the manual pages' test "$(find "$work/prefix/share/man/man1" -name 'pulloff*.1' -size +0 | wc -l)" -eq 17
if command -v man >/dev/null; then
  for page in "$work/prefix/share/man/man1"/*.1; do
    check "no fault in $(basename "$page")" \
      sh -c 'LC_ALL=C.UTF-8 MANWIDTH=100 man --warnings -l "$0" 2>&1 >/dev/null | (! grep .)' "$page"
  done
fi
check 'the page on JSON documents has its tables' grep -q '^| `pull_off` | meaning ' "$work/prefix/share/doc/pulloff/doc/json.md"
check 'links in the documents' /usr/bin/python3 "$here/links.py" "$work/prefix/share/doc/pulloff"
finish
