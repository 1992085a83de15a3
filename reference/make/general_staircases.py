#!/usr/bin/env python3
"""The pull-off against the preload at given approach, from the special points of general.py.

Between neighbouring special points approach and load change monotonically along the branch, so the special points
decide which stable states exist at an approach. Loading follows the stable states from far out, and where they end it
comes to rest at the only other stable states with this approach. Scenes for which more than one piece of the branch
has such states are left out, as are those where the tension at the reversal of loading could be the greatest: the
special points do not decide them.

    general_staircases.py --write [DIR]     regenerate general_staircases.csv
    general_staircases.py --sample          recompute every row, compare (exit 1 on disagreement)
"""

import sys
from dataclasses import dataclass

import numpy as np

from command_line import STORED, options, run
from general import KEYS, SPECIAL
from tables import read_table, write_table

NAME = "general_staircases.csv"
VALUES = "from_approach from_load force approach".split()
COLUMNS = KEYS + ["tabor", "complete_to", "index", *VALUES, *(name + "_uncertainty" for name in VALUES)]


class Undecided(Exception):
    """The special points do not decide what a test measures."""


@dataclass(frozen=True)
class Piece:
    """Stable states between two folds, or between a fold and an end of the branch: the rows of the special points
    between the folds, and the folds (None: an end)."""
    low: dict
    high: dict
    inside: list

    @property
    def begin(self):
        return approach(self.low) if self.low else -np.inf

    @property
    def end(self):
        return approach(self.high) if self.high else np.inf


def approach(row):
    return float(row["approach"])


def load(row):
    return float(row["load"])


def pieces(rows):
    """The stable pieces of a branch in order: at given approach they end at a fold jump_in, and begin at the fold
    jump_out after it, if exactly one mode becomes unstable and stable again."""
    out, low, inside, falling = [], None, [], False
    for row in rows:
        if row["kind"] == ("jump_out" if falling else "jump_in"):
            if not falling:
                out.append(Piece(low, row, inside))
            low, inside, falling = row, [], not falling
        elif row["kind"] in ("jump_in", "jump_out"):
            raise Undecided("folds do not alternate")
        else:
            inside.append(row)
    return out if falling else [*out, Piece(low, None, inside)]


def rest(found, away, at):
    """The only piece with a state at an approach, besides one that ends there; None: the surfaces are apart."""
    there = [piece for piece in found if piece is not away and piece.begin < at < piece.end]
    if len(there) != 1:
        raise Undecided(f"{len(there)} pieces at approach {at}")
    return there[0]


def deepest(found, piece, at):
    """The row with the greatest tension on the way of unloading from an approach on a piece; None: no minimum."""
    best = min((row for row in piece.inside if row["kind"] == "minimum" and approach(row) < at), key=load, default=None)
    if not piece.low:
        return best
    below = deepest(found, rest(found, piece, piece.begin), piece.begin)
    return min((row for row in (best, below) if row), key=load, default=None)


def may_be_deeper(piece, at, depth):
    """Whether the load of a piece at an approach may be lower than that: it is between those of the special points
    beside."""
    before = [row for row in piece.inside if approach(row) <= at] or [piece.low]
    after = [row for row in piece.inside if approach(row) > at] or [piece.high]
    return any(row and load(row) < depth for row in (before[-1], after[0]))


def staircase(rows):
    """The steps of a scene: (row at which it begins, row that is measured)."""
    found = pieces(rows)
    piece, at, begin, steps = found[0], -np.inf, None, []
    while True:
        best = deepest(found, piece, at) if begin else None
        if best and may_be_deeper(piece, at, load(best)):
            raise Undecided("the tension where loading is reversed may be the greatest")
        if best and not (steps and steps[-1][1] is best):
            steps.append((begin, best))
        for row in (row for row in piece.inside if row["kind"] == "minimum" and approach(row) > at):
            if not steps or load(row) < load(steps[-1][1]):
                steps.append((row, row))
        if not piece.high:
            return steps
        at, begin = piece.end, piece.high
        piece = rest(found, piece, at)


def table():
    """The rows of the table, and the scenes that are left out with the reason."""
    scenes, out, left = {}, [], []
    for row in read_table(STORED / SPECIAL)[1]:
        scenes.setdefault(tuple(row[key] for key in KEYS), []).append(row)
    for key, rows in scenes.items():
        try:
            steps = staircase(rows)
        except Undecided as reason:
            left.append(f"{' '.join(key)}: {reason}")
            continue
        out += [[*key, rows[0]["tabor"], rows[0]["complete_to"], str(i + 1), begin["approach"], begin["load"],
                 best["load"].removeprefix("-"), best["approach"], begin["approach_uncertainty"],
                 begin["load_uncertainty"], best["load_uncertainty"], best["approach_uncertainty"]]
                for i, (begin, best) in enumerate(steps)]
    return out, left


def header():
    base = read_table(STORED / SPECIAL)[0]
    keep = {key: base[key] for key in ("source", "laws", "profiles", "uncertainty", "convergence")}
    return {
        "what": "the pull-off (greatest tension of the whole unloading) that a test at given approach measures, by the "
                "greatest approach of its loading; any law, any profile. A step begins at from_approach, from_load (the "
                "fold at which loading jumps, or a minimum of the load that loading passes). complete_to: the approach "
                "up to which loading was followed",
        "kind": "oracle",
        "method": f"the special points of {SPECIAL}, between which approach and load are monotonic: loading and "
                  "unloading follow stable states between folds and come to rest at the only other stable states with "
                  "the approach of a fold; scenes that the special points do not decide are left out. No code or "
                  "method of src/",
        "units": base["units"].replace("contact_radius: the outermost radius where the gap is that of the greatest "
                                       "tension, 0 when there is none", "force = -load"),
        **keep,
        "generator": "reference/make/general_staircases.py",
        "command": "python3 reference/make/general_staircases.py --write",
        "date": base["date"],
    }


def act(arguments):
    rows, left = table()
    if arguments.write:
        write_table(arguments.write / NAME, header(), COLUMNS, rows)
        print("\n".join(f"left out: {text}" for text in left))
    elif [list(row.values()) for row in read_table(STORED / NAME)[1]] != rows:
        raise ValueError(f"{NAME}: a recomputed row differs from the stored one")
    else:
        print(f"all rows of {NAME} agree")


def main():
    return run(act, options(__doc__)[0].parse_args())


if __name__ == "__main__":
    sys.exit(main())
