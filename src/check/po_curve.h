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

/* A curve by points along it, from far out to contact. */
typedef struct {
  const po_plane_point *points;
  const po_plane_point *rates; /* of the points per position; NULL: not known */
  const double *positions;     /* ascending; NULL with the rates */
  size_t count;
} po_plane_curve;

typedef struct {
  size_t compared; /* points of the reference set beside ours; 0: the curves have no common range */
  size_t left_out; /* points of the reference beyond the ends of ours */
  double distance; /* the largest, of a point of one from the other curve */
  po_plane_point where; /* there */
  bool same_folds;      /* the folds of the two correspond, one by one */
  char note[160];       /* a missing or spurious fold, a different branch; "" otherwise */
} po_curve_verdict;

/* Compares two curves given by points along them, ends included. Each runs through its points as in
 * po_plane.h; a fold is where the approach turns. Only the range both have is compared. A point of
 * ours counts by how much farther from the reference it is than joining the points of a reference
 * without rates may err. When the folds do not correspond `distance` is from the whole of the other
 * curve. Given: `tolerance`, beyond which a stretch that lies on another stretch of the reference
 * is called a different branch. Status: PO_OK, PO_NO_MEMORY. */
po_status po_curve_compare(const po_plane_curve *ours, const po_plane_curve *reference,
                           double tolerance, po_curve_verdict *verdict);

/* The same for a reference that is points of a curve in no order, as markers read off a figure: the
 * greatest distance of one of them from the nearest point of ours. Nothing is said of folds. */
void po_curve_scatter(const po_plane_curve *ours, const po_plane_point *points, size_t point_count,
                      po_curve_verdict *verdict);

#endif
