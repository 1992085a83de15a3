/* The distance of a point from a curve given by points along it. */
#ifndef PO_PLANE_H
#define PO_PLANE_H

#include <stdbool.h>

#include "po_curve.h"

/* The part of a curve from point `from` to point `to`; the curve around it shapes its ends. */
typedef struct {
  const po_plane_point *points;
  size_t count;
  size_t from, to;
} po_stretch;

/* Where a point is with respect to a stretch. */
typedef struct {
  double distance;
  bool before; /* nearest to the start of the whole curve, and ahead of it: no counterpart */
  bool beyond; /* the same at its end */
} po_foot;

/* The nearest point of the stretch, the curve being the cubic that passes through its points with
 * the slope there of the parabola through three neighbours, in the length of the chords (error of
 * fourth order in their length, third beside an end). */
po_foot po_plane_foot(po_plane_point point, const po_stretch *stretch);

#endif
