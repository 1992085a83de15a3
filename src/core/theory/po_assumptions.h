/* Whether the assumptions of the theories hold: for each assumption the dimensionless number that
 * its derivation takes for small or large.
 *
 * Lengths are in eps, tractions in w/eps; c = w/(E* eps) is the coupling, q the greatest tension of
 * the law. Four lengths decide:
 *
 *   u   the elastic displacement on the axis under the tractions of the rigid bodies at their
 *       pull-off, 2 c times the integral of |p| over r (Boussinesq). Theories of rigid bodies need
 *       a deformation that is small in the range of the law, 1/q.
 *   d   the cohesive zone at the edge of a contact, pi/(4 c q^2) (Dugdale 1960, with the energy
 *       release rate K^2/(2 E*) = w). The JKR theory needs a zone that is short in the length in
 *       which the stress intensity changes with the contact radius a, of which 1/l = 1/a of the
 *       profile and g''/g' of each wave, g' = 3 sqrt(pi c/(2a)) at pull-off (po_abel.h).
 *   b   the radius of a flat. There the minimum of the load is a corner, not smooth, and the loss
 *       is of the first order in the contact radius: the stress sqrt(E* w/b) has to be small beside
 *       the greatest tension.
 *   A   the amplitude of a wave. On the force of a parabola its effect is that of the curvature of
 *       the crest, 4 pi^2 A R/lambda^2 (Eq 19), if the wave is long; if it is short, A over the
 *       range of the law where the wave is too stiff to be flattened, and A sqrt(2 pi/(c lambda)),
 *       Eq 24, where it is flattened.
 *
 * tests/estimates/theories.py judges them: how far a theory is off where they hold. */
#ifndef PO_ASSUMPTIONS_H
#define PO_ASSUMPTIONS_H

#include "po_jkr_profile.h"
#include "po_persson_brener.h"
#include "po_request.h"
#include "po_rigid_profile.h"

/* The states of the closed forms that decide; NAN in all members: not known. */
typedef struct {
  po_rigid_pull_off rigid;
  po_contact jkr; /* its pull-off */
  /* of a viscoelastic body: the pull-offs of Persson and Brener, and of JKR at once */
  po_rate_theory edge, at_once;
} po_closed_states;

/* Finds the numbers of all assumptions. Those of the computed contact are taken, if the solve
 * failed, from the JKR theory: the contact radius at its pull-off; and whether the contact is a
 * full disc where the gap rises everywhere, or where its surfaces overlap. NAN: not known. */
void po_assumptions_find(const po_request *request, const po_result *result,
                         const po_closed_states *states, double number[PO_ASSUMPTION_COUNT]);

/* Decides for a theory whether its assumptions hold: the members of `row` from `holds` on. */
void po_assumptions_decide(const double number[PO_ASSUMPTION_COUNT], po_theory_row *row);

#endif
