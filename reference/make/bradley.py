#!/usr/bin/env python3
"""The rigid smooth sphere (Bradley), Eq 23, in exact rational arithmetic.

    bradley.py --write [DIR]     regenerate bradley.csv
    bradley.py --sample          recompute every row, compare (exit 1 on disagreement)

The approach is a decimal fraction, so the load -2 (4 x^6 - 1) / (3 x^8), x = 1 - approach, is a
rational number; only its printing rounds.
"""

import sys
from decimal import Decimal, localcontext
from fractions import Fraction

from command_line import STORED, options, run
from tables import read_table, write_table

FIRST, LAST, STEP = Fraction(-8), Fraction(45, 100), Fraction(5, 100)
DIGITS = 17               # read back to the nearest double
NAME = "bradley.csv"


def load(approach):
    """Eq 23."""
    x = 1 - approach
    return -2 * (4 * x**6 - 1) / (3 * x**8)


def decimal(value):
    """A fraction rounded correctly to DIGITS digits."""
    with localcontext() as context:
        context.prec = DIGITS
        return str(Decimal(value.numerator) / Decimal(value.denominator))


def rows():
    count = int((LAST - FIRST) / STEP)
    return [(decimal(approach), decimal(load(approach)))
            for approach in (FIRST + i * STEP for i in range(count + 1))]


def header():
    return {
        "what": "load against approach of the rigid smooth sphere",
        "source": "R. S. Bradley, Phil. Mag. 13, 853 (1932); A. Papangelo, M. Ciavarella, "
                  "Lubricants 8(9), 90 (2020), doi 10.3390/lubricants8090090, Eq 23",
        "kind": "oracle",
        "method": "closed form in exact rational arithmetic, rounded once when printed",
        "units": "approach in units of epsilon, > 0 pressed together; load = W/(pi w R), "
                 "> 0 compressive",
        "uncertainty": f"half a unit of digit {DIGITS}",
        "tabor": "0",
        "amplitude": "0",
        "outer_radius": "inf",
        "generator": "reference/make/bradley.py",
        "command": "python3 reference/make/bradley.py --write",
        "date": "2026-11-21",
    }


def act(arguments):
    if arguments.write:
        write_table(arguments.write / NAME, header(), ["approach", "load"], rows())
    elif [tuple(row.values()) for row in read_table(STORED / NAME)[1]] != rows():
        raise ValueError(f"{NAME}: a recomputed row differs from the stored one")
    else:
        print(f"all rows of {NAME} agree")


def main():
    parser, _ = options(__doc__)
    return run(act, parser.parse_args())


if __name__ == "__main__":
    sys.exit(main())
