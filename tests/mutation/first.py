"""Which detectors are run first with each fault: the file first.toml."""

import os
import tomllib

NAME = "first.toml"
HEAD = """\
# The detectors that are run first with each fault, all of them: the one that catches it at the least processor time, and
# those that catch no other fault of this list, so that every detector shows that it can fail.
# Written by: python3 tests/mutation/run.py --build build --all --write
"""


def read(path):
    """Names of detectors by the name of a fault; empty if there is no such file."""
    if not os.path.exists(path):
        return {}
    with open(path, "rb") as stream:
        return tomllib.load(stream)


def seconds_of(row, detector):
    return row["cells"][detector]["seconds"]


def choose(matrix):
    """Names of detectors by the name of a fault, from a matrix of all detectors and all faults."""
    chosen = {}
    for row in matrix["faults"]:
        caught = [name for name, cell in row["cells"].items() if cell["caught"]]
        if caught:
            chosen[row["name"]] = [min(caught, key=lambda name, row=row: seconds_of(row, name))]
    used = {name for names in chosen.values() for name in names}
    for name in [detector["name"] for detector in matrix["detectors"] if detector["name"] not in used]:
        rows = [row for row in matrix["faults"] if row["cells"].get(name, {}).get("caught")]
        if rows:
            chosen[min(rows, key=lambda row, name=name: seconds_of(row, name))["name"]].append(name)
    return chosen


def write(path, matrix):
    lines = [f"{fault} = [{', '.join(f'{chr(34)}{name}{chr(34)}' for name in names)}]"
             for fault, names in choose(matrix).items()]
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(HEAD + "\n" + "\n".join(lines) + "\n")
