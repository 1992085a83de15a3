/* The error of the energy of a solution on panels, at its approach. See doc/method.md, "Errors". */
#ifndef PO_ENERGY_ERROR_H
#define PO_ENERGY_ERROR_H

#include "po_branch_point.h"
#include "po_scene.h"

/* An estimated bound of the error of the energy of any point of a branch at its approach, pi w R
 * eps; NAN for rings and triangles. Given: domain, the radius of the panels, eps, and the precision
 * of Newton's method (panels only). */
double po_energy_error(const po_scene *scene, double domain, double precision,
                       const po_branch_point *point);

#endif
