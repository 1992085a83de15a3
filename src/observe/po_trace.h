/* One trace of the branch of a request, with its results. */
#ifndef PO_TRACE_H
#define PO_TRACE_H

#include "po_observe_parts.h"

/* The settings of one trace, which change if it is repeated. */
typedef struct {
  double core;      /* radius of the core of the surface, eps */
  double tolerance; /* of panels, relative */
  double begin; /* greatest approach at which the trace begins, eps; NAN: chosen by the solver */
  size_t unmet_folds; /* returned: number of folds not found on a finer mesh */
} po_attempt;

/* Traces the branch once. Given: rigid, whether the scene is solved without elasticity; the
 * settings; deadline, the processor time at which the function gives up; keeper, which receives
 * minima and folds, or NULL. Returned: result; a->begin is changed if unloading leads to a smaller
 * approach than the trace began with. Status: that of the trace; PO_NOT_FOUND if there is no
 * pull-off. */
po_status po_trace(const po_request *request, bool rigid, po_attempt *a, double deadline,
                   const po_keeper *keeper, po_result *result);

#endif
