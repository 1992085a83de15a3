#!/usr/bin/env python3
"""Writes the checksum into a table that was made by hand, such as a digitised figure.

    seal.py FILE...              writes or updates the line `# sha256:` above the column names

Use it only for a table whose numbers you have just checked: a file with a correct checksum counts as undamaged.
"""

import sys

from tables import seal_lines


def main(paths):
    if not paths:
        print(__doc__, file=sys.stderr)
        return 2
    for path in paths:
        try:
            with open(path, encoding="utf-8", newline="") as stream:
                lines = stream.read().splitlines(keepends=True)
            if not any(not line.startswith("#") for line in lines):
                raise ValueError("no line of column names")
            sealed = seal_lines(lines)
            with open(path, "w", encoding="utf-8", newline="") as stream:
                stream.writelines(sealed)
        except (OSError, ValueError) as problem:
            print(f"seal.py: {path}: {problem}", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
