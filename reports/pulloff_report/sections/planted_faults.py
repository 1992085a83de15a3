"""Planted faults: which case or test detects which fault of the program."""

from . import Section
from ..words import count

ABSENT = "planted faults (./reproduce --only faults)"

# Letter of a cell, by the kind of failure; the first that applies.
SIGNS = {"oracle": "O", "test": "T", "no_result": "N", "refused": "R", "pin": "P", "timeout": "L"}
MEANINGS = {"O": "a number is outside the tolerance of an oracle or a published value",
            "T": "a test or the comparison with a table fails", "N": "solves fail",
            "R": "the program ends with an error", "P": "only a pin changed", "L": "stopped at the time limit",
            "·": "passes in spite of the fault"}
KINDS = {"physics": "Faults in the physics and the mathematics", "harness": "Faults in the harness"}


def cell(detector, fault):
    """(letter, class) of one cell of the matrix; empty if the detector was not run with this fault."""
    found = fault["cells"].get(detector["name"])
    if found is None:
        return "", ""
    letter = next((sign for by, sign in SIGNS.items() if by in found["by"]), "·")
    return letter, "caught" if found["caught"] else "seen" if found["by"] else "missed"


def cells(matrix, fault):
    """(letter, class, columns) of the cells of a row; neighbouring empty cells are one, since most of the matrix is empty."""
    made = []
    for detector in matrix["detectors"]:
        letter, kind = cell(detector, fault)
        if made and not letter and not made[-1][0]:
            made[-1] = ("", "", made[-1][2] + 1)
        else:
            made.append((letter, kind, 1))
    return made


def groups(matrix):
    made = []
    for kind, title in KINDS.items():
        rows = [{"fault": fault, "cells": cells(matrix, fault)}
                for fault in matrix["faults"] if fault["kind"] == kind]
        if rows:
            made.append({"title": title, "rows": rows})
    return made


def verdict(matrix):
    """One sentence: how many faults are detected, and which are not."""
    missed = [fault["name"] for fault in matrix["faults"] if not fault["caught"]]
    idle = [detector["name"] for detector in matrix["detectors"] if not detector["catches"]]
    broken = [detector["name"] for detector in matrix["detectors"] if not detector["passes"]]
    parts = [f"{len(matrix['faults']) - len(missed)} of {count(len(matrix['faults']), 'planted fault')} were detected"]
    parts += [f"not detected: {', '.join(missed)}"] if missed else []
    parts += [f"detectors that detect no fault: {', '.join(idle)}"] if idle else []
    parts += [f"detectors that fail without a fault: {', '.join(broken)}"] if broken else []
    return "; ".join(parts) + "."


def build(source):
    matrix = source.faults
    data = {}
    if matrix:
        rows = groups(matrix)
        used = {letter for group in rows for row in group["rows"] for letter, _, _ in row["cells"]}
        data = {"matrix": matrix, "groups": rows, "verdict": verdict(matrix),
                "legend": [(sign, text) for sign, text in MEANINGS.items() if sign in used]}
    return Section("planted-faults", "Planted faults", "planted_faults.html", data, absent="" if matrix else ABSENT,
                   on_paper=False, omitted_words="which case or test detects which planted fault")
