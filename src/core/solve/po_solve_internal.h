/* Parts of a solve, of which the first is shared with series of scenes. */
#ifndef PO_SOLVE_INTERNAL_H
#define PO_SOLVE_INTERNAL_H

#include "po_request.h"
#include "po_result.h"
#include "po_trace.h"

/* po_solve without the theories and without the solves with changed inputs. Given: kept,
 * empty but for `which`, or NULL. Returned: kept, to be cleared whatever the status. */
po_status po_solve_kept(const po_request *request, po_kept_points *kept, po_result *result);

/* Solves the scene again: for the diagnostics with each parameter changed by one unit in the last
 * place; and for the uncertainty of a pull-off with each uncertain input, and with the profile
 * changed by its noise, both ways (doc/method.md, "Uncertain inputs"). Given: a request that
 * succeeded, and its result. A solve that fails is not a failure. Status: PO_NO_MEMORY,
 * PO_INTERRUPTED, PO_OUT_OF_TIME, also by the deadline (po_deadline.h). */
po_status po_solve_changed(const po_request *request, po_result *result);

#endif
