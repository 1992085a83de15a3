/* The rigid limit: no elasticity, the load by quadrature of Eq 17 over the undeformed gap. */
#ifndef PO_RIGID_H
#define PO_RIGID_H

#include <stdbool.h>

#include "po_scene.h"
#include "po_status.h"

/* Upper bound of the change of the load by elasticity, in pi w R: 6 mu^(3/2). */
double po_rigid_elastic_effect(const po_scene *scene);

/* Whether elasticity changes the load by less than 1e-8. */
bool po_rigid_suffices(const po_scene *scene);

/* W/(pi w R) of the rigid bodies at an approach < 1, and its derivative by the approach.
 * Given: scene (its Tabor parameter is not read). Returned: load and load_rate; status
 * PO_NOT_CONVERGED when the quadrature fails. Accuracy: 1e-10 of max(1, |load|) of a smooth scene
 * (tests/unit/test_rigid.c); 1e-9 of a wavy one, what po_averaging_radius may lose,
 * measured 9.4e-10 on every row of reference/rigid_integral.csv
 * (tests/theory/test_tables_surface.c). */
po_status po_rigid_load(const po_scene *scene, double approach, double *load, double *load_rate);

/* The energy of the interaction, U/(pi w R eps), zero when infinitely apart: its derivative by the
 * approach is the load. Accuracy: 1e-10 of max(1, |energy|) (tests/unit/test_energy.c). */
po_status po_rigid_energy(const po_scene *scene, double approach, double *energy);

/* Approach at which the central crest, of radius R/(1 + 4 pi^2 alpha) (Eq 18), pushes with `load`:
 * the repulsive term of Eq 23; at most 1 - 1e-3. */
double po_rigid_approach_of_crest(const po_scene *scene, double load);

#endif
