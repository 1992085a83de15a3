/* The error of the far field of an unbounded surface: of the average over the waves beyond the
 * domain, and of the polynomial of the panel to infinity. A finer mesh does not show it. See
 * doc/method.md, "Errors". */
#ifndef PO_FAR_FIELD_H
#define PO_FAR_FIELD_H

#include "po_scene.h"
#include "po_solution.h"

/* Bounds of the errors of the load and of the approach, pi w R and eps; 0 on a cut surface. Given:
 * domain, the radius of the panels, eps; a solution on panels. */
typedef struct {
  double load, approach;
} po_far_field;

po_far_field po_far_field_error(const po_scene *scene, double domain, const po_solution *solution);

#endif
