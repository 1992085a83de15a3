"""The rule by which claims are judged. It uses only the numbers."""

import decimal
import math

REPRODUCED, WITHIN_READING, DEPENDS, CONTRADICTED, NOT_TESTABLE, NO_RESULT, CHECKED, CHECK_FAILED = VERDICTS = (
    "reproduced", "within_reading", "depends", "contradicted", "not_testable", "no_result", "checked", "check_failed")
HOLDS = (REPRODUCED, WITHIN_READING)
PASSES = (*HOLDS, CHECKED)                         # of a claim or an implementation check

# How the claimed number is known -> the convention by which it is read.
READINGS = {"printed": "a number printed in full: half a unit of its last digit",
            "equation": "an equation, evaluated as printed: the stated numerical error",
            "bound": "an order of two numbers, a sign or a count: exact",
            "axis": "a number on a linear axis of a figure: 2 % of the range of its values, by the text or as computed",
            "logarithmic": "a number on a logarithmic axis of a figure: 0.05 decades, 11 % below and 12 % above",
            "about": "about, ≈, ≃, close, slightly, well, or a number said of a marker, curve or contour: 10 %",
            "order": "a power of ten after ≈ or ≃ (≃ 10⁻¹, ≈ 1 on an axis of decades): a factor of 3 in both directions",
            "large": "large, small, much, very, greatly, strongly, markedly, suddenly: a ratio of at least 2",
            "gradual": "no threshold, nothing that is large or sudden: a ratio below 2 in both directions"}
UNNUMBERED = ("large", "gradual")                  # readings of a ratio without a number of the paper
EXACT = ("printed", "equation", "bound")
SCALES = {"half": 0.5, "once": 1.0, "twice": 2.0}    # of the accuracy of the convention
AXIS, DECADES, ABOUT, ORDER, LARGE = 0.02, 0.05, 0.1, 3.0, 2.0


def half_unit(text):
    """Half a unit of the last digit of a printed number: 0.00005 for "8.5761"."""
    exponent = decimal.Decimal(text).as_tuple().exponent
    return 0.5 * 10.0 ** exponent


def reach(claim, claimed, low, high, scale=1.0, computed=None):
    """(low, high, accuracy): the claimed interval and the accuracy by the convention of the entry, times a scale; a
    factor is raised to the power of the scale. Decades reach farther above a number than below it: `computed` says on which side."""
    reading = claim["reading"]
    if reading == "large":
        return LARGE ** scale, math.inf, 0.0
    if reading == "gradual":
        return LARGE ** -scale, LARGE ** scale, 0.0
    if reading == "order":
        return low / ORDER ** scale, high * ORDER ** scale, 0.0
    above = computed is not None and computed > high
    nearest = abs(high) if above and reading == "logarithmic" else min((abs(end) for end in (low, high) if math.isfinite(end)), default=0.0)
    return low, high, {"printed": lambda: half_unit(claimed), "equation": lambda: claim["accuracy"], "bound": lambda: 0.0,
                       "axis": lambda: scale * AXIS * (claim["range"][1] - claim["range"][0]),
                       "logarithmic": lambda: abs(10 ** (scale * DECADES * (1 if above else -1)) - 1) * nearest,
                       "about": lambda: scale * ABOUT * nearest}[reading]()


def difference(computed, low, high):
    """The signed distance of the computed number from the claimed interval; 0 within it."""
    return computed - low if computed < low else computed - high if computed > high else 0.0


def verdict(computed, low, high, accuracy, reading):
    """contradicted if the difference exceeds the accuracy, otherwise reproduced or, if the number is read by a
    convention, within_reading."""
    if computed is None or not math.isfinite(computed):
        return NO_RESULT
    if abs(difference(computed, low, high)) > accuracy:
        return CONTRADICTED
    return REPRODUCED if reading in EXACT else WITHIN_READING


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
