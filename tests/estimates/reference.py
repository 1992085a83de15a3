"""Converts the tables of the independent solver (reference/) to documents as of `pulloff solve --json`."""

import csv
import math
import os

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "reference")
FOLDS = ("jump_in", "jump_out")
SMOOTH_RADIUS = 100.0     # the tables of smooth spheres do not depend on the radius


def rows(name):
    with open(os.path.join(FOLDER, name), encoding="utf-8") as stream:
        return list(csv.DictReader(line for line in stream if not line.startswith("#")))


def smooth(row):
    """The flags of a row of feng_*.csv, and the unit of its contact radius."""
    return (("tabor", row["tabor"]), ("radius", f"{SMOOTH_RADIUS:g}"), ("outer-radius", "inf")), math.sqrt(SMOOTH_RADIUS)


def wavy(row):
    return tuple((key.replace("_", "-"), row[key])
                 for key in ("tabor", "amplitude", "wavelength", "radius", "outer_radius")), 1.0


def special_point(row, radius, unit):
    return {"kind": row["kind"], "approach": float(row["approach"]), "load": float(row["load"]),
            "error_estimate": float(row["approach_uncertainty"]), "load_error_estimate": float(row["load_uncertainty"]),
            "contact_radius": unit * float(row[radius]),
            "contact_radius_error_estimate": unit * float(row[f"{radius}_uncertainty"]),
            "position": float(row["index"])}


def add_tables(prefix, flags_of, radius, documents):
    for row in rows(f"{prefix}_landmarks.csv"):
        flags, unit = flags_of(row)
        document = documents.setdefault(flags, {"status": "ok", "folds": [], "extrema": [], "start": -math.inf,
                                                "end": float(row.get("complete_to", math.inf))})
        document["folds" if row["kind"] in FOLDS else "extrema"].append(special_point(row, radius, unit))
    for row in rows(f"{prefix}_pull_off.csv"):
        flags, unit = flags_of(row)
        documents[flags]["pull_off"] = {
            "force": float(row["force"]), "approach": float(row["approach"]),
            "error_estimate": float(row["force_uncertainty"]),
            "approach_error_estimate": float(row["approach_uncertainty"]), "contact_radius": unit * float(row[radius]),
            "contact_radius_error_estimate": unit * float(row[f"{radius}_uncertainty"])}


def documents():
    """(flags of the scene, document) of every scene of the tables."""
    found = {}
    add_tables("feng", smooth, "contact_radius_over_root_radius", found)
    add_tables("wavy", wavy, "contact_radius", found)
    return [({key: value if value == "inf" else float(value) for key, value in flags}, document)
            for flags, document in found.items()]
