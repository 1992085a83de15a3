/* One trace of a request's branch, read off as it goes. */
#ifndef PO_TRACE_H
#define PO_TRACE_H

#include "po_observe_parts.h"

/* What a trace is made with, and made anew with. */
typedef struct {
  double core;        /* of the surface, eps */
  double tolerance;   /* of panels */
  double begin;       /* approach it begins at, if not farther out; NAN: what the solver takes */
  size_t unmet_folds; /* returned: folds that a finer mesh did not meet */
} po_attempt;

/* Given: whether the surfaces are rigid; processor time at which it gives up; somebody who keeps
 * the minima, or NULL. Returned: result; *a, where it is to be changed for hysteresis. Status: of
 * the trace; PO_NOT_FOUND without a pull-off. */
po_status po_trace(const po_request *request, bool rigid, po_attempt *a, double deadline,
                   const po_keeper *keeper, po_result *result);

#endif
