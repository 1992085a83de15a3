/* Gap and traction over the radius at one point of a branch, and its contact annuli. */
#ifndef PO_CONTACT_PROFILE_H
#define PO_CONTACT_PROFILE_H

#include "po_branch_point.h"
#include "po_result.h"
#include "po_surface.h"

/* Computes gap and traction P = mu p at the nodes of the core, for a rigid scene from the initial
 * gap at the nodes of the surface (if mu is 0, the traction is P/mu). Returned: *count points in
 * *profile, which is resized. Status: PO_NO_MEMORY. */
po_status po_contact_profile_fill(const po_scene *scene, const po_surface *surface,
                                  const po_branch_point *point, po_profile_point **profile,
                                  size_t *count);

/* The same, and the contact annuli. Returned: in the result, replacing an earlier profile. Status:
 * PO_NO_MEMORY. */
po_status po_contact_profile_take(const po_scene *scene, const po_surface *surface,
                                  const po_branch_point *point, po_result *result);

#endif
