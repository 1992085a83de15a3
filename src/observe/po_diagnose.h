/* Computes the diagnostics of a result. Private to the room. */
#ifndef PO_DIAGNOSE_H
#define PO_DIAGNOSE_H

#include "po_adaptive.h"
#include "po_equilibrium.h"
#include "po_kept.h"
#include "po_request.h"
#include "po_result.h"

/* Diagnoses the states kept of a trace. Given: deadline, the processor time (po_clock_thread) at
 * which the function gives up; the equilibrium of the trace, and its panels (NULL for a fixed
 * mesh). Returned: in the result. Status: PO_NO_MEMORY, PO_OUT_OF_TIME. */
po_status po_diagnose_states(const po_request *request, double deadline, const po_kept *kept,
                             po_equilibrium *e, po_adaptive *panels, po_result *result);

/* Solves the scene again with each parameter changed by one unit in the last place. Given: a
 * request that succeeded, and its result; deadline as above. Status: PO_NO_MEMORY, PO_INTERRUPTED,
 * PO_OUT_OF_TIME. */
po_status po_diagnose_moved(const po_request *request, double deadline, po_result *result);

/* Fails with PO_OUT_OF_TIME and a message that the branch is traced, followed by `what`. */
po_status po_diagnose_out_of_time(const po_request *request, const char *what);

#endif
