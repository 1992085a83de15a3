"""The figures, one module each; the `figure_script` of a case names the module.

A module defines NUMBER (the number of the paper's figure, or None), TITLE and make(case, references) -> Figure.
Optional: CASE, if it draws the case of another figure; SCHEMATIC, if it draws a sketch without a case (case is None).
To add a figure: write the module, and figures/<name>.gp if gnuplot draws it; add it to BY_SCRIPT.
"""

from . import (fig02, fig03, fig04, fig06, fig07, fig08, fig09, fig10, fig11, fig12, fig13,
               general_stairs, law_curves, laws, profiles, pull_off_map, sketches, staircase)

BY_SCRIPT = {"fig01": sketches.FIG01, "fig02": fig02, "fig03": fig03, "fig04": fig04,
             "fig05": sketches.FIG05, "fig06": fig06, "fig07": fig07, "fig08": fig08,
             "fig09": fig09, "fig10": fig10, "fig11": fig11, "fig12": fig12, "fig13": fig13,
             "fig14": pull_off_map.FIG14, "fig15": pull_off_map.FIG15, "staircase": staircase}

# The figures of the suite general.
OF_GENERAL = {"laws": laws, "law_curves": law_curves, "profiles": profiles, "general_stairs": general_stairs}
