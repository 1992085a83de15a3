/* One scene, solved. */
#ifndef PO_OBSERVE_H
#define PO_OBSERVE_H

#include "po_request.h"
#include "po_result.h"

/* Traces the branch of a scene and reads off what the request wants.
 * Given: a request. Returned: a result, to be given to po_result_clear whatever the status.
 * Status: that of the result: PO_OK; PO_STEP_TOO_SMALL, PO_TOO_MANY_POINTS, PO_NOT_CONVERGED,
 * PO_INTERRUPTED, PO_OUT_OF_TIME (with reason, and with what was found until then); PO_BAD_INPUT,
 * PO_NO_MEMORY. The time limit is looked at after every converged point of the branch: a solve may
 * exceed it by the time of one such step. */
po_status po_observe(const po_request *request, po_result *result);

#endif
