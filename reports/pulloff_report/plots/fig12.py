"""Figure 12: loading and unloading of the wavy sphere, A† = 0.4."""

from . import loading

NUMBER = "12"
TITLE = "Loading and unloading of a wavy sphere, A† = 0.4"
WINDOW, LOADS = (-1.2, 2.1), (-2.2, 0.3)  # of −Δ†/μ and W̄
# Offsets of labels that would overlap: characters to the left, lines upwards.
BESIDE = {"2": (-1.6, 0.9), "3": (1.3, 0.1), "e": (-1.2, -0.6)}


def make(case, references):
    del references
    return loading.make(case, NUMBER, TITLE, WINDOW, LOADS, beside=BESIDE, key_below=True)
