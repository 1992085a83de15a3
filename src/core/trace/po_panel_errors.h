/* What the nodes of the panels miss of the load and of the energy of a solution. See doc/method.md,
 * "Errors". */
#ifndef PO_PANEL_ERRORS_H
#define PO_PANEL_ERRORS_H

#include "po_branch_point.h"
#include "po_scene.h"
#include "po_solution.h"

/* Estimated bounds of the errors of the energy and the load of any point of a branch at its
 * approach, pi w R eps and pi w R; NAN for rings and triangles. */
typedef struct {
  double energy, load;
} po_point_error;

/* Those of the panels. */
po_point_error po_panel_errors(const po_scene *scene, const po_solution *solution);

/* Errors of a special point by the joints of the profile inside panels (po_profile_next_joint), at
 * least: eps, pi w R, pi w R eps. One finer mesh may show nothing of them: the error of the
 * integrals over a panel goes with the place of the joint, and its change by halving the panel may
 * vanish by chance. Load and energy are those that the nodes miss at the given deflection, the load
 * less as the surface gives way to it; a load that is missed at the radius s deflects the surface
 * by about coupling times it over s; and an extremum of the load moves by the rate of the load that
 * is missed over the second derivative. */
typedef struct {
  double approach, load, energy;
  double gap; /* of the gap at the approach of the solution */
} po_joint_errors;

/* Given: a special point during its visit. Returned: 0 without the solution `best`. */
po_joint_errors po_joint_errors_of(const po_scene *scene, const po_branch_point *point);

#endif
