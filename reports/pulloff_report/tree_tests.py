"""Reads how the tests of the tree ended when meson ran them last in the build folder of a run."""

import datetime
import json
import os

from .errors import ReportError
from .tables import read_text
from .words import date

PLACE = os.path.join("meson-logs", "testlog.json")  # beside the run's folder
PASSED, LEFT_OUT = ("OK", "EXPECTEDFAIL"), ("SKIP",)


def beside(run):
    """The path of the log that belongs to a run."""
    return os.path.join(os.path.dirname(os.path.abspath(run)), PLACE)


def read(path):
    """{passed, total, failed (names), date} of the tests that were not skipped; None if there are none."""
    if not path or not os.path.exists(path):
        return None
    try:
        entries = [json.loads(line) for line in read_text(path).splitlines() if line.strip()]
        entries = [(entry["name"], entry["result"], float(entry["starttime"])) for entry in entries]
    except (json.JSONDecodeError, KeyError, TypeError, ValueError) as error:
        raise ReportError(f"{path}: not a log of meson: {error}") from error
    made = [entry for entry in entries if entry[1] not in LEFT_OUT]
    if not made:
        return None
    failed = [name.split(":")[-1] for name, result, _ in made if result not in PASSED]
    begin = datetime.datetime.fromtimestamp(min(start for _, _, start in made), datetime.timezone.utc)
    return {"passed": len(made) - len(failed), "total": len(made), "failed": failed,
            "date": date(begin.strftime("%Y-%m-%dT%H:%M:%SZ"))}
