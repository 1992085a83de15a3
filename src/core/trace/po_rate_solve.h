/* The pull-off of a viscoelastic body. */
#ifndef PO_RATE_SOLVE_H
#define PO_RATE_SOLVE_H

#include "po_request.h"
#include "po_result.h"
#include "po_surface.h"
#include "po_trace.h"

/* Loads the relaxed body to the preload and unloads it at the speed of the request. Given: the
 * request, which was checked; core and tolerance of the attempt; its surface of panels. Returned:
 * result, whatever the status. Status: those of po_trace; PO_OUT_OF_DOMAIN if the core is too
 * small; PO_NOT_FOUND if the preload is not reached or there is no tension. */
po_status po_rate_solve(const po_request *request, const po_attempt *a, po_surface *surface,
                        po_result *result);

#endif
