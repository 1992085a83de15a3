/* The plot of a case in which two numbers vary. */
#ifndef PO_PLOT_CASE_MAP_H
#define PO_PLOT_CASE_MAP_H

#include "po_case.h"
#include "po_run.h"

/* Returned: the number of values of a continuous key in the sweep of a case; 0 for others. */
size_t po_plot_varied_values(const po_case *kase, int key);

/* Returned: whether exactly two numbers vary in a case, each with at least 8 values, in different
 * items of its sweep. Then: the keys on the x and on the y axis; that of the last item is on the x
 * axis. */
bool po_plot_case_is_map(const po_case *kase, po_key keys[2]);

/* Plots the pull-off forces of such a case as a map: in a file, or as characters if it is NULL.
 * Status: as po_plot_draw; PO_BAD_INPUT if no point has a pull-off. */
po_status po_plot_case_map(const po_case_run *run, const po_case *kase, const po_key keys[2],
                           const char *file);

#endif
