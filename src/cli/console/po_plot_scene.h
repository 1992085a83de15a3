/* The pictures of one scene and of a series of scenes: a figure in a file, or characters. */
#ifndef PO_PLOT_SCENE_H
#define PO_PLOT_SCENE_H

#include "po_plot.h"
#include "po_print_series.h"

/* Takes the name of a figure (po_option_taker), a const char *. Status: PO_BAD_INPUT unless it ends
 * in .svg, .png or .pdf. */
po_status po_plot_take_file(const char *name, void *file);

/* Draws a picture in a file, or prints it as characters if it is NULL, as large as the terminal,
 * and clears it. Status: that of the picture; as po_plot_draw. */
po_status po_plot_show(po_plot_picture picture, const char *file);

/* Returned: the picture of the pull-off or of the folds along a series. */
po_plot_picture po_plot_of_series(const po_printed_series *series, bool folds);

#endif
