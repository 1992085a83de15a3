"""Strict reading of the CSV files of a run and of the reference data."""

import csv
import hashlib
import math

import numpy

from .errors import ReportError


def read_text(path):
    """The text of a file, or a ReportError that names it."""
    try:
        with open(path, encoding="utf-8", newline="") as stream:
            return stream.read()
    except OSError as error:
        raise ReportError(f"{path}: {error.strerror or error}") from error
    except UnicodeDecodeError as error:
        raise ReportError(f"{path}: not a text file (byte {error.start})") from error


class Table:
    """A CSV file: `# key: value` lines, a row of column names, rows of cells."""

    def __init__(self, path):
        self.path = path
        self.header = {}
        self.columns = {}
        lines = read_text(path).splitlines(keepends=True)
        self._sealed = "".join(line for line in lines if not line.startswith("# sha256:"))
        lines[:1] = [line.removeprefix("\ufeff") for line in lines[:1]]    # a byte order mark
        start = 0
        while start < len(lines) and lines[start].startswith("#"):
            self._read_header(lines[start])
            start += 1
        self._read_rows(lines[start:], start + 1)

    def _read_header(self, line):
        key, colon, value = line.lstrip("#").partition(":")
        if colon:
            self.header.setdefault(key.strip(), value.strip())

    def _read_rows(self, lines, first):
        rows = [[cell.strip() for cell in row] for row in csv.reader(lines, skipinitialspace=True)]
        if not rows or not rows[0]:
            raise ReportError(f"{self.path}:{first}: no row of column names")
        names = rows[0]
        for offset, row in enumerate(rows[1:], start=1):
            if any(row) and len(row) != len(names):
                raise ReportError(f"{self.path}:{first + offset}: {len(row)} cells, "
                                  f"expected {len(names)}")
        cells = [row for row in rows[1:] if any(row)]
        self.rows = len(cells)
        self.columns = {name: [row[place] for row in cells] for place, name in enumerate(names)}

    def numbers(self, name):
        """A column as an array of numbers; an empty cell is NaN."""
        if name not in self.columns:
            raise ReportError(f"{self.path}: no column named {name}")
        values = numpy.empty(self.rows)
        for place, cell in enumerate(self.columns[name]):
            try:
                values[place] = float(cell) if cell.strip() else math.nan
            except ValueError as error:
                raise ReportError(f"{self.path}: row {place + 1}: {name} is {cell!r}, "
                                  "expected a number") from error
        return values

    def digest(self):
        """sha256 of all lines except the one that states it."""
        return hashlib.sha256(self._sealed.encode("utf-8")).hexdigest()

    def digest_state(self):
        """Whether the data have the checksum that the header states: verified, differs, or absent."""
        stated = self.header.get("sha256")
        if stated is None:
            return "absent"
        return "verified" if stated.lower() == self.digest() else "differs"
