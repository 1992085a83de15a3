/* The unit of loads inside a solve.
 *
 * A profile that is not a sphere has no radius by which its load is of order one. Such a scene is
 * solved with a length of reference R' instead of its R, so that loads in pi w R' are as those of a
 * sphere in pi w R (po_scales.h); the coupling stays. The constants of the solver then mean the
 * same for every profile. The scene of the solve knows the ratio R'/R (po_scene.load_unit), by
 * which messages and results are converted back. Spheres are solved in their own unit, and a
 * profile C r^2 as the sphere of radius 1/(2C). */
#ifndef PO_LOAD_UNIT_H
#define PO_LOAD_UNIT_H

#include "po_request.h"
#include "po_result.h"

/* The request in the unit of its solve. Given: a request, which need not be valid. */
po_request po_load_unit_request(const po_request *request);

/* The preload of a request (po_request_preload), with its load in the unit of the scene that was
 * asked for: the default preload is the load 1 in the unit of the solve. */
po_preload po_load_unit_preload(const po_request *request);

/* Converts a result of the solve to the unit of the scene that was asked for. Given: the scene of
 * the solve. */
void po_load_unit_result(const po_scene *solved, po_result *result);

/* Converts a result to a unit of length that is `factor` times smaller. Loads stay. */
void po_load_unit_lengthen(po_result *result, double factor);

#endif
