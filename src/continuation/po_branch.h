/* The branch of equilibria, followed from far out by pseudo-arclength continuation, with its folds
 * in approach and its extrema of the load.
 *
 * Metric: ds^2 = sum over nodes of (length_j / r0) (dH_j / (1 + H_j))^2 + APPROACH_WEIGHT
 * dapproach^2, r0 = sqrt(2R) the radius at which the undeformed gap is eps; nodes with gaps above
 * ten do not count. The step is set so that cubic extrapolation from the two points before errs by
 * a set part of 1 + H: a corrected point that is not where the branch was heading, or a tangent
 * that turned too far, is not accepted, so that the branch is neither left nor cut short silently.
 */
#ifndef PO_BRANCH_H
#define PO_BRANCH_H

#include <stdbool.h>
#include <stddef.h>

#include "po_equilibrium.h"

typedef enum {
  PO_POINT_STEP,         /* a step of the continuation */
  PO_POINT_APPROACH_MAX, /* fold: the approach has a maximum along the branch */
  PO_POINT_APPROACH_MIN, /* fold: a minimum */
  PO_POINT_LOAD_MAX,
  PO_POINT_LOAD_MIN,
  PO_POINT_STATION, /* the approach asked for */
} po_point_kind;

typedef struct {
  po_point_kind kind;
  double position;       /* arclength from the start */
  double approach, load; /* Delta/eps, W/(pi w R) */
  double energy;         /* U/(pi w R eps): its rate by approach is the load */
  double approach_correction, load_correction; /* by a finer mesh, of a special point; 0: none */
  double approach_error,
      load_error;       /* of a special point so corrected: bounds, estimated; NAN: not */
  bool unmet;           /* by a finer mesh: the special point may be of this one */
  double approach_rate; /* d approach / ds */
  double load_rate;     /* d load / ds */
  int unstable_modes;   /* of the equilibrium at fixed approach, just after this point */
  size_t n;             /* nodes of the core */
  const double *node;   /* n: their radii, eps, ascending; NULL when rigid */
  const double *gap;    /* n: H there */
  const struct po_track_point *track; /* all of it, on panels; else NULL */
  /* For a corrected special point: the solution that has the corrected values, and the solution on
   * a finer mesh from which its errors are estimated; else NULL. Valid while the point is visited.
   */
  const struct po_track_point *best, *finer;
} po_branch_point;

/* Told every point in order along the branch; true ends the trace. */
typedef bool (*po_branch_visit)(const po_branch_point *point, void *data);

enum { PO_STATIONS = 2 };

typedef struct {
  /* approaches at which exact points are wanted, each time the branch passes them; NAN: none */
  double station[PO_STATIONS];
  double end;   /* approach at which the trace ends, if met; NAN: none */
  double begin; /* the trace starts here when that is farther out than it needs; NAN: no */
  double largest_sagitta; /* of a step's chord, in the plane of approach and load: how far from the
                             curve a drawing by straight lines may be */
  double largest_miss;    /* likewise of the cubic with the rates at both ends; heeded on panels */
  double sharpness;       /* relative error of a minimum of the load for which it is solved again on
                             a finer mesh; heeded on panels */
  bool minima_only;       /* nobody asks for the errors of folds */
  size_t most_points;
  po_branch_visit visit;
  void *data;
} po_branch_options;

/* No station, no end, steps and minima free, 30000 points; visit to be set. */
po_branch_options po_branch_options_default(void);

/* Follows the branch of a surface from far out until visit ends it or the approach reaches `end`.
 * Status: PO_OK; PO_STEP_TOO_SMALL, PO_TOO_MANY_POINTS with a message that says where;
 * PO_NOT_CONVERGED when there is no start; PO_NO_MEMORY. */
po_status po_branch_trace(po_equilibrium *equilibrium, const po_branch_options *options);

/* Where the trace starts: the approach, a negative power of two, at which the feedback of the
 * undeformed gap is below a quarter, so that there is one equilibrium there and Newton finds it. */
double po_branch_start(po_equilibrium *equilibrium);

#endif
