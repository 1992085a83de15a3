#!/usr/bin/python3
"""Writes doc/constants.md from constants.toml, the source and doc/constants.csv.

    document.py            writes it
    document.py --check    exit code 1 if the document differs"""

import csv
import os
import sys

import measure
import scan

DOCUMENT = os.path.join(measure.ROOT, "doc", "constants.md")
SEEN = 0.02             # relative change of the work that is stated
LARGER = 1.2            # ratio of an error that is stated
HEAD = """# The constants

This page lists every named constant of the modules that compute. `tests/constants/document.py` writes it; a test compares it with the source and with the measurements in `constants.csv`. [The method](method.md) explains what the constants are for.

`tests/constants/measure.py` halves and doubles each value in a copy of the source, builds the copy, and runs a fixed set of commands: 100 random scenes on panels, stiff scenes, other preloads, rings and triangles, rigid scenes, series of scenes and closed forms ([the set and the measure](../tests/constants/README.md)). Errors are differences from solutions at a tolerance of 1e-8.

Kinds: *tuned*: chosen by measurement, or freely within a range; *limit*: a bound of a loop or of memory, or a guard; *derived*: follows from mathematics, rounding or another number; *stated*: what the program declares to its user. Derived and stated constants are not measured.

The last two columns say what half and twice the value do:

| entry | meaning |
|---|---|
| – | no digit of any result and no counter changes |
| work | counted floating-point operations of the whole set; left out if the change is below 2 % |
| lost, spurious | special points that are missing, or too many, compared with the unchanged source |
| violated, held | change of the number of stated errors that are violated, or shown to hold |
| median error, worst error | errors of the pull-off forces, as a ratio to those of the unchanged source |
| energy | largest error of an energy lost, as such a ratio |
| others move | largest relative change of results that have no tolerance: rings, triangles, rigid scenes, closed forms, diagnostics |
| less than 2 % | something changes, but none of the above |
| a value in parentheses | was tried in place of half or twice the value |

"""


def rows():
    with open(measure.CSV, encoding="utf-8", newline="") as stream:
        return {(row["file"], row["name"], row["value"], row["side"]): row
                for row in csv.DictReader(line for line in stream if not line.startswith("#"))}


def effect(row, base):
    """A few words on one row."""
    if row is None:
        return "not measured"
    if row["failed"] == "not built":
        return "does not build"
    if not int(row["changed"]):
        return "–"
    words = []
    work = float(row["work_ratio"]) - 1.0
    if abs(work) >= SEEN:
        words.append(f"work {100.0 * work:+.0f} %".replace("-", "−"))
    for key, text in (("failed", "failed"), ("lost", "lost"), ("extra", "spurious"), ("violated", "violated"),
                      ("held", "held")):
        more = int(row[key]) - int(base[key])
        if more:
            words.append(f"{text} {more:+d}".replace("-", "−"))
    for key, text in (("median_error", "median error"), ("worst_error", "worst error"), ("worst_energy", "energy")):
        ratio = float(row[key]) / float(base[key])
        if not 1.0 / LARGER < ratio < LARGER:
            words.append(f"{text} ×{ratio:.2g}")
    if row["moved"] == "inf":
        words.append("others lose or gain results")
    elif float(row["moved"]) > 1e-9:
        words.append(f"others move {float(row['moved']):.0e}")
    return ", ".join(words) if words else "less than 2 %"


def is_small(row, base):
    """Whether a row has less work changed than is told, and the same failures, special points and violations."""
    return row["failed"] == base["failed"] and abs(float(row["work_ratio"]) - 1.0) < SEEN and all(
        int(row[key]) <= int(base[key]) for key in ("lost", "extra", "violated"))


def tuned(results):
    """(entry, its two rows) of the tuned constants that are measured."""
    for entry in measure.table():
        pair = [row for (file, name, _, _), row in results.items() if (file, name) == (entry["file"], entry["name"])]
        if entry["kind"] == "tuned" and len(pair) == 2:
            yield entry, pair


def idle(results):
    """Tuned constants that change nothing on this set."""
    return [entry for entry, pair in tuned(results) if all(row["changed"] == "0" for row in pair)]


def summary(results, base):
    """How many of the tuned constants matter on this set."""
    none, pairs = idle(results), list(tuned(results))
    small = sum(entry not in none and all(is_small(row, base) for row in pair) for entry, pair in pairs)
    return (f"Of {len(pairs)} tuned constants {len(none)} change nothing on this set, neither at half nor at twice the "
            f"value: they concern rare scenes, such as a trace that is repeated on a larger domain or a search that ends "
            f"by its effort. The table says which, and which test fails when the constant is taken away. {small} others "
            f"change the work by less than 2 %, lose no special point and violate no stated error.\n")


def lines():
    """The page."""
    places, results = scan.constants(measure.ROOT), rows()
    base = results[measure.UNCHANGED]
    yield HEAD
    yield (f"The unchanged source, on {base['scenes']} commands: median error of the pull-off force "
           f"{base['median_error']} tolerances, worst {base['worst_error']}; of {base['stated']} stated errors "
           f"{base['held']} hold and {base['violated']} are violated (the others cannot be decided by the tight "
           f"solution); special points lost: {base['lost']}, spurious: {base['extra']}; largest error of an "
           f"energy lost {base['worst_energy']} tolerances.\n")
    yield "\n" + summary(results, base)
    module = None
    for entry in measure.table():
        value, path = places[entry["file"], entry["name"]][:2]
        here = os.path.relpath(path, measure.ROOT)
        if entry["file"] != module:
            module = entry["file"]
            yield f"\n`{here}`\n\n| constant | value | kind | what it is | half | twice |\n|---|---|---|---|---|---|\n"
        sides = ["not measured: " + entry["unmeasured"] if "unmeasured" in entry else "", ""]
        if measure.is_measured(entry):
            sides = [effect(results.get((entry["file"], entry["name"], value, side)), base)
                     + (f" ({entry[side]})" if side in entry else "") for side in ("half", "twice")]
        does = entry["does"] + (f"; needed by {entry['scene']} (test `{entry['test']}`)" if "scene" in entry else "")
        yield f"| `{entry['name']}` | {value} | {entry['kind']} | {does} | {sides[0]} | {sides[1]} |\n"


def current():
    """The document as it is; empty if there is none."""
    if not os.path.exists(DOCUMENT):
        return ""
    with open(DOCUMENT, encoding="utf-8") as stream:
        return stream.read()


def main(args):
    text, new = current(), "".join(lines())
    if args == ["--check"]:
        return int(text != new)
    if text != new:
        with open(DOCUMENT, "w", encoding="utf-8") as stream:
            stream.write(new)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
