/* The preload that belongs to the pull-off of a branch, and the greatest pull-off force of all
 * preloads. */
#ifndef PO_PRESSED_H
#define PO_PRESSED_H

#include "po_estimate.h"
#include "po_path.h"
#include "po_request.h"
#include "po_result.h"
#include "po_stopping.h"

/* Gives a state at the position of a special point the approach and the load of that point.
 * Returned: the stated errors of the special point. The error of any other state, and of a special
 * point without an error, is the greatest error of the special points plus the distance of the
 * curve from its interpolation. Given: a result with special points. */
po_path_error po_pressed_state(const po_request *request, const po_result *result,
                               po_path_state *state);

/* Given: the path of the branch; the greatest errors of its special points; the state of the
 * stopping rule at its end; a result with special points, pull-off and the cause of the end of the
 * trace. Returned: in the result, the preload of the pull-off, the greatest pull-off of all
 * preloads, and the staircases with their errors if they are wanted. Status: PO_NO_MEMORY. */
po_status po_pressed_read(const po_request *request, const po_path *path,
                          const po_estimate *greatest, const po_stopping *stopping,
                          po_result *result);

#endif
