/* The JKR theory of any profile with waves: short-range adhesion, contact on the full disc r < a.
 *
 * With the Abel transform g of the initial gap (po_abel.h) and the coupling c = w/(E* eps), lengths
 * in eps, the energy of the contact at approach D is (1/c) times the integral of (D - g)^2 from 0
 * to a, less pi a^2, in w eps^2. Its derivatives give the load 2 E* [a D - integral of g], and the
 * equilibrium (D - g(a))^2 = 2 pi a c (Johnson, Kendall, Roberts 1971; the profile as in Sneddon
 * 1965 and Maugis 1992). Eq 5 and Eq 7 are the cases of a sphere with one wave and with none;
 * po_guduru.h and po_jkr.h compute them by their own formulas, with which these are compared. */
#ifndef PO_JKR_PROFILE_H
#define PO_JKR_PROFILE_H

#include "po_jkr.h"

/* The part of the radius of a kink beside it at which the rates on its right are taken: some
 * spacings of doubles. */
static const double PO_BESIDE = 1e-14;

/* The equilibrium at a contact radius. Given: tabor > 0; contact_radius/eps >= 0. Returned: NaN in
 * all members outside the domain. Accuracy: 1e-14 of the largest term, measured on every row of
 * reference/jkr_profiles.csv (tests/theory/test_tables_profiles.c). */
po_contact po_jkr_profile_at(const po_scene *scene, double contact_radius);

/* The derivatives by the contact radius: dW/da in pi w R/eps, and dDelta/da. The equilibrium is
 * stable at given load, or at given approach, where it is > 0. */
double po_jkr_profile_rate(const po_scene *scene, po_fixed fixed, double contact_radius);

/* The energy U/(pi w R eps), zero for separated bodies; dU = W dDelta along the curve. Status:
 * PO_NO_MEMORY. Accuracy: 1e-12 of the largest term. */
po_status po_jkr_profile_energy(const po_scene *scene, double contact_radius, double *energy);

/* The pull-off: the lowest of all minima of the load, or of the approach, over the contact radius.
 * At an edge of the profile where its slope jumps the minimum may be a corner. Status: PO_BAD_INPUT
 * for tabor 0, a profile that grows as the square root of the radius or slower, or numbers beyond
 * the range of doubles; PO_TOO_MANY_POINTS. Accuracy: 1e-13 of the largest term and of the contact
 * radius, measured on every row of reference/jkr_profiles.csv. */
po_status po_jkr_profile_pull_off(const po_scene *scene, po_fixed fixed, po_contact *least);

/* The largest contact radius, eps, at which the load has a minimum that is not above `load` < 0,
 * with the adhesive part multiplied by 1 + excess. Returned: 0 if there is none; NaN if it cannot
 * be computed. */
double po_jkr_profile_last_minimum(const po_scene *scene, double load, double excess);

/* The contact radius below which load and approach fall: the curve has no minimum up to here.
 * Returned: NaN outside the domain. */
double po_jkr_profile_first(const po_scene *scene);

/* The greatest contact radius, up to `within` (INFINITY: any), at which the load, or the approach,
 * has a value and rises with the contact radius. Unloading at given load, or at given approach,
 * follows these states, as it jumps inwards where one ends: `within` is the contact radius at which
 * loading was reversed, INFINITY that of a preload which is harder than any that matters. Status:
 * PO_NOT_FOUND with the lowest value of all states, or that of the preload, if there is none; as
 * po_jkr_profile_pull_off. Accuracy: 1e-13 of the largest term of load or approach
 * (tests/cli/test_theory_states.py). */
po_status po_jkr_profile_outermost(const po_scene *scene, po_fixed fixed, double value,
                                   double within, double *contact_radius);

/* Whether the contact is a full disc as the theory assumes: nowhere outside it do the surfaces
 * overlap. Returned: *gap, the lowest value found of gap(r) outside, and *radius where, if it is
 * negative; otherwise 0 and the contact radius. With the approach D
 *
 *   gap(r) = (2/pi) integral of (g(x) - D)/sqrt(r^2 - x^2) over x from a to r,
 *
 * which is positive if g > D up to r. Status: PO_NO_MEMORY, PO_BAD_INPUT, PO_TOO_MANY_POINTS. */
po_status po_jkr_profile_check(const po_scene *scene, double contact_radius, double *gap,
                               double *radius);

#endif
