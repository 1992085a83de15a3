/* States kept for the diagnosis while a branch is traced: the first point, the first folds, the
 * pull-off and the last point. */
#ifndef PO_KEPT_H
#define PO_KEPT_H

#include "po_branch_point.h"
#include "po_diagnostics.h"

typedef struct {
  po_kept_kind kind;
  double approach, load;
  size_t n;
  double *node, *gap; /* n: radii, eps; H */
} po_kept_state;

enum { PO_KEPT_FOLDS = 12, PO_MOST_KEPT = PO_KEPT_FOLDS + 3 };

typedef struct {
  po_kept_state states[PO_MOST_KEPT]; /* start, pull-off, end, then the folds */
  size_t folds;
} po_kept;

/* Keeps a visited point if it is one of these. Given: deepest, whether the point is the deepest
 * minimum of the load so far. Status: PO_NO_MEMORY. */
po_status po_kept_note(po_kept *kept, const po_branch_point *point, bool deepest);

void po_kept_clear(po_kept *kept);

#endif
