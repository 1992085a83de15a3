/* The rigid limit: the load and the energy by quadrature of Eq 17 over the initial gap, without
 * deflection. See doc/method.md, "Rigid scenes". */
#ifndef PO_RIGID_H
#define PO_RIGID_H

#include <stdbool.h>

#include "po_scene.h"
#include "po_status.h"

/* Upper bound of the change of the load by elasticity, in pi w R. */
double po_rigid_elastic_effect(const po_scene *scene);

/* Whether elasticity changes the load by less than 1e-8. */
bool po_rigid_suffices(const po_scene *scene);

/* W/(pi w R) of the rigid bodies at an approach < 1, and its derivative by the approach.
 * Given: scene (the Tabor parameter is not used); approach, eps. Returned: load, and load_rate in
 * pi w R / eps. Status: PO_NOT_CONVERGED if the quadrature fails; PO_OUT_OF_NODES if there are too
 * many waves. Source: Eqs 16, 17; for a wavy sphere also Eq 22. Accuracy: 1e-10 relative to max(1,
 * |load|) for a smooth scene (tests/unit/test_rigid.c); 1e-9 for a wavy scene, the error allowed by
 * po_averaging_radius, measured 9.4e-10 at most on the rows of reference/rigid_integral.csv
 * (tests/theory/test_tables_surface.c). */
po_status po_rigid_load(const po_scene *scene, double approach, double *load, double *load_rate);

/* The energy of the interaction, U/(pi w R eps), zero when the bodies are infinitely far apart. Its
 * derivative with respect to the approach is the load. Accuracy: 1e-10 relative to max(1, |energy|)
 * (tests/unit/test_energy.c), and the average over the waves beyond po_rigid_end. */
po_status po_rigid_energy(const po_scene *scene, double approach, double *energy);

/* The radius, eps, from which on the waves of an unbounded scene are averaged at an approach.
 * Given: whether energies are relative to that at approach 0 (po_scene_has_infinite_energy). */
double po_rigid_end(const po_scene *scene, double approach, bool from_zero);

/* Approach, eps, at which the repulsion of the central crest alone equals `load`, pi w R: the crest
 * has the radius R/(1 + 4 pi^2 alpha) of Eq 18, and its load is the repulsive term of Eq 23. */
double po_rigid_approach_of_crest(const po_scene *scene, double load);

#endif
