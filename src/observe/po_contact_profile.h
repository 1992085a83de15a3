/* Gap and traction over the radius at one point of a branch, and its contact annuli. */
#ifndef PO_CONTACT_PROFILE_H
#define PO_CONTACT_PROFILE_H

#include "po_branch_point.h"
#include "po_result.h"
#include "po_surface.h"

/* Takes the profile at the nodes up to the end of the core, P = mu p; a rigid one from the
 * undeformed gap at the nodes of the surface, with P / mu when mu is 0. Returned: in the result, in
 * place of an earlier one. Status: PO_NO_MEMORY. */
po_status po_contact_profile_take(const po_scene *scene, const po_surface *surface,
                                  const po_branch_point *point, po_result *result);

#endif
