/* Edges of the contact, and the displacement that carries the radii with them: in coordinates that
 * move with the edges an equilibrium changes slowly along the branch, however steep the gap is
 * there. */
#ifndef PO_MOVING_EDGES_H
#define PO_MOVING_EDGES_H

#include <stdbool.h>
#include <stddef.h>

enum { PO_MOST_MOVING_EDGES = 48 };

/* Radii where the gap passes that of the greatest tension, ascending, and how fast they move: the
 * outermost ones, where there are more than there is room for. */
typedef struct {
  size_t count;
  size_t all;                      /* how many such radii there are */
  double at[PO_MOST_MOVING_EDGES]; /* eps */
  double rate[PO_MOST_MOVING_EDGES];
} po_moving_edges;

/* The displacement at radius r that moves each contact edge by its shift and dies out between
 * contact edges, at the axis and beyond the last: constant about each contact edge, smooth (C2),
 * linear in the shifts. */
double po_edge_displacement(const po_moving_edges *edges, const double *shift, double r);

/* The radius whose displaced place is r. The strain must be below a half or so. */
double po_edge_origin(const po_moving_edges *edges, const double *shift, double r);

/* The largest slope of the displacement: below 1 no two places meet. */
double po_edge_strain(const po_moving_edges *edges, const double *shift);

/* Whether a prediction may move the edges by their shifts; and whether solutions whose edges are
 * so far apart may be interpolated. */
bool po_edge_may_move(const po_moving_edges *edges, const double *shift);
bool po_edge_may_relate(const po_moving_edges *edges, const double *shift);

/* Where that is: between this contact edge and the one before, or the axis; the count: beyond the
 * last. */
size_t po_edge_tightest(const po_moving_edges *edges, const double *shift);

#endif
