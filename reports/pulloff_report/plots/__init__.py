"""The figures: one module each, found by the `figure_script` a case names.

A module offers NUMBER (of the paper's figure, or None), TITLE and make(case, references) -> Figure.
To add one: write the module here and, when gnuplot draws it, figures/<name>.gp; enter it below.
"""

from . import fig03, fig04

BY_SCRIPT = {"fig03": fig03, "fig04": fig04}
