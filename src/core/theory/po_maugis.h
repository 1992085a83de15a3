/* The Maugis-Dugdale theory of any profile with waves: contact on the full disc r < a, a constant
 * tension on a < r < c, and the gap 1/tension at c (Maugis 1992 for the sphere).
 *
 * Lengths in eps, tractions in w/eps, loads in w eps; coupling k = w/(E* eps); g is the Abel
 * transform of the initial gap (po_abel.h). The tension q has the transform 2 q k sqrt(c^2 - x^2)
 * on a < x < c. With s = sqrt(c^2 - a^2)
 *
 *   approach = g(a) - 2 q k s
 *   load     = (2/k) [a g(a) - integral of g] - 2 q [a s + c^2 arccos(a/c)]
 *   gap(c)   = (2/pi) {integral of (g - approach)/sqrt(c^2 - x^2) from a to c - 2 q k (c - a)}
 *
 * and gap(c) = 1/q. The theory tends to JKR as q^-2, and to the rigid bodies for k = 0. Between
 * these limits it is no reference for another law. */
#ifndef PO_MAUGIS_H
#define PO_MAUGIS_H

#include "po_jkr_profile.h"

typedef struct {
  po_contact contact; /* load in pi w R */
  double end;         /* c, the radius at which the tension ends, eps */
  double width;       /* c - a, which may be far below the rounding of c */
} po_maugis;

/* The tension that equals the peak of the law of the scene, w/eps. */
double po_maugis_matched_tension(const po_scene *scene);

/* The equilibrium at a contact radius >= 0. Given: tabor > 0; tension > 0, w/eps. Status:
 * PO_BAD_INPUT; PO_NOT_FOUND if no radius has the gap. Accuracy: 1e-14 of the largest term,
 * measured on every row of reference/maugis_profiles.csv (tests/theory/test_tables_profiles.c). */
po_status po_maugis_at(const po_scene *scene, double tension, double contact_radius,
                       po_maugis *state);

/* The derivative of load (pi w R/eps) or approach by the contact radius along the curve. Returned:
 * also that of the width of the ring. */
double po_maugis_rate(const po_scene *scene, double tension, po_fixed fixed, const po_maugis *state,
                      double *width_rate);

/* The pull-off: the lowest of all minima of the load, or of the approach, over the contact radius;
 * the contact radius is 0 if the load rises from there. Given: predict, whether the search predicts
 * the end of the tension from one contact radius to the next, which takes a quarter of the time.
 * The result may then differ in its last bits; documents of `pulloff theory` have the bits without
 * prediction. Status: as above; PO_TOO_MANY_POINTS if the contact has too many waves. */
po_status po_maugis_pull_off(const po_scene *scene, double tension, po_fixed fixed, bool predict,
                             po_maugis *state);

/* The greatest contact radius at which the load, or the approach, has a value and rises, as
 * po_jkr_profile_outermost after any preload. Status: PO_NOT_FOUND if there is none; as above. */
po_status po_maugis_outermost(const po_scene *scene, double tension, po_fixed fixed, double value,
                              double *contact_radius);

/* Whether the state is what the theory assumes: inside the contact no tension above q, between a
 * and c a gap from 0 to 1/q, beyond c a greater gap. For a transform that rises everywhere this is
 * so. Status: PO_BAD_INPUT with the reason if it is not; PO_TOO_MANY_POINTS. */
po_status po_maugis_check(const po_scene *scene, double tension, const po_maugis *state);

#endif
