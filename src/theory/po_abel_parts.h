/* Parts of the Abel transform (po_abel.h). */
#ifndef PO_ABEL_PARTS_H
#define PO_ABEL_PARTS_H

#include "po_abel.h"
#include "po_profile_table.h"

/* The transform of a table, and the extrema over all radii up to x of (pi/2) (r f')', which bound
 * its rate. */
po_abel po_abel_of_table(const po_profile_table *table, double x);
double po_abel_table_least_rate(const po_profile_table *table);
double po_abel_table_greatest_rate(const po_profile_table *table, double x);

/* The greatest drop of (pi/2) (r f')' from any radius up to `end` to another one that is larger, by
 * less than `reach`. */
double po_abel_table_greatest_drop(const po_profile_table *table, double end, double reach);

/* The number of the first row beyond x; that of rows if there is none. */
size_t po_abel_table_next(const po_profile_table *table, double x);

#endif
