/* A special point solved again on a finer mesh: the difference is what the mesh of the trace costs.
 */
#ifndef PO_REFINE_H
#define PO_REFINE_H

#include "po_corrector.h"
#include "po_resolution.h"
#include "po_special_point.h"

/* A bound of the error of a value that a finer mesh changed so much, where Newton's iteration has a
 * precision (see po_equilibrium). */
double po_refine_error(double precision, double change, double value);

/* A special point with its errors. */
typedef struct {
  const po_solution *point;  /* the one given, or one of the spares */
  double value[2], error[2]; /* of approach and load: bounds, estimated */
  const po_solution *finer;  /* the one of the spares that it was judged by */
} po_refined;

/* What a special point is judged by. */
typedef struct {
  po_event_kind of;
  double slope;  /* of the rate whose root it is, per distance along the arclength functional of its
                    point */
  double enough; /* error of the load that need not be made less; INFINITY: any */
  po_solution *spare[2];
} po_refinement;

/* Given: a fold or an extremum of the load, its mesh resolved by `resolution`; its approach and
 * load in r->value. Solves it again with every panel halved that contributes to the error, and none
 * that spans more than a few waves: what that changes is the error. When it is more than enough,
 * the finer solution is taken for the special point, and judged by one finer still. The mesh in
 * force is another then. Status: PO_NOT_CONVERGED, PO_OUT_OF_NODES. */
po_status po_refine(po_corrector *c, const po_resolution *resolution, const po_refinement *how,
                    po_refined *r);

/* The slope at an event, with the samples along the arclength functional of a point before it, at a
 * cosine to its own arclength functional. */
double po_refine_slope(const po_event *event, double cosine);

/* The fold or extremum near the guess, on the mesh in force: Newton's method for the equilibria, a
 * secant along the arclength functional of `from` for the rate to vanish. Given: slope of that
 * rate, roughly; NAN: unknown. Returned: the slope met, the special point in out, its approach and
 * load in value. Status: PO_NOT_CONVERGED. */
po_status po_refine_locate(po_corrector *c, const po_solution *from, po_event_kind of,
                           double *slope, po_solution *out, double value[2]);

#endif
