/* The error of the energy of a solution on panels, at its approach; and that of the far field of an
 * unbounded surface, which a finer mesh does not show. See doc/method.md, "Errors". */
#ifndef PO_ENERGY_ERROR_H
#define PO_ENERGY_ERROR_H

#include "po_branch_point.h"
#include "po_scene.h"
#include "po_solution.h"

/* Bounds of the errors of the load and of the approach, pi w R and eps; 0 on a cut surface. Given:
 * domain, the radius of the panels, eps; a solution on panels. */
typedef struct {
  double load, approach;
} po_far_field;

/* An estimated bound of the error of the energy of any point of a branch at its approach, pi w R
 * eps; NAN for rings and triangles. Given: domain, the radius of the panels, eps, and the precision
 * of Newton's method (panels only). */
double po_energy_error(const po_scene *scene, double domain, double precision,
                       const po_branch_point *point);

po_far_field po_far_field_error(const po_scene *scene, double domain, const po_solution *solution);

#endif
