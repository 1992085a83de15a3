/* Describes the place of a result on the branch. */
#ifndef PO_PLACE_H
#define PO_PLACE_H

#include "po_result.h"

enum { PO_PLACE_LENGTH = 160 };

/* Returned: in `words`, the place relative to the special points, which have the names that the ids
 * of checks contain: "at jump_in-1", "between jump_out-2 and minimum-1", "before jump_in-1", "after
 * minimum-1". "" if the branch has no special point, or if the place depends on the points of the
 * curve and the result has none. */
void po_place_describe(const po_result *result, double approach, double load,
                       char words[PO_PLACE_LENGTH]);

#endif
