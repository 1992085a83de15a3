#!/bin/sh
# Builds the page (reports/live) and tests it in Debian's Chromium: the digests of its results are those of the program, and a
# reader can use it, from a report, too. The page that is tested has two figures of a run of its own. Arguments are passed to
# identical.py, e.g. `--random 200`.
set -u
cd "$(dirname "$0")/../.." || exit 4
command_name=live
reports/live/build.sh || exit 4
. tools/setup.sh
mkdir -p "$log_folder"
start_log
install_packages chromium
build/src/cli/pulloff run fig03 fig04 --output build/live/run >>"$log" 2>&1 &&
  python3 reports/live/assemble.py build/live/pulloff.wasm tested build/live/run build/live/tested.html &&
  mkdir -p build/live/report && cp build/live/tested.html build/live/report/live.html &&
  /usr/bin/python3 reports/make_report.py --run build/live/run --output build/live/report >>"$log" 2>&1 &&
  python3 tests/live/identical.py "$@" build/live/tested.html build/src/cli/pulloff &&
  python3 tests/live/page.py build/live/tested.html build/src/cli/pulloff build/live/report/report.html
