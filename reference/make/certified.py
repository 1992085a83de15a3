"""Tables whose values are each computed by two independent methods ("routes"): comparison, printing, command line."""

from dataclasses import dataclass, field
from typing import Callable

from mpmath import mp, mpf, nstr

from command_line import STORED, options, run
from tables import read_table, write_table

mp.dps = 40               # digits carried

DATE = "2026-11-21"
PAPER = ("A. Papangelo, M. Ciavarella, Lubricants 8(9), 90 (2020), "
         "doi 10.3390/lubricants8090090")
INTERFACE_UNITS = ("lengths, approach and contact radius in units of epsilon, approach > 0 pressed "
                   "together; load = W/(pi w R), > 0 compressive; force = -load; "
                   "tabor = (R w^2/(E*^2 epsilon^3))^(1/3)")


def text(x, digits):
    """A number rounded to the given significant digits."""
    return nstr(mpf(x), digits, strip_zeros=True, min_fixed=-6, max_fixed=digits)


class Agreement:
    """The largest relative difference between two routes so far. A difference above the limit is an error."""

    def __init__(self, limit):
        self.limit = mpf(limit)
        self.largest = mpf(0)
        self.count = 0

    def check(self, label, value, other, scale=None):
        """Returns the value if the other route agrees, relative to `scale` or, by default, to the value."""
        size = abs(value) if scale is None else mpf(scale)
        difference = abs(value - other) / size if value != other else mpf(0)
        if not difference <= self.limit:
            raise ValueError(f"{label}: the two routes give {nstr(value, 25)} and "
                             f"{nstr(other, 25)}")
        self.largest = max(self.largest, difference)
        self.count += 1
        return value

    def __str__(self):
        return (f"{self.count} comparisons, largest relative difference "
                f"{nstr(self.largest, 2)}, none above {nstr(self.limit, 2)}")


@dataclass
class Table:
    """One file: its header, its points (tuples) and the function that gives the row (strings) of a point."""
    name: str
    columns: list
    points: list
    row: Callable              # row(point, agreement) -> strings, as many as columns
    header: dict
    limit: str                 # largest relative difference of the routes
    tolerance: str             # relative tolerance of a row that --sample recomputes
    stride: int                # --sample recomputes every stride-th point
    absolute: str = "0"        # absolute tolerance; the larger of the two counts
    checks: Callable = field(default=lambda: None)   # compares known values; raises an exception if they differ

    def write(self, folder):
        self.checks()
        agreement = Agreement(self.limit)
        rows = [self.row(point, agreement) for point in self.points]
        header = {**self.header, "evidence": f"{self.header['evidence']}: {agreement}",
                  "date": self.header.get("date", DATE)}
        write_table(folder / self.name, header, self.columns, rows)
        print(f"{self.name}: {len(rows)} rows; {agreement}")

    def sample(self):
        self.checks()
        stored = read_table(STORED / self.name)[1]
        if len(stored) != len(self.points):
            raise ValueError(f"{self.name}: {len(stored)} rows, expected {len(self.points)}")
        agreement = Agreement(self.limit)
        chosen = range(0, len(self.points), self.stride)
        for index in chosen:
            for column, new in zip(self.columns, self.row(self.points[index], agreement)):
                old = stored[index][column]
                if not same(old, new, mpf(self.tolerance), mpf(self.absolute)):
                    raise ValueError(f"{self.name}, data line {index + 2}, {column}: stored {old}, "
                                     f"recomputed {new}")
        print(f"{self.name}: {len(chosen)} of {len(stored)} rows recomputed, all agree; {agreement}")


def same(old, new, tolerance, absolute):
    """Whether two printed entries, words or numbers, agree."""
    if old == new:
        return True
    try:
        a, b = mpf(old), mpf(new)
    except ValueError:
        return False
    return abs(a - b) <= max(tolerance * max(abs(a), abs(b)), absolute)


def command_line(document, tables):
    """The command line with --write [DIR] and --sample."""
    parser, _ = options(document)

    def act(arguments):
        for table in tables:
            if arguments.write:
                table.write(arguments.write)
            else:
                table.sample()

    return run(act, parser.parse_args())
