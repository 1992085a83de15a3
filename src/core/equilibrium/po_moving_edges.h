/* Contact edges, and the displacement field that moves radii with them. In coordinates that move
 * with the contact edges the gap changes slowly along the branch, even where it is steep. See
 * doc/method.md, "Moving coordinates". */
#ifndef PO_MOVING_EDGES_H
#define PO_MOVING_EDGES_H

#include <stdbool.h>
#include <stddef.h>

enum { PO_MOST_MOVING_EDGES = 48 };

/* Contact edges: radii at which the gap passes that of the greatest tension, ascending. If there
 * are more than PO_MOST_MOVING_EDGES, the outermost ones are kept. */
typedef struct {
  size_t count;
  size_t all;                      /* number of contact edges, kept or not */
  double at[PO_MOST_MOVING_EDGES]; /* eps */
  double rate[PO_MOST_MOVING_EDGES];
} po_moving_edges;

/* A radius between the contact edges outer - 1 and outer, of which there are `count`; the
 * displacement there is (1 - weight) of the shift of the former and weight of that of the latter.
 * The axis and the radii beyond the outermost edge do not move. */
typedef struct {
  double r; /* eps */
  size_t outer, count;
  double weight;
  double weight_slope; /* d(weight)/dr, 1/eps */
} po_edge_place;

/* The displacement, eps, at a place. It equals the shift of a contact edge in an interval about
 * that edge, is blended between two edges, and is zero at the axis and beyond the outermost edge.
 * It is twice continuously differentiable in r and linear in the shifts. Given: shift, one value an
 * edge, eps. */
double po_edge_displacement(const po_edge_place *place, const double *shift);

/* The place that the displacement moves to r. Given: shifts with a strain below about a half; near,
 * the `outer` of a place near it, or any other number. */
po_edge_place po_edge_origin(const po_moving_edges *edges, const double *shift, double r,
                             size_t near);

/* The strain: the largest modulus of the slope of the displacement. Below 1 the displaced radii
 * keep their order. */
double po_edge_strain(const po_moving_edges *edges, const double *shift);

/* Whether the strain is small enough for a prediction to move the edges by these shifts; and
 * whether it is small enough for interpolation between solutions whose edges differ by these
 * shifts. */
bool po_edge_may_move(const po_moving_edges *edges, const double *shift);
bool po_edge_may_relate(const po_moving_edges *edges, const double *shift);

#endif
