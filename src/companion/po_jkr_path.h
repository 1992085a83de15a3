/* Loading and unloading in the JKR theory of any profile, for comparison with a solve. For the
 * scenes of the paper the curve is that of Eq 5 (po_guduru.h), for all others that of
 * po_jkr_profile.h. */
#ifndef PO_JKR_PATH_H
#define PO_JKR_PATH_H

#include "po_loop.h"
#include "po_scene.h"
#include "po_staircase.h"

/* The JKR curve: the separated bodies at load 0 up to the first contact at approach 0, then every
 * contact radius up to `end` (eps). Folds and extrema of the load are points; the energy is
 * integrated from the loads. `position` is the contact radius, negative before contact; beyond an
 * edge b of the profile it is b + sqrt(a^2 - b^2). A corner is two points at one position. The
 * curve begins farther out than every jump. Given: tabor > 0. Returned: *point, *count points, to
 * be freed. Status: PO_NO_MEMORY; PO_BAD_INPUT and PO_TOO_MANY_POINTS as po_jkr_profile_pull_off.
 * Accuracy: special points to rounding, energies to 1e-12. */
po_status po_jkr_path(const po_scene *scene, double end, po_path_point **point, size_t *count);

/* The staircases of the JKR curve (see po_staircases_read). The curve is extended until some
 * preload gives the lowest load of the whole curve in all. Returned: staircase, to be cleared
 * whatever the status. Status: as po_jkr_path. */
po_status po_jkr_staircases(const po_scene *scene, po_control spring, po_staircases *staircases);

/* The loops of the JKR curve (see po_hysteresis_follow), which is extended until it contains them;
 * the outer radius of the scene is not used. Status: as po_jkr_path and po_hysteresis_follow. */
po_status po_jkr_hysteresis(const po_scene *scene, po_preload preload, po_control spring,
                            po_hysteresis *hysteresis);

/* The same with a curve of `most` points at most. Status: also PO_TOO_MANY_POINTS. */
po_status po_jkr_hysteresis_within(const po_scene *scene, po_preload preload, po_control spring,
                                   size_t most, po_hysteresis *hysteresis);

#endif
