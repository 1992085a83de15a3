/* The visitor of a trace. It reads path and curve, special points, pull-off and profile off the
 * branch, and passes each point to the diagnostics (po_diagnose.h) and to the
 * stopping rule (po_stopping.h). It ends the trace if one of these, the user or the time limit
 * requires it. */
#ifndef PO_COLLECTOR_H
#define PO_COLLECTOR_H

#include "po_branch_point.h"
#include "po_diagnose.h"
#include "po_estimate.h"
#include "po_path.h"
#include "po_request.h"
#include "po_result.h"
#include "po_stopping.h"
#include "po_trace.h"

/* The special points of the result, folds and extrema of the load: sizes of their lists. */
typedef struct {
  size_t fold_room, extremum_room;
  size_t unmet_folds;   /* number of folds that were not found on a finer mesh */
  po_estimate greatest; /* the greatest errors of all special points; NAN: none was estimated */
} po_special_list;

/* The points of a trace: all of them as the path from which loading, unloading and staircases are
 * computed. The curve of the result is without the first ones, which are not recorded. */
typedef struct {
  po_curve_point *path; /* owned */
  size_t count, room;
  size_t before; /* number of the first points, which are not recorded */
} po_trace_points;

/* The energy balance dU = W d(approach) along a branch. It is violated if a state belongs to
 * another branch, or if load and energy are inconsistent. */
typedef struct {
  po_branch_point last; /* its pointers are not used */
  bool begun;
  double gained, done; /* since the first point: change of the energy, and work along cubics through
                          the points */
  double worst;        /* largest difference of the two so far */
  double lowest, highest; /* range of the change of the energy */
  double at;              /* approach at the largest difference, eps */
} po_balance;

typedef struct {
  const po_request *request;
  const po_surface *surface; /* for a rigid scene, its nodes only */
  po_result *result;
  po_kept_points *for_series; /* special points to continue from; NULL: none are kept */
  size_t most_points;         /* of po_attempt */
  bool diagnoses;             /* diagnostics are wanted, which the next two need */
  po_balance balance;         /* energy balance */
  po_kept kept;               /* states and special points for them */
  double begin; /* points are recorded from the first one with at least this approach */
  bool begun;
  po_stopping stopping;
  po_trace_points points;
  po_special_list special;
  size_t most_nodes; /* largest number of nodes so far */
  po_status status;
} po_collector;

/* Frees the memory of a collector, after storing the energy balance in the result and giving it the
 * curve, of which it has none before. */
void po_collector_end(po_collector *collector);

/* What a stop means for the trace: the end of a search of limited effort, otherwise a failure.
 * Given: why, PO_INTERRUPTED or PO_OUT_OF_TIME; the last point, NAN if there is none. */
po_status po_collector_stop(po_collector *collector, po_status why, double approach, double load);

/* A po_branch_visit; `data` is the collector. Ends the trace on interruption, at the deadline, on a
 * failure of a part, or where the stopping rule ends it. */
bool po_collector_visit(const po_branch_point *point, void *data);

/* The same for the reverse trace. Ends it on interruption, at the deadline, or if there is no
 * memory. */
bool po_collector_visit_back(const po_branch_point *point, void *data);

/* Computes what a test along the traced branch gives (po_loading.c). Given: a trace that
 * succeeded, whose result has the special points, the pull-off and the cause of the end.
 * Returned: in the result, the preload of the pull-off, the greatest pull-off of all
 * preloads, and the staircases and loops with their errors if they are wanted. If unloading leads
 * to a smaller approach than the trace began with, *begin is set instead of the loops, and the
 * trace must be repeated. Status: PO_NO_MEMORY. */
po_status po_loading_compute(const po_collector *collector, double *begin);

#endif
