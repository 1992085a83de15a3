/* Radii read off one equilibrium. */
#ifndef PO_CONTACT_H
#define PO_CONTACT_H

#include <stddef.h>

#include "po_scene.h"

/* The contact radius: the outermost radius at which the gap passes that of the greatest tension,
 * H = 3^(1/6) - 1 (after Eq 9), linearly between nodes; 0 when the bodies are farther apart
 * everywhere. Given: n radii ascending (eps), n gaps. Returned: eps. */
double po_contact_radius(size_t n, const double *node, const double *gap);

/* The same for the undeformed gap at an approach, exactly. */
double po_contact_radius_rigid(const po_scene *scene, double approach);

#endif
