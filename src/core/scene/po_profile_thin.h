/* The spline of a table on fewer knots, for the theories of contact, whose cost grows with the
 * square of the number of knots, or faster. */
#ifndef PO_PROFILE_THIN_H
#define PO_PROFILE_THIN_H

#include "po_profile_table.h"

/* Tables of no more rows are not thinned. */
enum { PO_THIN_LEAST = 256 };

/* Chooses rows between which one cubic, with the gaps and the slopes of the table at its ends,
 * stands for the spline of all rows: nowhere do the slopes of the two differ by more than 1e-7
 * times the greatest slope so far, or 1e-7 eps/r if that is more. The Abel transform at x, eps,
 * then differs by less than 1.6e-7 times 1, or x times the greatest slope. Returned: kept, of
 * room for all rows: their numbers, ascending, with the first and the last row; rows that have more
 * noise than that are all kept. (tests/unit/test_profile.c). */
size_t po_profile_thin(const po_profile_table *table, size_t *kept);

#endif
