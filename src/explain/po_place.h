/* Where on the branch a result is, in words. */
#ifndef PO_PLACE_H
#define PO_PLACE_H

#include "po_result.h"

enum { PO_PLACE_LENGTH = 160 };

/* "at jump_in-1", "between jump_out-2 and minimum-1", "before jump_in-1", "after minimum-1": the
 * special points are called as in the ids of checks. "" when the branch has no special point, or
 * the place cannot be told without the points of the curve, which the result lacks. */
void po_place_tell(const po_result *result, double approach, double load,
                   char words[PO_PLACE_LENGTH]);

#endif
