/* Makes the diagnostics of an outcome: inside observe. */
#ifndef PO_DIAGNOSE_H
#define PO_DIAGNOSE_H

#include "po_adaptive.h"
#include "po_outcome.h"

/* Diagnoses the states kept of a trace. Given: the processor time, on po_clock_thread, at which it
 * gives up; the equilibrium the states are of, and its panels (NULL: the mesh stays). Returned: in
 * the outcome. Status: PO_NO_MEMORY, PO_OUT_OF_TIME. */
po_status po_diagnose_states(const po_request *request, double deadline, const po_kept *kept,
                             po_equilibrium *e, po_adaptive *panels, po_outcome *outcome);

/* Solves the scene again with each input moved. Given: a request that succeeded, its outcome; the
 * processor time at which it gives up. Status: PO_NO_MEMORY, PO_INTERRUPTED, PO_OUT_OF_TIME. */
po_status po_diagnose_moved(const po_request *request, double deadline, po_outcome *outcome);

#endif
