/* The branch on panels that follow the contact: continuation in coordinates that move with the
 * edges of the contact, each point on a mesh of its own. Visits as po_branch_trace does. */
#ifndef PO_TRACK_H
#define PO_TRACK_H

#include "po_adaptive.h"
#include "po_branch.h"
#include "po_resolution.h"

typedef struct po_tracker po_tracker;

/* Given: an equilibrium on the surface of `adaptive`, with room for its capacity, which both must
 * outlive the tracker; what the resolution of the traction may leave; options (copied, their data
 * must outlive it). Status: PO_NO_MEMORY. */
po_status po_track_create(po_equilibrium *equilibrium, po_adaptive *adaptive, po_allowance allowed,
                          const po_branch_options *options, po_tracker **tracker);
void po_track_destroy(po_tracker *tracker);

/* Follows the branch from far out to its end. Status: as po_branch_trace, PO_OUT_OF_NODES. */
po_status po_track_onwards(po_tracker *tracker);

/* Turns round at the end, once, and follows the branch back to where it began, by steps and meshes
 * of its own. Tells a visitor the points on the way, the last one of the way out first: position
 * grows on, rates and the unstable modes just after a point are those of the reverse trace, so that
 * these end as 0; errors are those of folds. Special points beyond the one that ended the way out
 * are left out. Given: a tracker whose way out ended with PO_OK. Status: as po_track_onwards. */
po_status po_track_back(po_tracker *tracker, po_branch_visit visit, void *data);

#endif
