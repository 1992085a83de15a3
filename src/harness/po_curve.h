/* Curves in the plane of approach (in epsilon) and load (in pi w R), compared as curves: stretch by
 * stretch between folds, by the distance normal to the curve. Where a branch is multivalued a
 * comparison at equal approach would say nothing. */
#ifndef PO_CURVE_H
#define PO_CURVE_H

#include <stdbool.h>
#include <stddef.h>

#include "po_status.h"

typedef struct {
  double approach;
  double load;
} po_plane_point;

typedef struct {
  size_t compared; /* points of the reference set beside ours; 0: the curves have no common range */
  size_t left_out; /* points of the reference beyond the ends of ours */
  double distance; /* the largest, of a point of one from the other curve */
  po_plane_point where; /* there */
  bool same_folds;      /* the folds of the two correspond, one by one */
  char note[160];       /* a missing or spurious fold, a different branch; "" otherwise */
} po_curve_verdict;

/* Compares two curves given by points along them, ends included. Each curve runs smoothly through
 * its points (cubic in the length of the chords); a fold is where the approach turns. Only the
 * range both have is compared. When the folds do not correspond `distance` is from the whole of the
 * other curve. Given: `tolerance`, beyond which a stretch that lies on another stretch of the
 * reference is called a different branch. Status: PO_OK, PO_NO_MEMORY. */
po_status po_curve_compare(const po_plane_point *ours, size_t count,
                           const po_plane_point *reference, size_t reference_count,
                           double tolerance, po_curve_verdict *verdict);

/* The same for a reference that is points of a curve in no order, as markers read off a figure: the
 * greatest distance of one of them from the nearest point of ours. Nothing is said of folds. */
void po_curve_scatter(const po_plane_point *ours, size_t count, const po_plane_point *points,
                      size_t point_count, po_curve_verdict *verdict);

#endif
