"""Reads the matrix of planted faults (see tests/mutation/README.md)."""

import os

from .records import demand, read_judgement

SCHEMA = "pulloff-faults/1"
PLACE = os.path.join("mutation", "matrix.json")  # beside the run's folder

MATRIX = {"detectors": list, "faults": list, "passes": bool}
DETECTOR = {"name": str, "kind": str, "title": str, "passes": bool, "catches": int}
FAULT = {"name": str, "kind": str, "what": str, "file": str, "cells": dict, "caught": bool, "problem": str}
CELL = {"by": list, "failing": int, "caught": bool}


def beside(run):
    """The path of the matrix that belongs to a run."""
    return os.path.join(os.path.dirname(os.path.abspath(run)), PLACE)


def read(path):
    """The matrix, or None when there is no such file."""
    matrix = read_judgement(path, SCHEMA)
    if matrix is None:
        return None
    demand(matrix, MATRIX, path, "")
    for place, detector in enumerate(matrix["detectors"]):
        demand(detector, DETECTOR, path, f"detectors[{place}]")
    for place, fault in enumerate(matrix["faults"]):
        demand(fault, FAULT, path, f"faults[{place}]")
        for name, cell in fault["cells"].items():
            demand(cell, CELL, path, f"faults[{place}].cells.{name}")
    return matrix
