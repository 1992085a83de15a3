/* What the verbs plot and solve print and draw of a result. */
#ifndef PO_PLOT_VERB_H
#define PO_PLOT_VERB_H

#include "po_request.h"
#include "po_result.h"
#include "po_text.h"

/* Takes the name of a figure. Status: PO_BAD_INPUT unless it ends in .svg, .png or .pdf. */
po_status po_plot_take_file(const char *text, const char **file);

/* Draws the figure of a solve. Status: as po_plot_draw. */
po_status po_plot_to_file(const po_request *request, const po_result *result, const char *file);

/* Prints the plots of a solve as characters, as large as the terminal. */
po_status po_plot_to_terminal(const po_request *request, const po_result *result);

/* Draws with a script of the data folder. Status: as po_plot_draw. */
po_status po_plot_with(const po_text *script, const char *name, const char *file);

/* The size of a plot in characters: that of the terminal, within limits. */
void po_plot_size(size_t *columns, size_t *rows);

#endif
