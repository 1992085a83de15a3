/* The branch of equilibria, traced from far apart by pseudo-arclength continuation, with its folds
 * in the approach and its extrema of the load. See doc/method.md, "The branch".
 *
 * Each step predicts the equilibrium at a given value of the arclength functional (po_arclength.h)
 * from the cubic through the last two points (po_prediction.h), corrects the prediction by Newton's
 * method (po_corrector.h), locates the special points of the step (po_special_point.h), and gives
 * all points to the visitor. The length of a step is chosen so that the error of the prediction,
 * relative to 1 + H, has a given value. A step is repeated with a smaller length if the solution is
 * too far from its prediction or the direction turned too far, so that the trace stays on the
 * branch and does not pass over a part of it.
 *
 * On panels, each point is solved on a mesh that resolves its traction, predictions are made in
 * coordinates that move with the contact edges, and special points are solved again on a finer
 * mesh. A fixed mesh is the simple case without these. */
#ifndef PO_CONTINUATION_H
#define PO_CONTINUATION_H

#include "po_branch_point.h"
#include "po_resolution.h"

typedef struct {
  /* approaches, eps, at which a point is computed each time the branch passes them; NAN: none */
  double station[PO_STATIONS];
  double station_load; /* the same for a load, pi w R */
  double end;          /* approach, eps, at which the trace ends if it is met; NAN: none */
  double begin; /* approach, eps, at which the trace starts, or farther out, if it is below the one
                   that the solver chooses; NAN: none */
  double
      largest_sagitta; /* of the chord of a step in the plane of approach and load: the greatest
                          allowed distance of the curve from a straight line between its points */
  double largest_miss; /* the same for the cubic with the rates at both ends, po_join_miss; INFINITY
                          on a fixed mesh, where the energy is less accurate than the load */
  double sharpness; /* relative error of a minimum of the load above which it is solved again on a
                       finer mesh; panels only */
  bool minima_only; /* errors are estimated for minima of the load only, not for folds */
  size_t most_points;
  po_branch_visit visit;
  void *data;
} po_continuation_options;

/* Defaults: no stations, no end, no limits on sagitta and error, 30000 points. The caller sets
 * `visit`. */
po_continuation_options po_continuation_options_default(void);

typedef struct po_continuation po_continuation;

/* Given: an equilibrium; the errors that the resolution of the panels of its surface may leave;
 * options, which are copied. Equilibrium and the data of the options must outlive the continuation,
 * which meshes a surface of panels anew along the branch. Status: PO_NO_MEMORY. */
po_status po_continuation_create(po_equilibrium *equilibrium, po_allowance allowed,
                                 const po_continuation_options *options,
                                 po_continuation **continuation);
void po_continuation_destroy(po_continuation *continuation);

/* Traces the branch from far apart until the visitor ends the trace or the approach reaches `end`.
 * Status: PO_OK; PO_STEP_TOO_SMALL, PO_TOO_MANY_POINTS, with a message that states the place;
 * PO_NOT_CONVERGED if the first equilibrium is not found or the branch returns to its beginning;
 * PO_OUT_OF_NODES; PO_NO_MEMORY. */
po_status po_continuation_run(po_continuation *continuation);

/* The reverse trace: traces the branch from its end back to its beginning, with its own steps and
 * meshes. The first point visited is the last of the forward trace. The position continues to grow;
 * rates, and the unstable modes just after a point, are those of the reverse direction, so that the
 * unstable modes end at 0. Special points beyond the end of the forward trace are not visited.
 * Given: a continuation whose forward trace ended with PO_OK; once only. Status: as
 * po_continuation_run. */
po_status po_continuation_reverse(po_continuation *continuation, po_branch_visit visit, void *data);

#endif
