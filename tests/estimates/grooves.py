"""The pull-off with open grooves tends to that of the JKR limit as the range of the attraction becomes smaller.

    python3 tests/estimates/grooves.py build/src/cli/pulloff

The Tabor parameter is inversely proportional to the range at given w, E*, R, A and lambda. For rows of
reference/jkr_grooves.csv, which comes from equations without a range, the difference to the force of the row must fall as the
square of the range: the limit that two ranges extrapolate to must be nearer to the row by FACTOR than the value at the shorter
range. The corrections of higher order, and a logarithm that the tail of the Lennard-Jones law adds, take up to 0.21 of it."""

import csv
import json
import math
import subprocess
import sys
from pathlib import Path

REFERENCE = Path(__file__).resolve().parents[2] / "reference" / "jkr_grooves.csv"
FACTOR = 0.25
RADIUS = 1e4              # in epsilon; a parabola has no other length that counts
TABOR = {("0.5", "1", "1.2"): (10, 20), ("0.8", "1", "2"): (10, 20), ("0.5", "4", "2"): (10, 20), ("0.3", "2", "1"): (5, 10),
         ("1", "0.3", "3"): (5, 10)}    # alpha, beta, preload: Tabor parameters


def pull_off(program, row, tabor):
    """The pull-off at the longer or the shorter range: beta = lambda^3/(2 pi (tabor R)^1.5) with lambda in epsilon."""
    wavelength = (2 * math.pi * float(row["beta"])) ** (1 / 3) * math.sqrt(tabor * RADIUS)
    unit = wavelength**2 / RADIUS
    words = ["--tabor", tabor, "--radius", RADIUS, "--wavelength", wavelength, "--amplitude", float(row["alpha"]) * unit,
             "--preload", float(row["preload"]) * unit]
    done = subprocess.run([program, "solve", "--json", "--want", "profile", *map(str, words)], capture_output=True, text=True,
                          check=True)
    document = json.loads(done.stdout)
    edges = [annulus[end] / wavelength for annulus in document["contact"]["held"] for end in ("inner", "outer")]
    return {"force": document["pull_off"]["force"], "approach": document["pull_off"]["approach"] / unit, "edges": edges}


def main():
    program, wrong, left = sys.argv[1], 0, set(TABOR)
    for row in csv.DictReader(line for line in REFERENCE.read_text().splitlines() if not line.startswith("#")):
        key = row["alpha"], row["beta"], row["preload"]
        if key not in TABOR:
            continue
        left.remove(key)
        long, short = (pull_off(program, row, tabor) for tabor in TABOR[key])
        for name in ("force", "approach"):
            far, near = (found[name] - float(row[name]) for found in (long, short))
            share = abs((4 * near - far) / 3 / near)
            print(f"{' '.join(key)} {name}: {far:+.2e} and {near:+.2e} from the limit, extrapolated {share:.2f} of this")
            wrong += not share < FACTOR
        edges = [float(x) for x in row["edges"].split(";")]
        if not len(edges) == len(long["edges"]) == len(short["edges"]) == 2 * int(row["grooves"]) + 2:
            print(f"{' '.join(key)}: edges {short['edges']}, expected {edges}")
            wrong += 1
            continue
        far, near = (max(abs(x - y) for x, y in zip(found["edges"], edges)) for found in (long, short))
        print(f"{' '.join(key)} edges: {far:.2e} and {near:.2e} from the limit")
        wrong += not near < 0.6 * far
    if left:
        print(f"no row of {sorted(left)} in {REFERENCE.name}")
    return 1 if wrong or left else 0


if __name__ == "__main__":
    sys.exit(main())
