/* A point of a branch of equilibria, as it is visited. */
#ifndef PO_BRANCH_POINT_H
#define PO_BRANCH_POINT_H

#include <stdbool.h>
#include <stddef.h>

#include "po_status.h"

typedef enum {
  PO_POINT_STEP,         /* a step of the continuation */
  PO_POINT_APPROACH_MAX, /* fold: the approach has a maximum along the branch */
  PO_POINT_APPROACH_MIN, /* fold: a minimum */
  PO_POINT_LOAD_MAX,
  PO_POINT_LOAD_MIN,
  PO_POINT_STATION, /* the approach asked for */
} po_point_kind;

/* Approaches that may be asked for. */
enum { PO_STATIONS = 2 };

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
  const struct po_solution *solution; /* all of it, on panels; else NULL */
  /* For a corrected special point: the solution that has the corrected values, and the solution on
   * a finer mesh from which its errors are estimated; else NULL. Valid while the point is visited.
   */
  const struct po_solution *best, *finer;
} po_branch_point;

/* Visits the points in order along the branch. Returned: true ends the trace. */
typedef bool (*po_branch_visit)(const po_branch_point *point, void *data);

#endif
