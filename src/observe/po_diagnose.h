/* Makes the diagnostics of a result: inside observe. */
#ifndef PO_DIAGNOSE_H
#define PO_DIAGNOSE_H

#include "po_adaptive.h"
#include "po_request.h"
#include "po_result.h"

/* Diagnoses the states kept of a trace. Given: the processor time, on po_clock_thread, at which it
 * gives up; the equilibrium the states are of, and its panels (NULL: the mesh stays). Returned: in
 * the result. Status: PO_NO_MEMORY, PO_OUT_OF_TIME. */
po_status po_diagnose_states(const po_request *request, double deadline, const po_kept *kept,
                             po_equilibrium *e, po_adaptive *panels, po_result *result);

/* Solves the scene again with each input moved. Given: a request that succeeded, its result; the
 * processor time at which it gives up. Status: PO_NO_MEMORY, PO_INTERRUPTED, PO_OUT_OF_TIME. */
po_status po_diagnose_moved(const po_request *request, double deadline, po_result *result);

/* Fails with PO_OUT_OF_TIME, saying that the branch is traced and `what` is not complete. */
po_status po_diagnose_out_of_time(const po_request *request, const char *what);

#endif
