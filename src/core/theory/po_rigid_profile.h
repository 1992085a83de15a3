/* Rigid bodies of any profile under any law (Derjaguin 1934): the load at an approach D is the
 * integral of p(f(r) - D) 2 pi r over r. On a paraboloid the pull-off is 2 pi w R at approach 0
 * under every law. */
#ifndef PO_RIGID_PROFILE_H
#define PO_RIGID_PROFILE_H

#include "po_scene.h"
#include "po_wavy_rigid.h"

/* The load, pi w R, and its derivative by the approach. Given: approach, eps, less than the
 * greatest that the law admits; the Tabor parameter of the scene is not looked at. For powers,
 * cones, hyperboloids and flat profiles without waves on an unbounded surface under Lennard-Jones,
 * Mie and Morse laws: Beta and Gamma functions. For all others: quadrature over the radius, the far
 * field of an unbounded surface by the law averaged over the waves. Status: PO_BAD_INPUT,
 * PO_NOT_CONVERGED, PO_NO_MEMORY, PO_TOO_MANY_POINTS. Accuracy: 1e-13 of the larger term where it
 * is closed, otherwise 1e-9 (tests/theory/test_tables_profiles.c). */
po_status po_rigid_profile_load(const po_scene *scene, double approach, double *load, double *rate);

/* The same by quadrature for all scenes: an independent route. */
po_status po_rigid_profile_quadrature(const po_scene *scene, double approach, double *load,
                                      double *rate);

/* The pull-off, the lowest minimum of the load over the approach. Status: as above, and
 * PO_NOT_FOUND. Accuracy: as the load; measured on every row of reference/rigid_profiles.csv. */
po_status po_rigid_profile_pull_off(const po_scene *scene, po_rigid_pull_off *pull_off);

/* The elastic displacement on the axis, eps, under the tractions of the rigid bodies at an
 * approach: 2 c times the integral of |p| over the radius, by the midpoint rule. Accuracy: some
 * percent. */
double po_rigid_profile_elongation(const po_scene *scene, double approach);

#endif
