/* The plots of a case and of a solve. */
#ifndef PO_PLOT_CASE_H
#define PO_PLOT_CASE_H

#include "po_request.h"
#include "po_result.h"
#include "po_status.h"
#include "po_text.h"

/* Plots the pull-off forces of a case against a key of its sweep, or as a map if two keys vary.
 * Given: `run`, folder of the records; NULL: the default; `file`, NULL: as characters. Points
 * without a result are solved. */
po_status po_plot_case(char *name, const char *run, const char *file);

/* Takes the name of a figure. Status: PO_BAD_INPUT unless it ends in .svg, .png or .pdf. */
po_status po_plot_take_file(const char *text, const char **file);

/* Draws the figure of a solve. Status: as po_plot_draw. */
po_status po_plot_to_file(const po_request *request, const po_result *result, const char *file);

/* Prints the plots of a solve as characters, as large as the terminal. */
po_status po_plot_to_terminal(const po_request *request, const po_result *result);

#endif
