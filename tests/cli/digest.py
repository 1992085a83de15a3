"""The digest of doc/json.md, by the Python function that is printed there."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]


def function():
    """The function `digest` of doc/json.md."""
    text = (ROOT / "doc/json.md").read_text()
    code = re.search(r"^```python\n(import hashlib\n.*?)^```$", text, re.M | re.S)[1]
    names = {}
    exec(compile(code, "doc/json.md", "exec"), names)  # pylint: disable=exec-used
    return names["digest"]


def of_result(point, keys):
    """The digest of a point of a record: that of its keys that belong to a result. Given: the names of these keys."""
    return function()({key: value for key, value in point.items() if key in keys})
