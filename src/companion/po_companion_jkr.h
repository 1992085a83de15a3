/* The JKR theory of the wavy sphere (Eq 5) as the companion of a solve. */
#ifndef PO_COMPANION_JKR_H
#define PO_COMPANION_JKR_H

#include "po_request.h"

/* Its bound is NAN, and it has no loops, for a rigid scene. */
extern const po_companion PO_COMPANION_JKR;

#endif
