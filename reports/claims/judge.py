"""The rule by which claims are judged. It uses only the numbers."""

import decimal
import math

REPRODUCED, WITHIN_READING, DEPENDS, CONTRADICTED, NOT_TESTABLE, NO_RESULT, CHECKED, CHECK_FAILED = VERDICTS = (
    "reproduced", "within_reading", "depends", "contradicted", "not_testable", "no_result", "checked", "check_failed")
HOLDS = (REPRODUCED, WITHIN_READING)
PASSES = (*HOLDS, CHECKED)                         # of a claim or an implementation check

# How the claimed number is known -> its accuracy.
READINGS = {"printed": "a number printed in full: within half a unit of its last digit",
            "equation": "an equation, evaluated as printed",
            "about": "a number or a bound given by words such as about",
            "figure": "read off a figure"}
EXACT = ("printed", "equation")


def half_unit(text):
    """Half a unit of the last digit of a printed number: 0.00005 for "8.5761"."""
    exponent = decimal.Decimal(text).as_tuple().exponent
    return 0.5 * 10.0 ** exponent


def difference(computed, low, high):
    """The signed distance of the computed number from the claimed interval; 0 within it."""
    return computed - low if computed < low else computed - high if computed > high else 0.0


def side(computed, low, high, accuracy):
    """0 if the difference does not exceed the accuracy; otherwise -1 below and 1 above the claimed interval."""
    off = difference(computed, low, high)
    return 0 if abs(off) <= accuracy else math.copysign(1, off)


def verdict(computed, low, high, accuracy, reading):
    """contradicted if the difference exceeds the accuracy, otherwise reproduced or within_reading.

    A number printed in full, an equation, a count, and an interval that contains the computed number are reproduced;
    an approximate number or one read off a figure is reproduced within reading accuracy.
    """
    if computed is None or not math.isfinite(computed):
        return NO_RESULT
    if side(computed, low, high, accuracy):
        return CONTRADICTED
    if reading in EXACT or accuracy == 0 or low < high and low <= computed <= high:
        return REPRODUCED
    return WITHIN_READING


def overall(verdicts, is_check=False):
    """The verdict of a claim from those of its choices: depends if it holds for some choices and not for others."""
    if NO_RESULT in verdicts:
        return NO_RESULT
    if is_check:
        return CHECK_FAILED if CONTRADICTED in verdicts else CHECKED
    kinds = set(verdicts)
    if len(kinds) > 1 and CONTRADICTED in kinds:
        return DEPENDS
    return WITHIN_READING if WITHIN_READING in kinds else kinds.pop()
