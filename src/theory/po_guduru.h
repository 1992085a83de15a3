/* The wavy sphere in the limit of short-range adhesion, the contact compact (Guduru 2007). */
#ifndef PO_GUDURU_H
#define PO_GUDURU_H

#include "po_jkr.h"

/* Eq 5 at a contact radius, in a form that does not cancel: with H0 + H2 = 2 H1/x + 2x/(3 pi) the
 * load without adhesion is 4 E* a^3/(3 R) + pi E* A [k a^2 H0(ka) - a H1(ka)], k = 2 pi/lambda, and
 * the adhesive part sqrt(8 pi w E* a^3) (the printed 4 sqrt(beta) a^3 means 4 sqrt(beta a^3)).
 * Given: tabor > 0; amplitude 0 is JKR; contact_radius / eps >= 0. Returned: NaN in all members
 * outside the domain. Accuracy: 1e-14 of the larger term, measured 6e-16 on every row of
 * reference/guduru.csv and kesari_lew_edges.csv (tests/theory/test_tables_theory.c). */
po_contact po_guduru_at(const po_scene *scene, double contact_radius);

/* Part of the first wave from which on minima and folds of Eq 5 are looked for: those of a sharp
 * crest may be far inside. */
extern const double PO_GUDURU_FIRST;

/* dW/da of Eq 5, in 1/eps, by dP/da = 2 E* a dDelta/da of the contact without adhesion. */
double po_guduru_load_rate(const po_scene *scene, double contact_radius);

/* dDelta/da of Eq 5, both in eps: -INFINITY at a = 0. */
double po_guduru_approach_rate(const po_scene *scene, double contact_radius);

/* The largest contact radius, in eps, at which the load of Eq 5, with its adhesive part greater by
 * the part `excess` of itself, has a minimum that is not above a load; 0: there is none. Given:
 * load < 0. NaN outside the domain. Accuracy: 1e-13 relative. */
double po_guduru_last_minimum(const po_scene *scene, double load, double excess);

/* The pull-off: the global minimum of the load over the contact radius. Every wave whose lower
 * bound of the load lies below the best so far is scanned, and each minimum refined; so no wave is
 * missed. The waves there are few however many lie within the contact: the bound is met in each;
 * from 1e8 on the pull-off is where it is met, in closed form. NaN when the numbers leave the range
 * of doubles. Accuracy: 1e-13 of load and contact radius, measured 9e-16 on every row of
 * reference/guduru_pull_off.csv (tests/theory/test_tables_theory.c). */
po_contact po_guduru_pull_off(const po_scene *scene);

#endif
