/* The closed forms that are evaluated beside the numerical solution: the JKR theory (Eq 5, or that
 * of any profile) as the theories of a solve, and all theories beside its result. */
#ifndef PO_THEORY_FORCES_H
#define PO_THEORY_FORCES_H

#include "po_jkr.h"
#include "po_request.h"

/* The theories. For a rigid scene its bound is NAN and it has no loops. Its theories say what each
 * theory gives for the pull-off force, and whether its own assumptions hold in the computed state.
 * One that cannot be evaluated for the scene has a reason in place of a force. */
extern const po_theories PO_THEORY_FORCES;

/* -- Loading and unloading in the JKR theory of any profile. For the scenes of the paper the curve
 * is that of Eq 5 (po_guduru.h), for all others that of po_jkr_profile.h. -- */

/* The staircases of the JKR curve (see po_staircases_read). The curve is extended until some
 * preload gives the lowest load of the whole curve in all. Given: tabor > 0. Returned: staircase,
 * to be cleared whatever the status. Status: PO_NO_MEMORY; PO_BAD_INPUT and PO_TOO_MANY_POINTS as
 * po_jkr_profile_pull_off. */
po_status po_jkr_staircases(const po_scene *scene, po_control spring, po_staircases *staircases);

/* The loops of the JKR curve (see po_hysteresis_follow), which is extended until it contains them;
 * the outer radius of the scene is not used. Given: the most points of the curve; SIZE_MAX: no
 * limit beside that of every curve. Status: as po_jkr_staircases and po_hysteresis_follow;
 * PO_TOO_MANY_POINTS also if the curve has more. */
po_status po_jkr_hysteresis(const po_scene *scene, po_preload preload, po_control spring,
                            size_t most, po_hysteresis *hysteresis);

/* The JKR curve after a preload: loading at given approach from separation, with its jumps, up to
 * the preload, and the state with the greatest tension on the way back. */
typedef struct {
  po_contact reversal, pull_off;
  size_t loading_jumps; /* the first contact included */
} po_jkr_preloaded;

/* Given: a preload with a finite approach or load. Returned: state; its pull-off has load 0 and
 * contact radius 0 if the preload makes no contact. Status: as po_jkr_hysteresis. Accuracy: 1e-13
 * of the largest term (tests/cli/test_theory_states.py). */
po_status po_jkr_after_preload(const po_scene *scene, po_preload preload, po_jkr_preloaded *state);

#endif
