/* The plot of a case. */
#ifndef PO_PLOT_CASE_H
#define PO_PLOT_CASE_H

#include "po_status.h"

/* Plots the pull-off forces of a case against a key of its sweep, or as a map if two keys vary.
 * Given: `run`, folder of the records; NULL: the default; `file`, NULL: as characters. Points
 * without a result are solved. */
po_status po_plot_case(char *name, const char *run, const char *file);

#endif
