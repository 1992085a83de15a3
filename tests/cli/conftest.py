"""Functions for the tests of the command line in Python, which run in a folder of their own:
pytest FILE --program PROGRAM"""

import csv
import dataclasses
import fnmatch
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess

import pytest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PROGRAM = None  # its path, see pytest_configure
PROGRESS = re.compile(r"^\d+/\d+ [a-z]*, .* elapsed.*\n", re.MULTILINE)  # a slow machine prints such lines


def pytest_addoption(parser):
    parser.addoption("--program", required=True, help="the program pulloff")
    parser.addoption("--few", action="store_true", help="no test with the mark `once`, and of each other test only the first of its "
                     "parameters, and all messages: for a build in which tests are slow, and in which only the lines count that are run")


def pytest_configure(config):
    global PROGRAM
    PROGRAM = os.path.abspath(config.getoption("--program"))
    config.addinivalue_line("markers", "once: runs no line of src that no other test runs (measured by llvm-cov)")


def pytest_collection_modifyitems(config, items):
    if config.getoption("--few"):
        first = {}
        items[:] = [item for item in items if not item.get_closest_marker("once") and (
            first.setdefault((item.path, item.originalname), item) is item or "message" in item.callspec.params)]


@dataclasses.dataclass
class Ended:
    """What the program left: exit code, standard output, and standard error without lines of progress."""
    code: int
    out: str
    err: str

    @property
    def json(self):
        return json.loads(self.out)

    def count(self, pattern):
        """The number of lines of the output in which the pattern is."""
        return sum(bool(re.search(pattern, line)) for line in self.out.splitlines())

    def has(self, *patterns):
        """Each of these patterns must be in a line of the output."""
        for pattern in patterns:
            assert self.count(pattern), f"no line {pattern}: {self.out}{self.err}"
        return self


def words_of(words, *more):
    """The program with the words of a command line, and more of them as they are."""
    return [PROGRAM, *shlex.split(words), *map(str, more)]


def run(words, *more, **options):
    """Runs the program. The options are those of subprocess.run."""
    done = subprocess.run(words_of(words, *more), capture_output=True, text=True, errors="surrogateescape", **options)
    return Ended(done.returncode, done.stdout, PROGRESS.sub("", done.stderr))


def matches(text, pattern):
    """Whether a line is as a shell pattern says, in which brackets stand for themselves."""
    return fnmatch.fnmatchcase(text.rstrip("\n"), pattern.replace("[", "[[]"))


def expect(code, message, words, *more, **options):
    """The same; the exit code must be this one, and standard error one line (a shell pattern; "": nothing; None: anything)."""
    ended = run(words, *more, **options)
    assert ended.code == code, f"pulloff {words}: exit code {ended.code}, expected {code}: {ended.err}"
    assert not message or ended.err.count("\n") == 1, f"pulloff {words}: expected one line: {ended.err}"
    assert message is None or matches(ended.err, message), f"pulloff {words}: {ended.err}expected: {message}"
    return ended


def edit(path, *changes):
    """Changes a text file. changes: pairs of a text, which must occur, and what replaces its first occurrence."""
    text = pathlib.Path(path).read_text()
    for old, new in zip(changes[::2], changes[1::2], strict=True):
        assert old in text, f"{path} has no {old}: {text}"
        text = text.replace(old, new, 1)
    pathlib.Path(path).write_text(text)


def document(words, *more):
    """The JSON document of a command that must succeed without a message."""
    return expect(0, "", words, *more, "--json").json


def load(path):
    return json.loads(pathlib.Path(path).read_text())


def rows_of(path):
    """The rows of a table, each as texts by column."""
    return list(csv.DictReader(line for line in pathlib.Path(path).read_text().splitlines() if not line.startswith("#")))


def agree(a, b, value, error="error_estimate", times=1.0):
    """Two results differ by at most so many times the sum of their stated errors."""
    assert abs(a[value] - b[value]) <= times * (a[error] + b[error]), (value, a, b)


def seal(path):
    """Writes the checksum of a table above the line of its column names."""
    lines = [line for line in path.read_text().splitlines(True) if not line.startswith("# sha256:")]
    digest = hashlib.sha256("".join(lines).encode()).hexdigest()
    place = next(k for k, line in enumerate(lines) if not line.startswith("#"))
    path.write_text("".join(lines[:place] + [f"# sha256: {digest}\n"] + lines[place:]))


HEADER = """# what: made for a test
# source: by hand
# kind: oracle
# method: closed form
# units: those of the harness
# uncertainty: 0
# generator: none
# command: none
# date: 2026-11-21
"""


class Data:
    """A data folder: cases and reference tables, at first a table of the rigid sphere."""

    def __init__(self, folder):
        self.folder, self.file = folder, folder / "cases/good.yaml"
        for name in ("cases", "reference"):
            (folder / name).mkdir(parents=True)
        self.table("reference/table.csv", "tabor,force,approach", "0,2,0")
        (folder / "reference/index.txt").write_text("table.csv\n")

    def case(self, name, text):
        path = self.folder / "cases" / f"{name}.yaml"
        path.write_text(text.lstrip("\n"))
        return path

    def table(self, name, *rows, uncertainty="0"):
        """A table with a correct header. rows: that of the column names, and the others."""
        path = self.folder / name
        path.write_text(HEADER.replace("uncertainty: 0", f"uncertainty: {uncertainty}") + "".join(row + "\n" for row in rows))
        seal(path)
        return path


@pytest.fixture(autouse=True)
def _in_its_folder(tmp_path, monkeypatch):
    (tmp_path / "work").mkdir()
    monkeypatch.chdir(tmp_path / "work")


@pytest.fixture
def data(tmp_path, monkeypatch):
    made = Data(tmp_path / "data")
    monkeypatch.setenv("PULLOFF_DATA", str(made.folder))
    return made


@pytest.fixture
def good(data):
    """A data folder with one correct case, which is solved quickly, to be damaged."""
    data.case("good", """
name: good
title: A rigid sphere
suites: [smoke]
scene:
  tabor: 0
  amplitude: 0
  radius: 100
  outer_radius: inf
  scheme: triangle
  nodes: 101
want: [pull_off]
checks:
  - quantity: pull_off_force
    reference: reference/table.csv
    tolerance: 1e-9
    kind: abs
    because: it has a closed form
""")
    return data
