"""Figure 12: loading and unloading of the wavy sphere, A† = 0.4."""

from . import loading

NUMBER = "12"
TITLE = "Loading and unloading of a wavy sphere, A† = 0.4"
WINDOW, LOADS = (-1.2, 2.1), (-2.5, 0.3)  # of −Δ†/μ and W̄


def make(case, references):
    del references
    return loading.make(case, WINDOW, LOADS, NUMBER, TITLE, key_below=True)
