"""The digest of doc/json.md, by the Python function doc/examples/digest.py."""

import pathlib
import runpy

ROOT = pathlib.Path(__file__).resolve().parents[2]


def function():
    """The function `digest` of the example."""
    return runpy.run_path(str(ROOT / "doc/examples/digest.py"))["digest"]


def of_result(point, keys):
    """The digest of a point of a record: that of its keys that belong to a result. Given: the names of these keys."""
    return function()({key: value for key, value in point.items() if key in keys})
