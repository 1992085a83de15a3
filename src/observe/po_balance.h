/* The energy balance dU = W d(approach) along a branch. It is violated if a state belongs to
 * another branch, or if load and energy are inconsistent. */
#ifndef PO_BALANCE_H
#define PO_BALANCE_H

#include "po_branch_point.h"

typedef struct {
  po_branch_point last; /* its pointers are not used */
  bool begun;
  double gained, done; /* since the first point: change of the energy, and work along cubics through
                          the points */
  double worst;        /* largest difference of the two so far */
  double lowest, highest; /* range of the change of the energy */
  double at;              /* approach at the largest difference, eps */
} po_balance;

/* Adds the next point along the branch. */
void po_balance_note(po_balance *balance, const po_branch_point *point);

/* The largest difference relative to the range of the energy; NAN for fewer than two points. */
double po_balance_defect(const po_balance *balance);

#endif
