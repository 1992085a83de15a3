/* Error of the interpolation of the curve (approach, load) between two points of a branch. See
 * doc/method.md, "Prediction and correction". */
#ifndef PO_JOIN_H
#define PO_JOIN_H

#include "po_branch_point.h"

/* Distance of the curve from the straight line between the points: the sagitta of an arc that turns
 * as the curve does. */
double po_join_sagitta(const po_branch_point *from, const po_branch_point *to);

/* Distance of the curve from the cubic in the position with the rates at both points, from the
 * identity dU = W d(approach): the integral of the load over the approach along the cubic is
 * compared with the difference of the energies. Given: points whose energies are as accurate as
 * their loads. Accuracy: 10 % on an arc of 0.6 (tests/unit/test_join.c). */
double po_join_miss(const po_branch_point *from, const po_branch_point *to);

#endif
