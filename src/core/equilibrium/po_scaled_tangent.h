/* The tangent of the branch where a contact edge is narrow, in coordinates that scale with the
 * contact.
 *
 * At a fixed radius the gap of a narrow edge changes by many times eps when the edge moves a
 * little: dH/ds is the slope of the gap times the rate of the edge, some 1e6 at a Tabor parameter
 * of 5000, beside a rate of the approach of 1e2. The tangent by po_equilibrium_tangent is as
 * precise as the largest of its components. An error of the state of 1e-10 eps gave rates of the
 * approach that were wrong by a percent, from which spurious folds and short steps followed.
 *
 * Let all radii be multiplied by 1 + c s. With the domain of the panels the matrix scales exactly,
 * so that the derivative DH at nodes that move like this follows from Eq 15 without any derivative
 * of the gap:
 *
 *   DH_i + D(approach) - coupling * sum_j G_ij p'(H_j) DH_j = c (r_i f'(r_i) + u_i),
 *
 * u the deflection. With c the rate of the edge over its radius, DH is of order one at the edge,
 * and dH/ds = DH - c r dH/dr. On a cut surface nothing acts on the ring that is added at its end.
 */
#ifndef PO_SCALED_TANGENT_H
#define PO_SCALED_TANGENT_H

#include "po_solution.h"

/* Computes the tangent and all derivatives along the branch. Given: p, on panels, has taken its
 * state, the one last evaluated, and has a contact edge; direction, of the arclength functional to
 * which the border of the present factors belongs; precision of DH, relative to its largest
 * component. Status: PO_NOT_CONVERGED if the factors are too
 * old. */
po_status po_scaled_tangent(po_equilibrium *e, const double *direction, double precision,
                            po_solution *p);

#endif
