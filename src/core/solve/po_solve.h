/* Solves one scene; and says how many nodes and how much memory that needs, before it is solved. */
#ifndef PO_SOLVE_H
#define PO_SOLVE_H

#include "po_request.h"
#include "po_result.h"
#include "po_size.h"

/* Traces the branch of a scene and computes what the request wants. Given: a request. Returned: a
 * result, which must be passed to po_result_clear whatever the status. Status: also stored in the
 * result: PO_OK; PO_STEP_TOO_SMALL, PO_TOO_MANY_POINTS, PO_NOT_CONVERGED, PO_INTERRUPTED,
 * PO_OUT_OF_TIME, with a reason and the results found so far; PO_BAD_INPUT, PO_NO_MEMORY. The time
 * limit is checked after every point of the branch, so that a solve may exceed it by the time of
 * one step. */
po_status po_solve(const po_request *request, po_result *result);

/* An upper estimate for a request that is valid. Accuracy: a solve needs between 1/8 of it and all
 * of it (tests/cost/size.py). A search of all preloads may need more than the estimate. */
po_size po_request_size(const po_request *request);

#endif
