/* Whether the energy of the equilibria along a branch changes by the work done on them, dU = W
 * dapproach: a state that belongs to another branch, or a load that is not the energy's, breaks it.
 */
#ifndef PO_BALANCE_H
#define PO_BALANCE_H

#include "po_branch_point.h"

typedef struct {
  po_branch_point last; /* of which only numbers are read */
  bool begun;
  double gained, done;    /* since the beginning: energy, and work by cubics through the points */
  double worst;           /* the largest of their difference so far */
  double lowest, highest; /* energy gained */
  double at;              /* approach at the worst */
} po_balance;

/* Takes note of the next point along the branch. */
void po_balance_note(po_balance *balance, const po_branch_point *point);

/* The largest difference in parts of the range of the energy; NAN before there are two points. */
double po_balance_defect(const po_balance *balance);

#endif
