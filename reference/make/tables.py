"""Reference tables: CSV with a `# key: value` header and a checksum.

The value of `# sha256:` is the checksum of all other lines of the file, header
and rows, bytes as written.
"""

import hashlib
from pathlib import Path

SEAL = "# sha256:"
STORED_FLOOR = 1e-10      # no stored uncertainty is smaller


def number(x):
    """A number with 15 significant digits, more than the accuracy of any value."""
    return f"{x:.15g}"


def bound(x):
    """An uncertainty, with two digits."""
    return f"{max(x, STORED_FLOOR):.1e}"


def checksum(lines):
    """The checksum of all lines except the one that states it."""
    text = "".join(line for line in lines if not line.startswith(SEAL))
    return hashlib.sha256(text.encode()).hexdigest()


def seal_lines(lines):
    """The lines with the correct checksum above the line of column names."""
    lines = [line for line in lines if not line.startswith(SEAL)]
    place = next(i for i, line in enumerate(lines) if not line.startswith("#"))
    return lines[:place] + [f"{SEAL} {checksum(lines)}\n"] + lines[place:]


def write_table(path, header, columns, rows):
    """Writes a table by way of a temporary file. Rows are sequences of strings."""
    body = "\n".join([",".join(columns)] + [",".join(row) for row in rows]) + "\n"
    head = "".join(f"# {key}: {value}\n" for key, value in header.items())
    path = Path(path)
    partial = path.with_suffix(".partial")
    partial.write_text("".join(seal_lines((head + body).splitlines(keepends=True))))
    partial.replace(path)


def read_table(path):
    """Reads a table and verifies its checksum. Returns (header, rows); rows are dictionaries of strings."""
    lines = Path(path).read_text().splitlines(keepends=True)
    head = [line for line in lines if line.startswith("#")]
    header = dict(line[1:].strip().split(": ", 1) for line in head)
    body = lines[len(head):]
    if checksum(lines) != header.get("sha256"):
        raise ValueError(f"{path}: header and rows do not match their sha256")
    columns = body[0].strip().split(",")
    return header, [dict(zip(columns, line.strip().split(","))) for line in body[1:]]
