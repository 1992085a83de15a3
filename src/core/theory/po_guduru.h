/* The JKR theory of the wavy sphere: short-range adhesion, compact contact area (Guduru 2007),
 * Eq 5. */
#ifndef PO_GUDURU_H
#define PO_GUDURU_H

#include "po_jkr.h"

/* The search for minima and folds of Eq 5 begins at this fraction of the first wavelength: those of
 * a sharp crest may lie close to the axis. */
extern const double PO_GUDURU_FIRST;

/* The equilibrium of Eq 5 at a contact radius, in a form that does not cancel: with H0 + H2 = 2
 * H1/x + 2x/(3 pi) the load without adhesion is 4 E* a^3/(3 R) + pi E* A [k a^2 H0(ka) - a H1(ka)],
 * k = 2 pi/lambda, and the adhesive part is -sqrt(8 pi w E* a^3) (the printed 4 sqrt(beta) a^3 of
 * Eq 5 must read 4 sqrt(beta a^3), as in Eq 7). Given: tabor > 0; amplitude >= 0 (0: JKR);
 * contact_radius/eps >= 0. Returned: NaN in all members outside the domain. Accuracy: 1e-14 of the
 * larger term, measured 6e-16 on every row of reference/guduru.csv and kesari_lew_edges.csv
 * (tests/theory/test_tables_theory.c). */
po_contact po_guduru_at(const po_scene *scene, double contact_radius);

/* The derivatives of Eq 5 by the contact radius, which vanish at the extrema of a test: for
 * PO_FIXED_LOAD dW/da, W in pi w R, in 1/eps (dP/da = 2 E* a dDelta/da for the contact without
 * adhesion); for PO_FIXED_APPROACH dDelta/da, both in eps, -INFINITY at a = 0. NaN outside the
 * domain of po_guduru_at. */
double po_guduru_rate(const po_scene *scene, po_fixed fixed, double contact_radius);

/* Finds the largest contact radius, in eps, at which the load of Eq 5 has a minimum that is not
 * above `load`, with the adhesive part multiplied by 1 + excess. Given: load < 0. Returned: 0 if
 * there is no such minimum; NaN outside the domain. Accuracy: 1e-13 relative. */
double po_guduru_last_minimum(const po_scene *scene, double load, double excess);

/* The pull-off in the JKR theory: the global minimum of the load of Eq 5 over the contact radius.
 * The function scans every wavelength in which a lower bound of the load is below the best minimum
 * found so far, and refines each minimum, so that none is missed. The bound is tight once in each
 * wavelength, so that few wavelengths are scanned even if the contact contains many. Beyond 1e8
 * wavelengths the pull-off is where the load touches the bound, in closed form. Returned: NaN
 * outside the domain and beyond the range of doubles. Accuracy: 1e-13 of load and contact radius,
 * measured 9e-16 on every row of reference/guduru_pull_off.csv
 * (tests/theory/test_tables_theory.c). */
po_contact po_guduru_pull_off(const po_scene *scene);

#endif
