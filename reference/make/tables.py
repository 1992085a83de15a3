"""Reference tables: CSV with a `# key: value` header and a checksum.

The value of `# sha256:` is the checksum of all other lines of the file, header
and rows, bytes as written.
"""

import hashlib
from pathlib import Path

STORED_FLOOR = 1e-10      # no stored uncertainty is smaller


def number(x):
    """15 significant digits: more than any value here is good for."""
    return f"{x:.15g}"


def bound(x):
    """An uncertainty, two digits."""
    return f"{max(x, STORED_FLOOR):.1e}"


def write_table(path, header, columns, rows):
    """rows are sequences of strings; written through a temporary file."""
    body = "\n".join([",".join(columns)] + [",".join(row) for row in rows]) + "\n"
    head = "".join(f"# {key}: {value}\n" for key, value in header.items())
    seal = f"# sha256: {hashlib.sha256((head + body).encode()).hexdigest()}\n"
    path = Path(path)
    partial = path.with_suffix(".partial")
    partial.write_text(head + seal + body)
    partial.replace(path)


def read_table(path):
    """(header, rows): rows are dictionaries of strings.  Checks the checksum."""
    lines = Path(path).read_text().splitlines(keepends=True)
    head = [line for line in lines if line.startswith("#")]
    header = dict(line[1:].strip().split(": ", 1) for line in head)
    body = lines[len(head):]
    sealed = [line for line in lines if not line.startswith("# sha256:")]
    if hashlib.sha256("".join(sealed).encode()).hexdigest() != header.get("sha256"):
        raise ValueError(f"{path}: header and rows do not match their sha256")
    columns = body[0].strip().split(",")
    return header, [dict(zip(columns, line.strip().split(","))) for line in body[1:]]
