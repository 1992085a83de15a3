"""Reads the records of a run. A record that cannot be read raises a ReportError of one line."""

import hashlib
import json
import os

from .errors import ReportError
from .tables import Table, read_text

SCHEMA = "pulloff-record/1"
NUMBER = (int, float, type(None))

# What a report needs of a record: key -> type, at each of its levels.
RECORD = {"case": str, "title": str, "suites": list, "command": str, "versions": dict,
          "environment": dict, "plan": list, "points": list, "checks": list, "verdict": str}
POINT = {"id": str, "label": str, "sweep": dict, "status": str, "failed": bool, "work": dict}
CHECK = {"id": str, "quantity": str, "obtained": NUMBER, "expected": NUMBER, "error": NUMBER,
         "kind": str, "tolerance": NUMBER, "ratio": NUMBER, "ledger": str, "verdict": str,
         "because": str}
LEFT_OUT = {"quantity": str, "reference": str, "stand_in": str}
VERDICTS = ("within", "outside", "no_result", "missing_reference", "slack", "not_reachable")
PASSING = ("within", "slack", "not_reachable")
NO_VERDICT = ("no_result", "missing_reference")
TYPE_NAMES = {str: "a string", bool: "true or false", int: "a whole number", list: "a list",
              dict: "an object", NUMBER: "a number or null"}


def demand(entry, wanted, path, where):
    """Raises a ReportError unless every wanted key is there with its type."""
    if not isinstance(entry, dict):
        raise ReportError(f"{path}: {where} is not an object")
    for key, kind in wanted.items():
        name = f"{where}.{key}" if where else key
        if key not in entry:
            raise ReportError(f"{path}: {name} is missing")
        if not isinstance(entry[key], kind) or (isinstance(entry[key], bool) and kind is not bool):
            raise ReportError(f"{path}: {name} is {json.dumps(entry[key])[:40]}, "
                              f"expected {TYPE_NAMES[kind]}")


def read_judgement(path, schema):
    """A JSON document with this schema; None when there is no such file."""
    if not path or not os.path.exists(path):
        return None
    try:
        document = json.loads(read_text(path))
    except json.JSONDecodeError as error:
        raise ReportError(f"{path}:{error.lineno}: not JSON: {error.msg}") from error
    found = document.get("schema") if isinstance(document, dict) else None
    if found != schema:
        raise ReportError(f'{path}: schema is {json.dumps(found)}, expected "{schema}"')
    return document


def has_checksum(text):
    """Whether the text of a record has its checksum, that of all lines but its own (doc/json.md#checksums)."""
    first, second, rest = (text.split("\n", 2) + ["", ""])[:3]
    digest = hashlib.sha256((first + "\n" + rest).encode()).hexdigest()
    return second == f'  "checksum": "{digest}",'


def record_of(folder):
    """The file with the record of a case: of all points, or of the points to which the run of an external solver was
    limited; None if there is neither."""
    paths = (os.path.join(folder, name) for name in ("record.json", "part.json"))
    return next((path for path in paths if os.path.isfile(path)), None)


class Case:
    """One case of a run: its record, and its curves and profiles, which are read on request."""

    def __init__(self, folder):
        self.folder = folder
        self.path = record_of(folder)
        text = read_text(self.path)
        try:
            record = json.loads(text)
        except json.JSONDecodeError as error:
            raise ReportError(f"{self.path}:{error.lineno}: not JSON: {error.msg} "
                              f"(column {error.colno})") from error
        self._check(record)
        if not has_checksum(text):
            raise ReportError(f"{self.path} was altered: it does not have its checksum ({record['command']} writes it again)")
        self.record = record
        self.name = record["case"]
        self.title = record["title"]
        self.figure = record.get("figure")
        self.figure_script = record.get("figure_script")
        self.points = record["points"]
        self.checks = record["checks"]
        self.left_out = record.get("left_out", [])
        self.verdict = record["verdict"]
        self.companion = None    # the same figure computed with the paper's discretisation, see Run.drawing
        self.any_preload = None  # the same figure at any preload, see Run.drawing
        self._lines = {line["name"]: line for line in record.get("lines", [])}
        self._points = {point["id"]: point for point in self.points}

    def _check(self, record):
        if not isinstance(record, dict) or record.get("schema") != SCHEMA:
            found = record.get("schema") if isinstance(record, dict) else None
            raise ReportError(f"{self.path}: schema is {json.dumps(found)}, "
                              f'expected "{SCHEMA}"')
        demand(record, RECORD, self.path, "")
        for place, point in enumerate(record["points"]):
            demand(point, POINT, self.path, f"points[{place}]")
        for place, check in enumerate(record.get("left_out", [])):
            demand(check, LEFT_OUT, self.path, f"left_out[{place}]")
        for place, check in enumerate(record["checks"]):
            demand(check, CHECK, self.path, f"checks[{place}]")
            if check["verdict"] not in VERDICTS:
                raise ReportError(f"{self.path}: checks[{place}].verdict is "
                                  f"{json.dumps(check['verdict'])}, expected one of "
                                  + ", ".join(VERDICTS))

    def point(self, identifier):
        """The point with this id; None for a check that belongs to no single point."""
        return self._points.get(identifier)

    def curve(self, point):
        """The branch of a point as a Table, or None when none was asked for."""
        return self._table(point, "curve")

    def profile(self, point):
        """The profile of a point as a Table, or None when none was asked for."""
        return self._table(point, "profile")

    def line(self, name):
        """A closed-form solution along a sweep as a Table, or None when the case has no such line."""
        return self._table(self._lines.get(name, {}), "table")

    def _table(self, entry, key):
        if not entry.get(key):
            return None
        table = Table(os.path.join(self.folder, entry[key]))
        if table.digest() != entry.get(key + "_sha256"):
            raise ReportError(f"{table.path} was altered: it does not have the checksum that its record states "
                              f"({self.record['command']} writes it again)")
        return table

    def count(self, *verdicts):
        return sum(check["verdict"] in verdicts for check in self.checks)

    def unsolved_points(self):
        return [point for point in self.points if point["status"] != "ok"]

    def failed_points(self):
        """Points whose solve failed. Failures within the fraction that the case permits are not counted."""
        return [point for point in self.points if point["failed"]]

    def worst(self):
        """The largest |error| relative to its tolerance, or None."""
        ratios = [check["ratio"] for check in self.checks if check["ratio"] is not None]
        return max(ratios) if ratios else None


class Run:
    """All cases of a run folder: first those of the paper's figures, by number, then the others, by name."""

    def __init__(self, folder):
        self.folder = folder
        try:
            names = sorted(os.listdir(folder))
        except OSError as error:
            raise ReportError(f"{folder}: {error.strerror}") from error
        folders = [os.path.join(folder, name) for name in names]
        self.cases = [Case(place) for place in folders
                      if record_of(place)]
        if not self.cases:
            raise ReportError(f"{folder}: no complete record of this program of any case (pulloff run CASE --output "
                              f"{folder} makes it; records of other solvers are shown beside it)")
        self.cases.sort(key=reading_order)

    @property
    def is_of_paper(self):
        """Whether a case belongs to a figure of the paper. A run without such a case is one of the user's own cases."""
        return any(case.figure for case in self.cases)

    def drawing(self, script):
        """The cases that name this figure script.

        A case whose name ends in _paper or _any is attached to the case without that ending: the same figure with
        the paper's discretisation (companion), and at any preload (any_preload).
        """
        found = [case for case in self.cases if case.figure_script == script]
        names = {case.name: case for case in found}
        for case in found:
            case.companion = names.get(case.name + "_paper")
            case.any_preload = names.get(case.name + "_any")
        return [case for case in found if not any(
            case.name.endswith(end) and case.name[:-len(end)] in names for end in ("_paper", "_any"))]

    def checks(self):
        return [check for case in self.cases for check in case.checks]


def reading_order(case):
    """Figures of the paper by number, then the rest by name."""
    digits = "".join(ch for ch in str(case.figure or "") if ch.isdigit())
    return (0, int(digits), case.name) if digits else (1, 0, case.name)
