/* The distance of a point from a curve given by points along it. */
#ifndef PO_PLANE_H
#define PO_PLANE_H

#include <stdbool.h>

#include "po_curve.h"

/* The part of a curve from point `from` to point `to`; the curve around it shapes its ends. */
typedef struct {
  po_plane_curve curve;
  size_t from, to;
} po_stretch;

/* Where a point is with respect to a stretch. */
typedef struct {
  double distance;
  size_t index; /* between this point and the next */
  bool before;  /* nearest to the start of the whole curve, and ahead of it: no counterpart */
  bool beyond;  /* the same at its end */
} po_foot;

/* The whole of a curve. */
po_stretch po_plane_whole(const po_plane_curve *curve);

/* The nearest point of the stretch, the curve being the cubic of the position with the rates at
 * both points; without rates that in the length of the chords, with the slope of the parabola
 * through three neighbours. Either errs by the fourth order in the way between points (beside an
 * end of the latter the third), with rates fifty times less: sixteenths of what they do without. */
po_foot po_plane_foot(po_plane_point point, const po_stretch *stretch);

/* How far the cubic between a point and the next may be from the curve when there are no rates,
 * from how far the points around are from cubics that leave them out. A bound in practice, not an
 * estimate: mostly a hundred times what it errs. With rates: 0. */
double po_plane_doubt(const po_plane_curve *curve, size_t index);

#endif
