/* The closed forms that are evaluated beside the numerical solution: the JKR theory (Eq 5, or that
 * of any profile) as the companion of a solve, and all theories beside its result. */
#ifndef PO_COMPANION_JKR_H
#define PO_COMPANION_JKR_H

#include "po_request.h"

/* The companion. For a rigid scene its bound is NAN and it has no loops. */
extern const po_companion PO_COMPANION_JKR;

/* The theories beside a result: what each says about the pull-off force, and whether its own
 * assumptions hold in the computed state. Each is evaluated by a closed form of src/theory, for the
 * scene alone; no theory reads the value of another one, nor the computed force. Fills
 * result->theories with a row for every theory, in the order of PO_THEORY_ROWS. One that cannot be
 * evaluated for the scene has a reason in place of a force. Given: a request that was solved with
 * PO_WANT_THEORIES, and its result. Status: PO_NO_MEMORY, PO_INTERRUPTED, PO_OUT_OF_TIME. */
po_status po_beside_theories(const po_request *request, po_result *result);

#endif
