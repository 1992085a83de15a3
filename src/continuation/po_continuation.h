/* The branch of equilibria, followed from far out by pseudo-arclength continuation, with its folds
 * in approach and its extrema of the load.
 *
 * A step predicts the equilibrium at a distance along the arclength functional (po_arclength.h) by
 * the cubic through the last two points (po_prediction.h), corrects the prediction by Newton's
 * method (po_corrector.h), locates what lies between (po_special_point.h), and visits it. The
 * length of a step is set so that the prediction errs by a set part of 1 + H. A corrected point far
 * from its prediction, or a direction that turned too far, is not accepted: the trace neither
 * leaves the branch nor passes over part of it.
 *
 * The mesh may be panels that follow the contact edges: each point is then solved on panels that
 * resolve its traction, predictions are made in coordinates that move with the edges, and special
 * points are solved again on finer panels. A mesh that stays is the simple case without these. */
#ifndef PO_CONTINUATION_H
#define PO_CONTINUATION_H

#include "po_adaptive.h"
#include "po_branch_point.h"
#include "po_resolution.h"

typedef struct {
  /* approaches at which exact points are wanted, each time the branch passes them; NAN: none */
  double station[PO_STATIONS];
  double end;   /* approach at which the trace ends, if met; NAN: none */
  double begin; /* the trace starts here when that is farther out than it needs; NAN: no */
  double largest_sagitta; /* of a step's chord, in the plane of approach and load: how far from the
                             curve a drawing by straight lines may be */
  double largest_miss; /* likewise of the cubic with the rates at both ends; INFINITY on a mesh that
                          stays, where the energies are not as good as the loads */
  double sharpness;    /* relative error of a minimum of the load for which it is solved again on
                          a finer mesh; panels only */
  bool minima_only;    /* nobody asks for the errors of folds */
  size_t most_points;
  po_branch_visit visit;
  void *data;
} po_continuation_options;

/* No station, no end, steps and minima free, 30000 points; visit to be set. */
po_continuation_options po_continuation_options_default(void);

/* The approach at which a trace starts: a negative power of two at which the feedback of the
 * undeformed gap is below a quarter, so that there is one equilibrium and Newton's method finds it.
 */
double po_continuation_start(po_equilibrium *equilibrium);

typedef struct po_continuation po_continuation;

/* Given: an equilibrium; the panels that its surface consists of, with room for their capacity, and
 * what their resolution of the traction may leave; NULL when the mesh stays. Both objects must
 * outlive the continuation. Options are copied, their data must outlive it. Status: PO_NO_MEMORY.
 */
po_status po_continuation_create(po_equilibrium *equilibrium, po_adaptive *adaptive,
                                 po_allowance allowed, const po_continuation_options *options,
                                 po_continuation **continuation);
void po_continuation_destroy(po_continuation *continuation);

/* Follows the branch from far out until visit ends it or the approach reaches `end`. Status: PO_OK;
 * PO_STEP_TOO_SMALL, PO_TOO_MANY_POINTS with a message that says where; PO_NOT_CONVERGED when there
 * is no start; PO_OUT_OF_NODES; PO_NO_MEMORY. */
po_status po_continuation_run(po_continuation *continuation);

/* Turns round at the end, once, and follows the branch back to where it began, by steps and meshes
 * of its own. Visits the points on the way, the last one of the way out first: position grows on,
 * rates and the unstable modes just after a point are those of the reverse trace, so that these end
 * as 0; errors are those of folds. Special points beyond the one that ended the way out are left
 * out. Given: a continuation whose way out ended with PO_OK. Status: as po_continuation_run. */
po_status po_continuation_reverse(po_continuation *continuation, po_branch_visit visit, void *data);

#endif
