/* Edges of the contact, and the displacement that carries the radii with them: in coordinates that
 * move with the edges an equilibrium changes slowly along the branch, however steep the gap is
 * there. */
#ifndef PO_FRONT_H
#define PO_FRONT_H

#include <stddef.h>

enum { PO_MOST_FRONTS = 48 };

/* Radii where the gap passes that of the greatest tension, ascending, and how fast they move: the
 * outermost ones, where there are more than there is room for. */
typedef struct {
  size_t count;
  size_t all;                /* how many such radii there are */
  double at[PO_MOST_FRONTS]; /* eps */
  double rate[PO_MOST_FRONTS];
} po_fronts;

/* The displacement at radius r that moves each front by its shift and dies out between fronts, at
 * the axis and beyond the last: constant about each front, smooth (C2), linear in the shifts. */
double po_front_displacement(const po_fronts *fronts, const double *shift, double r);

/* The radius whose displaced place is r. The strain must be below a half or so. */
double po_front_origin(const po_fronts *fronts, const double *shift, double r);

/* The largest slope of the displacement: below 1 no two places meet. */
double po_front_strain(const po_fronts *fronts, const double *shift);

/* Where that is: between this front and the one before, or the axis; the count: beyond the last. */
size_t po_front_tightest(const po_fronts *fronts, const double *shift);

#endif
