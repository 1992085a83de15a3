/* Makes the diagnostics of an outcome: inside observe. */
#ifndef PO_DIAGNOSE_H
#define PO_DIAGNOSE_H

#include "po_adaptive.h"
#include "po_outcome.h"

/* Diagnoses the states kept of a trace. Given: the equilibrium they are of, and its panels (NULL:
 * the mesh stays). Returned: in the outcome. Status: PO_NO_MEMORY. */
po_status po_diagnose_states(const po_kept *kept, po_equilibrium *e, po_adaptive *panels,
                             po_outcome *outcome);

/* Solves the scene again with each input moved. Given: a request that succeeded, its outcome.
 * Status: PO_NO_MEMORY, PO_INTERRUPTED. */
po_status po_diagnose_moved(const po_request *request, po_outcome *outcome);

#endif
