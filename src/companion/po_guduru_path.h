/* Loading and unloading as the JKR theory of the wavy sphere (Eq 5) has them, beside a solve. */
#ifndef PO_GUDURU_PATH_H
#define PO_GUDURU_PATH_H

#include "po_hysteresis.h"
#include "po_scene.h"
#include "po_staircase.h"

/* The curve of Eq 5: the bodies apart without a load up to the first touch at approach 0, then
 * every contact radius up to `end` (eps), folds and extrema of the load among the points, the
 * energy by quadrature of the loads. `position` is the contact radius, below 0 when apart. It
 * begins farther out than any jump. Given: tabor > 0. Returned: points to be freed. Status:
 * PO_NO_MEMORY. Accuracy: special points to rounding, energies to 1e-12. */
po_status po_guduru_path(const po_scene *scene, double end, po_path_point **point, size_t *count);

/* The staircases of that curve in displacement and in load control, as far as some preload gives
 * the least load of the whole curve in both. To be cleared, whatever the status: PO_BAD_INPUT for
 * tabor 0, PO_NO_MEMORY. */
po_status po_guduru_staircases(const po_scene *scene, po_staircase staircase[2]);

/* Both loops of that curve, as long as they need it; the outer radius of the scene is not looked
 * at. Status: PO_BAD_INPUT for tabor 0; as po_hysteresis_follow. */
po_status po_guduru_hysteresis(const po_scene *scene, po_preload preload,
                               po_hysteresis *hysteresis);

#endif
