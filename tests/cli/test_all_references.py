"""Tests every reference table of the source tree, even one that no case uses. If it is deleted, truncated, or one digit is altered,
the program detects it and names the table."""

import os
import re
import shutil

import pytest
from conftest import ROOT, expect, run


@pytest.fixture
def tables(data):
    """The tables in a data folder; of the cases one, because the list reads every case and takes most of its time for that."""
    shutil.rmtree(data.folder / "reference")
    shutil.copytree(ROOT / "reference", data.folder / "reference", ignore=shutil.ignore_patterns("make"))
    shutil.copy(ROOT / "cases/smoke.yaml", data.folder / "cases")
    return sorted((data.folder / "reference").glob("*.csv"))


def body(lines):
    """The number of the line with the names of the columns."""
    return next(k for k, line in enumerate(lines) if not line.startswith("#"))


def altered_digit(lines):
    """One digit, in the last number of a row in the middle."""
    middle = (body(lines) + len(lines)) // 2
    digit = [found.start() for found in re.finditer(r"\d", lines[middle])][-1]
    line = lines[middle]
    return [*lines[:middle], line[:digit] + str((int(line[digit]) + 1) % 10) + line[digit + 1:], *lines[middle + 1:]]


def without_last_cell(line):
    return re.sub(",[^,]*$", "\n", line)


def each(pattern, new):
    return lambda lines: [re.sub(pattern, new, line) for line in lines]


DAMAGES = {"sha256 is .*: expected ": lambda lines: lines[:-1],
           "the row has .* cell.*: expected ": lambda lines: [*lines[:-1], without_last_cell(lines[-1])],
           "the last line has no newline: the file is truncated": lambda lines: [*lines[:-1], lines[-1][:-2]]}
OF_CHECKSUM = [lambda lines: [*lines[:body(lines)], *map(without_last_cell, lines[body(lines):])], altered_digit,
               each("^(# uncertainty.*): ", r"\1: 0"), each("^# kind: oracle", "# kind: published")]


def test_damages(tables):
    shown = expect(0, "", "list --references")
    assert shown.count("not in the index") == 0 and len(tables) >= 12
    for says, change in [*DAMAGES.items(), *(("sha256 is ", change) for change in OF_CHECKSUM), ("No such file or directory", None)]:
        for path in tables:
            lines = (ROOT / "reference" / path.name).read_text().splitlines(True)
            if change:
                path.write_text("".join(change(lines)))
            else:
                path.unlink()
        assert expect(4, "pulloff: *", "list --references").count(rf"^reference/[a-z0-9_]*\.csv .*damaged: .*{says}") == len(tables), says


def test_what_verify_reads(data, tables):
    """Without a case, verify checks all tables before it solves anything. With a case, it checks the tables of the case."""
    folder = data.folder / "reference"
    struve = (folder / "struve.csv").read_text()
    (folder / "struve.csv").write_text("".join(struve.splitlines(True)[:-1]))
    expect(4, "pulloff: reference/struve.csv:*: sha256 is *", "verify --suite smoke --output out")
    assert not os.path.exists("out")
    run("verify smoke --output out")
    assert os.path.exists("out/smoke/record.json"), "a case that does not use it is run"
    (folder / "kernel.csv").unlink()
    expect(4, "pulloff: *reference/kernel.csv cannot be opened: * (and 1 more: *", "verify --suite smoke --output out2")
    index = (folder / "index.txt").read_text()
    (folder / "index.txt").unlink()
    expect(4, "pulloff: *reference/index.txt cannot be opened: *", "list --references")
    for name, text in (("index.txt", index), ("struve.csv", struve), ("mine.csv", struve)):
        (folder / name).write_text(text)
    shutil.copy(ROOT / "reference/kernel.csv", folder)
    expect(0, "", "list --references").has("^reference/mine.csv .*not in the index")
