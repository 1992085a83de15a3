"""Figure 13: loading and unloading of the wavy sphere, A† = 3."""

from . import loading

NUMBER = "13"
TITLE = "Loading and unloading of a wavy sphere, A† = 3"
WINDOW, LOADS = (-1.5, 1.5), (-1.75, 0.9)  # of −Δ†/μ and W̄


def make(case, references):
    del references
    return loading.make(case, WINDOW, LOADS, NUMBER, TITLE)
