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

/* Rings in which the gap is below a level, their edges linearly between nodes; the first may begin
 * on the axis, at 0. Level 0: the traction is compressive there. PO_LAW_PEAK_GAP: the bodies hold
 * together as in contact, the tension growing when they are pulled apart; what lies between two
 * such rings is a groove, an internal crack. */
typedef struct {
  double inner, outer; /* eps */
} po_contact_ring;

/* Given: n radii ascending (eps), n gaps; ring, n/2 + 1. Returned: how many rings, from the axis
 * out. */
size_t po_contact_rings(size_t n, const double *node, const double *gap, double level,
                        po_contact_ring *ring);

#endif
