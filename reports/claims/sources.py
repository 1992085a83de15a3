"""The sources of the computed numbers: a command of pulloff, the record of a case, a reference table.

The output of a command is stored under a key of the program's bytes and the command. The command runs again only if
one of them changes.
"""

import concurrent.futures
import csv
import functools
import hashlib
import itertools
import json
import math
import os
import shlex
import subprocess
import threading
import time

import preloads


class SourceError(Exception):
    """The reason why a source has no number, in one line."""


def commands(source):
    """The command lines of a source: one, or one for every combination of the values of `each`."""
    keys = list(source.get("each", {}))
    combinations = itertools.product(*(source["each"][key] for key in keys))
    return [source["pulloff"].format(**dict(zip(keys, values))) for values in combinations]


@functools.lru_cache(maxsize=None)
def record_of(path):
    """The record of a case, which has its checksum (doc/json.md#checksums)."""
    with open(path, encoding="utf-8") as stream:
        first, second, rest = (stream.read().split("\n", 2) + ["", ""])[:3]
    digest = hashlib.sha256(f"{first}\n{rest}".encode()).hexdigest()
    if second != f'  "checksum": "{digest}",':
        raise SourceError(f"{path} was altered: it does not have its checksum")
    return json.loads(f"{first}\n{rest}")


def follow(document, path):
    """The value at a path of keys and indices separated by points; `*` is every item, `#` the number of items."""
    name, _, rest = path.partition(".")
    if not name:
        return document
    if name == "*" and isinstance(document, list):
        return [follow(item, rest) for item in document]
    if name == "#" and isinstance(document, list):
        return len(document)
    try:
        return follow(document[int(name)] if isinstance(document, list) else document[name], rest)
    except (KeyError, IndexError, TypeError, ValueError) as error:
        raise SourceError(f"there is no {path}") from error


def number(text):
    """A cell or a value as a number, or unchanged if it is no number."""
    try:
        return float(text)
    except (TypeError, ValueError):
        return text


def is_selected(when, value_of):
    """Whether a row or a point has the wanted values; numbers may differ by a relative 1e-9."""
    for key, wanted in when.items():
        found = number(value_of(key))
        choices = wanted if isinstance(wanted, list) else [wanted]
        if not any(math.isclose(found, choice, rel_tol=1e-9) if isinstance(found, float) and not isinstance(choice, str)
                   else found == number(choice) for choice in choices):
            return False
    return True


def rows_of(path):
    """The rows of a table, each a dictionary of its cells by column."""
    with open(path, encoding="utf-8") as stream:
        return list(csv.DictReader(line for line in stream if not line.startswith("#")))


def value_at(point, path, folder):
    """The value at a path of a point, or a column of its curve (`curve.load`) or of a line of its case (`line-guduru.load`)."""
    name, _, column = path.partition(".")
    if name != "curve" and not name.startswith("line-"):
        return follow(point, path)
    table = (point.get("curve") or "no curve") if name == "curve" else name + ".csv"
    try:
        return [float(row[column]) for row in rows_of(os.path.join(folder, table))]
    except (OSError, KeyError) as error:
        raise SourceError(f"{table}: {error}") from error


class Sources:
    """The data that claims are judged by: the program, the records of a run, and the reference data."""

    def __init__(self, program, run, tree, kept, paper=""):
        self.program, self.run, self.kept = program, run, kept
        self.trees = [paper, tree] if paper else [tree]   # a table is looked for in the folder of the paper first
        self.used = set()
        self.shared = {}    # what is read of commands that are not run (preloads.py)
        self.seconds = 0.0
        with open(program, "rb") as stream:
            self.digest = hashlib.sha256(stream.read()).hexdigest()

    def get(self, source):
        """(value, commands that compute it); the value is a number or a list."""
        if "pulloff" in source:
            found = [follow(self.document(line), source["at"]) for line in commands(source)]
            lines = ["pulloff " + line for line in commands(source)]
            return (found if "each" in source else found[0]), lines
        return self.of_table(source) if "table" in source else self.of_case(source)

    def path_of(self, line):
        """The file with the stored output of a command."""
        key = hashlib.sha256(f"{self.digest}\n{line}".encode()).hexdigest()
        return os.path.join(self.kept, key + ".json")

    def prepare(self, wanted):
        """Runs the commands of these sources, one on each core, but not those whose force the branch of another one gives. A failure
        is reported by get, which runs the command again."""
        paths = {}
        for source in wanted:
            for line in commands(source) if "pulloff" in source else ():
                paths.setdefault(line, []).append(source["at"])
        scenes = preloads.scenes(paths)
        with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
            made = [pool.submit(preloads.share, run, others, self.attempt) for run, others in scenes]
            for line in itertools.filterfalse(preloads.scene_of, paths):
                pool.submit(self.attempt, line)
        self.shared = {line: part for each in made for line, part in each.result().items()}

    def document(self, line):
        """The JSON document that a command prints, or what is read of it."""
        if line in self.shared:
            return self.shared[line]
        path = self.path_of(line)
        self.used.add(path)
        try:
            with open(path, encoding="utf-8") as stream:
                return json.load(stream)
        except (OSError, json.JSONDecodeError):
            return self.compute(line, path)

    def attempt(self, line):
        """The document of a command, None if it failed."""
        try:
            return self.document(line)
        except SourceError:
            return None

    def compute(self, line, path):
        begin = time.monotonic()
        done = subprocess.run([self.program, *shlex.split(line), "--json"], capture_output=True, text=True, check=False,
                              env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
        self.seconds += time.monotonic() - begin
        if done.returncode:
            raise SourceError(f"pulloff {line}: {done.stderr.strip() or f'exit code {done.returncode}'}")
        beside = f"{path}.{os.getpid()}.{threading.get_ident()}"
        with open(beside, "w", encoding="utf-8") as stream:
            stream.write(done.stdout)
        os.replace(beside, path)
        return json.loads(done.stdout)

    def forget_unused(self):
        """Removes stored outputs of other programs and of claims that no longer exist."""
        for name in os.listdir(self.kept):
            path = os.path.join(self.kept, name)
            if path not in self.used:
                os.unlink(path)

    def of_table(self, source):
        try:
            paths = [os.path.join(tree, source["table"]) for tree in self.trees]
            rows = rows_of(next((path for path in paths if os.path.exists(path)), paths[-1]))
            found = [number(row[source["column"]]) for row in rows if is_selected(source.get("when", {}), row.__getitem__)]
        except (OSError, KeyError) as error:
            raise SourceError(f"{source['table']}: {error}") from error
        return self.one_or_all(found, source, [source["table"]])

    def of_case(self, source, run=None):
        """The numbers of a case, from the records of this program or from those in another folder."""
        folder = os.path.join(run or self.run, source["case"])
        try:
            record = record_of(os.path.join(folder, "record.json"))
        except (OSError, json.JSONDecodeError) as error:
            raise SourceError(f"there is no record of case {source['case']}") from error
        points = [point for point in record["points"] if is_selected(
            source.get("when", {}), lambda key, p=point: p["sweep"].get(key, p["input"].get(key)))]
        solved = [point for point in points if point["status"] == "ok"]
        return self.one_or_all([value_at(point, source["at"], folder) for point in solved], source,
                               [point["command"] for point in solved[:1]] if len(points) == 1 else [record["command"]])

    @staticmethod
    def one_or_all(found, source, lines):
        name = source.get("table", source.get("case"))
        if not found:
            raise SourceError(f"{name}: nothing solved has {source.get('when', {})}")
        if source.get("all"):
            return found, lines
        if len(found) > 1:
            raise SourceError(f"{name}: {len(found)} rows have {source.get('when', {})}, expected one")
        return found[0], lines
