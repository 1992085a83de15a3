"""Figure 13: loading and unloading of the wavy sphere, A† = 3."""

from . import loading

NUMBER = "13"
TITLE = "Loading and unloading of a wavy sphere, A† = 3"
WINDOW, LOADS = (-1.5, 1.8), (-1.6, 0.35)  # of −Δ†/μ and W̄
WIDE = ((-3.0, 4.5), (-8.5, 3.5))  # the same for a second frame that contains the oscillations of the JKR theory
# Offsets of labels that would overlap: characters to the left, lines upwards.
BESIDE = {"2": (1.2, -0.9), "d": (1.0, -1.3), "e": (-1.3, -0.4)}


def make(case, references):
    del references
    return loading.make(case, NUMBER, TITLE, WINDOW, LOADS, WIDE, beside=BESIDE)
