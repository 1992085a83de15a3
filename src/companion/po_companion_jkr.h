/* The closed forms that are evaluated beside the numerical solution: the JKR theory (Eq 5, or that
 * of any profile) as the companion of a solve, and all theories beside its result. */
#ifndef PO_COMPANION_JKR_H
#define PO_COMPANION_JKR_H

#include "po_request.h"

/* The companion. For a rigid scene its bound is NAN and it has no loops. Its theories say what each
 * theory gives for the pull-off force, and whether its own assumptions hold in the computed state.
 * One that cannot be evaluated for the scene has a reason in place of a force. */
extern const po_companion PO_COMPANION_JKR;

#endif
