/* Loading and unloading in the JKR theory of the wavy sphere (Eq 5), for comparison with a
 * solve. */
#ifndef PO_GUDURU_PATH_H
#define PO_GUDURU_PATH_H

#include "po_hysteresis.h"
#include "po_scene.h"
#include "po_staircase.h"

/* The curve of Eq 5: the separated bodies at load 0 up to the first contact at approach 0, then
 * every contact radius up to `end` (eps). Folds and extrema of the load are points; the energy is
 * integrated from the loads. `position` is the contact radius, negative before contact. The curve
 * begins farther out than every jump. Given: tabor > 0. Returned: *point, *count points, to be
 * freed. Status: PO_NO_MEMORY. Accuracy: special points to rounding, energies to 1e-12. */
po_status po_guduru_path(const po_scene *scene, double end, po_path_point **point, size_t *count);

/* The staircases of the curve of Eq 5 under displacement control and under load control. The curve
 * is extended until some preload gives the lowest load of the whole curve in both. Returned:
 * staircase, to be cleared whatever the status. Status: PO_BAD_INPUT for tabor 0, PO_NO_MEMORY. */
po_status po_guduru_staircases(const po_scene *scene, po_staircase staircase[2]);

/* Both loops of the curve of Eq 5, which is extended until it contains them; the outer radius of
 * the scene is not used. Status: PO_BAD_INPUT for tabor 0; otherwise as po_hysteresis_follow. */
po_status po_guduru_hysteresis(const po_scene *scene, po_preload preload,
                               po_hysteresis *hysteresis);

#endif
