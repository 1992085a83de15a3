/* A point of a branch of equilibria, as the continuation gives it to its visitor. */
#ifndef PO_BRANCH_POINT_H
#define PO_BRANCH_POINT_H

#include <stdbool.h>
#include <stddef.h>

#include "po_status.h"

typedef enum {
  PO_POINT_STEP,         /* a step of the continuation */
  PO_POINT_APPROACH_MAX, /* fold: maximum of the approach along the branch */
  PO_POINT_APPROACH_MIN, /* fold: minimum of the approach */
  PO_POINT_LOAD_MAX,
  PO_POINT_LOAD_MIN,
  PO_POINT_STATION,      /* an approach that the options list */
  PO_POINT_STATION_LOAD, /* the load that the options name */
} po_point_kind;

/* Number of approaches that the options can list. */
enum { PO_STATIONS = 2 };

typedef struct {
  po_point_kind kind;
  double position;                             /* arclength from the start of the trace */
  double approach, load;                       /* Delta/eps, W/(pi w R) */
  double energy;                               /* U/(pi w R eps): dU/d(approach) is the load */
  double approach_correction, load_correction; /* of a special point, from a finer mesh: to be
                                                  added; 0 if none was computed */
  double approach_error,
      load_error; /* of a special point: estimated bounds; NAN if none was computed */
  bool unmet; /* the special point was not found on a finer mesh: it may be an artefact of this mesh
               */
  double approach_rate; /* d approach / ds */
  double load_rate;     /* d load / ds */
  int unstable_modes;   /* of the equilibrium at given approach, just after this point */
  size_t n;             /* nodes of the core */
  const double *node;   /* n: radii, eps, ascending; NULL for rigid scenes */
  const double *gap;    /* n: H at the nodes */
  const struct po_solution *solution; /* the complete solution, on panels; otherwise NULL */
  double turn; /* of a special point with errors: the derivative by the arclength of the rate that
                  vanishes there */
  /* For a special point with errors: the solution that has the corrected values, and the solution
   * on a finer mesh from which the errors were estimated; otherwise NULL. Valid during the visit
   * only. */
  const struct po_solution *best, *finer;
} po_branch_point;

/* Receives the points in their order along the branch. Returned: true to end the trace. */
typedef bool (*po_branch_visit)(const po_branch_point *point, void *data);

/* -- The error of the interpolation of the curve (approach, load) between two points, see
 * doc/method.md, "Prediction and correction" -- */

/* Distance of the curve from the straight line between the points: the sagitta of an arc that turns
 * as the curve does. */
double po_join_sagitta(const po_branch_point *from, const po_branch_point *to);

/* Distance of the curve from the cubic in the position with the rates at both points, from the
 * identity dU = W d(approach): the integral of the load over the approach along the cubic is
 * compared with the difference of the energies. Given: points whose energies are as accurate as
 * their loads. Accuracy: 10 % on an arc of 0.6 (tests/unit/test_join.c). */
double po_join_miss(const po_branch_point *from, const po_branch_point *to);

#endif
