/* The error of a special point, estimated by solving it again on a finer mesh. See doc/method.md,
 * "Errors". */
#ifndef PO_REFINE_H
#define PO_REFINE_H

#include "po_corrector.h"
#include "po_special_point.h"

/* Estimated bound of the error of a value. Given: precision of Newton's method (po_equilibrium.h);
 * change of the value on a finer mesh; the value. */
double po_refine_error(double precision, double change, double value);

/* A special point with its errors. */
typedef struct {
  const po_solution *point;  /* its solution: the given one, or one of the spares */
  double value[2], error[2]; /* of approach and load; the errors are estimated bounds */
  const po_solution
      *finer; /* the solution, one of the spares, from which the errors were estimated */
} po_refined;

/* How the error of a special point is estimated. */
typedef struct {
  po_event_kind of;
  double slope;  /* derivative of the rate that vanishes at the special point, with respect to the
                    arclength functional of that point */
  double enough; /* error of the load that is accepted; INFINITY: any */
  po_solution *spare[2]; /* the current mesh is kept in the first, as `wanted` */
} po_refinement;

/* Estimates the error of a fold or an extremum of the load. The special point is solved again on a
 * finer mesh, on which every panel that contributes to the error is halved and panels that span
 * several waves are split. If the error of the load exceeds how->enough, the finer solution
 * replaces the special point and is compared with one on a still finer mesh. Given: r->point,
 * and its approach and load in r->value. Returned: r. The current mesh stays, without its factors.
 * Status: PO_NOT_CONVERGED, PO_OUT_OF_NODES. */
po_status po_refine(po_corrector *c, const po_refinement *how, po_refined *r);

/* Locates the fold or extremum near the guess on the current mesh: Newton's method for the
 * equilibrium, and the secant method along the arclength functional of `from` for the root of the
 * rate. Given: at, the value of the functional at which the search begins; slope, an approximate
 * derivative of that rate; NAN: unknown. Returned: slope; the special point in out, its approach
 * and load in value. Status: PO_NOT_CONVERGED. */
po_status po_refine_locate(po_corrector *c, const po_solution *from, double at, po_event_kind of,
                           double *slope, po_solution *out, double value[2]);

#endif
