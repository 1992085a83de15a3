"""Planted faults: which case or test notices which fault of the program."""

from . import Section
from ..words import count

ABSENT = ("Whether the checks would notice a fault was not tried for this run: meson test -C build --suite mutation plants "
          "faults in the program, one at a time, and the next report shows what caught which.")

# Letter of a cell, by what failed; the first that applies.
SIGNS = {"oracle": "O", "test": "T", "no_result": "N", "refused": "R", "pin": "P", "timeout": "L"}
MEANINGS = {"O": "a number is outside the tolerance of an oracle or a published value",
            "T": "a test, or the comparison with a table, fails", "N": "solves fail",
            "R": "the program refuses or breaks off", "P": "only a pin moved", "L": "too late: stopped",
            "·": "passed, the fault was not noticed"}
KINDS = {"physics": "In the physics and the mathematics", "harness": "In the harness"}


def cell(detector, fault):
    """(letter, class) of one place of the matrix; nothing where the detector was not set at the fault."""
    found = fault["cells"].get(detector["name"])
    if found is None:
        return "", ""
    letter = next((sign for by, sign in SIGNS.items() if by in found["by"]), "·")
    return letter, "caught" if found["caught"] else "seen" if found["by"] else "missed"


def groups(matrix):
    made = []
    for kind, title in KINDS.items():
        rows = [{"fault": fault, "cells": [cell(detector, fault) for detector in matrix["detectors"]]}
                for fault in matrix["faults"] if fault["kind"] == kind]
        if rows:
            made.append({"title": title, "rows": rows})
    return made


def verdict(matrix):
    """One sentence: all caught, or what was not."""
    missed = [fault["name"] for fault in matrix["faults"] if not fault["caught"]]
    idle = [detector["name"] for detector in matrix["detectors"] if not detector["catches"]]
    broken = [detector["name"] for detector in matrix["detectors"] if not detector["passes"]]
    parts = [f"{len(matrix['faults']) - len(missed)} of {count(len(matrix['faults']), 'planted fault')} were caught"]
    parts += [f"nobody caught {', '.join(missed)}"] if missed else []
    parts += [f"caught nothing: {', '.join(idle)}"] if idle else []
    parts += [f"failed without any fault: {', '.join(broken)}"] if broken else []
    return "; ".join(parts) + "."


def build(source):
    matrix = source.faults
    data = {"absent": ABSENT, "matrix": None}
    if matrix:
        rows = groups(matrix)
        used = {letter for group in rows for row in group["rows"] for letter, _ in row["cells"]}
        data = {"absent": None, "matrix": matrix, "groups": rows, "verdict": verdict(matrix),
                "legend": [(sign, text) for sign, text in MEANINGS.items() if sign in used]}
    return Section("planted-faults", "Planted faults", "planted_faults.html", data)
