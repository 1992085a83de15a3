/* The JKR theory (Eq 5, or that of any profile) as the companion of a solve: the closed form that
 * is evaluated beside the numerical solution. */
#ifndef PO_COMPANION_JKR_H
#define PO_COMPANION_JKR_H

#include "po_request.h"

/* The companion. For a rigid scene its bound is NAN and it has no loops. */
extern const po_companion PO_COMPANION_JKR;

#endif
