/* Compares curves in the plane of approach (in epsilon) and load (in pi w R). The distance normal
 * to the curve is computed separately for each stretch between two folds. A comparison at equal
 * approach would be meaningless, because the load is a multivalued function of the approach. */
#ifndef PO_CURVE_H
#define PO_CURVE_H

#include "po_plane.h"
#include "po_status.h"

typedef struct {
  size_t compared;      /* compared points of the reference; 0: the curves have no common range */
  size_t left_out;      /* points of the reference beyond the ends of our curve */
  double distance;      /* the largest distance of a point of one curve from the other curve */
  po_plane_point where; /* that point */
  bool same_folds;      /* both curves have the same number of folds */
  char note[160];       /* reports a missing or spurious fold, or a different branch; else "" */
} po_curve_verdict;

/* Compares two curves over their common range. Both are interpolated as described in po_plane.h. A
 * fold is a point at which the approach has an extremum along the curve. If the numbers of folds
 * agree, corresponding stretches are compared; otherwise each point is compared with the whole of
 * the other curve. If the reference has no rates, the uncertainty of its interpolation is
 * subtracted from each distance.
 * Given: `ordered`; false: the points of the reference have no order, such as markers read off a
 * figure. Only their distances from our curve are found then, and folds are not compared;
 * `tolerance`; a point at a larger distance than this that lies on another stretch of the
 * reference is reported as a different branch.
 * Status: PO_OK, PO_NO_MEMORY. */
po_status po_curve_compare(const po_plane_curve *ours, const po_plane_curve *reference,
                           bool ordered, double tolerance, po_curve_verdict *verdict);

#endif
