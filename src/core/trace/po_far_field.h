/* The far field of an unbounded surface: the waves beyond the domain of the panels are averaged,
 * and a polynomial in 1/r stands for the traction there. What both leave out is common to all
 * meshes, so that a finer mesh does not show it. See doc/method.md, "The far field" and "Errors".
 */
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

/* Returned: the least core (eps) >= core, of a geometric sequence, with whose domain the polynomial
 * misses less than a tenth of the tolerance of the load: beyond it a profile whose gap is no power
 * of the radius, as a table or a wide flat body, must not have much of the load. The given core if
 * there is none. */
double po_far_field_core(const po_scene *scene, double core, double tolerance);

#endif
