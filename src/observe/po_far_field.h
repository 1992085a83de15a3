/* The error of the far field of an unbounded surface: of the average over the waves beyond the
 * domain, and of the polynomial of the panel to infinity. A finer mesh does not show it. See
 * doc/method.md, "Errors". */
#ifndef PO_FAR_FIELD_H
#define PO_FAR_FIELD_H

#include "po_scene.h"
#include "po_solution.h"

/* Bounds of the errors by the far field of load, approach, and energy of the interaction, pi w R,
 * eps and pi w R eps. */
typedef struct {
  double load, approach, energy;
} po_far_field;

/* Returned: the bounds; 0 on a cut surface. Given: a solution on panels. */
po_far_field po_far_field_of(const po_scene *scene, const po_solution *solution);

/* Returned: the bound of the error of the energy of a rigid scene by the average over the waves. */
double po_far_field_rigid_energy(const po_scene *scene, double approach);

#endif
