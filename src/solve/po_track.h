/* The branch on panels that follow the contact: continuation in coordinates that move with the
 * edges of the contact, each point on a mesh of its own. Visits as po_branch_trace does. */
#ifndef PO_TRACK_H
#define PO_TRACK_H

#include "po_adaptive.h"
#include "po_branch.h"
#include "po_resolution.h"

/* Given: an equilibrium on the surface of `adaptive`, with room for its capacity; what the
 * resolution of the traction may leave. Status: as po_branch_trace,
 * PO_OUT_OF_NODES. */
po_status po_track_trace(po_equilibrium *equilibrium, po_adaptive *adaptive, po_allowance allowed,
                         const po_branch_options *options);

#endif
