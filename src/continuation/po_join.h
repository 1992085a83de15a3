/* How far the curve of approach and load between two points of a branch is from what joins them. */
#ifndef PO_JOIN_H
#define PO_JOIN_H

#include "po_branch_point.h"

/* From the straight line: the sagitta of the chord, from the turn of the curve. */
double po_join_sagitta(const po_branch_point *from, const po_branch_point *to);

/* From the cubic of the position with the rates at both ends: by the difference between the load
 * integrated over the approach along it and that of the energies. Given: points whose energies are
 * as good as their loads. Accuracy: a tenth on an arc of 0.6 (tests/unit/test_join.c). */
double po_join_miss(const po_branch_point *from, const po_branch_point *to);

#endif
