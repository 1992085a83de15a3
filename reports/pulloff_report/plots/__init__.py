"""The figures: one module each, found by the `figure_script` a case names.

A module offers NUMBER (of the paper's figure, or None), TITLE and make(case, references) -> Figure;
CASE, when it draws the case of another figure; AT_ANY_PRELOAD, when it draws that of this name with _any
after it; SCHEMATIC, when it draws none (case is None).
To add one: write the module here and, when gnuplot draws it, figures/<name>.gp; enter it below.
"""

from . import (doubling, fig02, fig03, fig04, fig06, fig07, fig08, fig09, fig10, fig11, fig12, fig13,
               pull_off_map, sketches, staircase)

BY_SCRIPT = {"fig01": sketches.FIG01, "fig02": fig02, "fig03": fig03, "fig04": fig04,
             "fig05": sketches.FIG05, "fig06": fig06, "fig07": fig07, "fig08": fig08,
             "fig09": fig09, "fig10": fig10, "fig11": fig11, "fig12": fig12, "fig13": fig13,
             "fig14": pull_off_map.FIG14, "fig15": pull_off_map.FIG15,
             "doubling": doubling, "staircase": staircase}
