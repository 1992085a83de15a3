/* The distance of a point from a curve that is given by points along it. */
#ifndef PO_PLANE_H
#define PO_PLANE_H

#include <stdbool.h>
#include <stddef.h>

#include "po_result.h"

typedef struct {
  double approach;
  double load;
} po_plane_point;

/* A curve, given by points along it from large separation to contact. */
typedef struct {
  const po_curve_point *points;
  size_t count;
  bool rates; /* the points have positions, ascending, and derivatives by them */
} po_plane_curve;

/* Returned: a point of a curve. */
static inline po_plane_point po_plane_at(const po_plane_curve *curve, size_t index) {
  return (po_plane_point){curve->points[index].approach, curve->points[index].load};
}

/* A stretch: the part of a curve from point `from` to point `to`. Its interpolation uses the points
 * of the curve outside the stretch as well. */
typedef struct {
  po_plane_curve curve;
  size_t from, to;
} po_stretch;

/* The point of a stretch that is nearest to a given point. */
typedef struct {
  double distance;
  size_t index; /* the nearest point lies between point `index` and the next */
  bool before;  /* the given point lies before the start of the whole curve, beyond its range */
  bool beyond;  /* the given point lies after the end of the whole curve, beyond its range */
} po_foot;

/* Returned: the stretch that is the whole curve. */
static inline po_stretch po_plane_whole(const po_plane_curve *curve) {
  return (po_stretch){*curve, 0, curve->count - 1};
}

/* Finds the nearest point of a stretch. Between two points the curve is the Hermite cubic in the
 * position with the given rates. Without rates it is the Hermite cubic in the length of the chords,
 * with the slopes of the parabola through three neighbouring points. The error of both is of fourth
 * order in the distance between points (without rates, third order beside an end of the curve), and
 * about fifty times smaller with rates. */
po_foot po_plane_foot(po_plane_point point, const po_stretch *stretch);

/* Returned: the uncertainty of the interpolation between point `index` and the next: a multiple of
 * the largest distance of the points around from cubics that omit them. In practice it is a bound,
 * mostly a hundred times the actual error. 0 if the curve has rates. */
double po_plane_uncertainty(const po_plane_curve *curve, size_t index);

#endif
