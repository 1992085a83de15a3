"""The rule by which a claim is judged: from the numbers alone."""

import decimal
import math

REPRODUCED, WITHIN_READING, CONTRADICTED, NOT_TESTABLE, NO_RESULT = VERDICTS = (
    "reproduced", "within_reading", "contradicted", "not_testable", "no_result")

# How the claimed number is known -> whether it is more than its reading.
READINGS = {"printed": "a number printed in full: within half a unit of its last digit",
            "equation": "an equation, evaluated as it is printed",
            "about": "a number or a bound given by words such as about",
            "figure": "read off a figure"}
EXACT = ("printed", "equation")


def half_unit(text):
    """Half a unit of the last digit of a number as it is printed: 0.00005 of "8.5761"."""
    exponent = decimal.Decimal(text).as_tuple().exponent
    return 0.5 * 10.0 ** exponent


def difference(computed, low, high):
    """How far the computed number lies outside what is claimed, with its sign; 0 between the ends."""
    return computed - low if computed < low else computed - high if computed > high else 0.0


def verdict(computed, low, high, accuracy, reading):
    """reproduced or within_reading when no further off than the accuracy, contradicted else.

    What is printed in full or as an equation, what is counted, and an interval that holds the number are reproduced;
    what is said roughly or read off a figure is so within the accuracy of reading it."""
    if computed is None or not math.isfinite(computed):
        return NO_RESULT
    if abs(difference(computed, low, high)) > accuracy:
        return CONTRADICTED
    if reading in EXACT or accuracy == 0 or low < high and low <= computed <= high:
        return REPRODUCED
    return WITHIN_READING
