"""Reference tables: CSV with a `# key: value` header and a checksum.

The value of `# sha256:` is the checksum of everything below the header (the
line of column names and the data lines), bytes as written.
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
    digest = hashlib.sha256(body.encode()).hexdigest()
    head = "".join(f"# {key}: {value}\n" for key, value in {**header, "sha256": digest}.items())
    path = Path(path)
    partial = path.with_suffix(".partial")
    partial.write_text(head + body)
    partial.replace(path)


def read_table(path):
    """(header, rows): rows are dictionaries of strings.  Checks the checksum."""
    lines = Path(path).read_text().splitlines(keepends=True)
    head = [line for line in lines if line.startswith("#")]
    header = dict(line[1:].strip().split(": ", 1) for line in head)
    body = lines[len(head):]
    if hashlib.sha256("".join(body).encode()).hexdigest() != header.get("sha256"):
        raise ValueError(f"{path}: the data do not match their sha256")
    columns = body[0].strip().split(",")
    return header, [dict(zip(columns, line.strip().split(","))) for line in body[1:]]
