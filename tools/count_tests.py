"""Prints the number of passed and of failed tests in a testlog.json of meson.

If a test prints TAP, each TAP line counts as a test. A TAP test that failed without a failed line
(crash, timeout or wrong plan) counts as one more failure.
"""

import json
import re
import sys

PASSED = ("OK", "EXPECTEDFAIL")
LEFT_OUT = ("SKIP",)
TAP_LINE = re.compile(r"^(not )?ok\b.*?(#\s*(skip|todo)\b.*)?$", re.IGNORECASE)


def count(entry):
    """(passed, failed) of one test."""
    good = entry["result"] in PASSED
    output = entry.get("stdout") or ""
    if re.search(r"^1\.\.\d+", output, re.MULTILINE):
        lines = [found for found in map(TAP_LINE.match, output.splitlines()) if found]
        failed = sum(bool(found.group(1)) and not found.group(2) for found in lines)
        passed = sum(not found.group(1) and not found.group(2) for found in lines)
        return passed, failed if good or failed else 1
    if entry["result"] in LEFT_OUT:
        return 0, 0
    return (1, 0) if good else (0, 1)


def main(path):
    try:
        with open(path, encoding="utf-8") as stream:
            entries = [json.loads(line) for line in stream if line.strip()]
    except (OSError, ValueError) as error:
        print(f"{path}: {error}", file=sys.stderr)
        return 1
    counts = [count(entry) for entry in entries]
    if not counts:
        print(f"{path}: no tests", file=sys.stderr)
        return 1
    print(sum(passed for passed, _ in counts), sum(failed for _, failed in counts))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
