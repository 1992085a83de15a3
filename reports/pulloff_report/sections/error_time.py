"""Error against run time, and the orders observed as the mesh is refined."""

import statistics

from . import Section
from ..plots import error_time
from ..words import listing

ABSENT = ("Error against run time is left out: this run holds no record of the case error_time "
          "(pulloff run --suite precision makes one).")
EMPTY = "Error against run time is left out: no point of the case has both an error and a time."


def median_orders(samples):
    """(scheme, field) -> median observed order: one number that says how a scheme converges."""
    found = {}
    for sample in samples:
        for field, value in sample.orders.items():
            if value is not None:
                found.setdefault((sample.scheme, field), []).append(value)
    return {key: statistics.median(values) for key, values in found.items()}


def build(source):
    data = {"figure": None, "orders": [], "schemes": [], "absent": ABSENT, "summary": ""}
    cases = source.run.drawing(error_time.SCRIPT) or [
        case for case in source.run.cases if case.name == error_time.SCRIPT]
    if cases:
        figure, samples = error_time.make(cases[0], source.references)
        rows = error_time.orders(samples)
        medians = sorted(median_orders(samples).items())
        data = {"figure": figure, "orders": rows if figure else [],
                "schemes": sorted({sample.scheme for sample in samples}),
                "absent": None if figure else EMPTY,
                "summary": listing(f"{scheme} {value:.1f} in the {field}"
                                   for (scheme, field), value in medians)}
    return Section("error-time", "Error against run time", "error_time.html", data)
