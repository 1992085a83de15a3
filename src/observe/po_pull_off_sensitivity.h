/* The sensitivities of the pull-off force, from the solution at pull-off alone. */
#ifndef PO_PULL_OFF_SENSITIVITY_H
#define PO_PULL_OFF_SENSITIVITY_H

#include "po_diagnosis.h"
#include "po_solution.h"

/* Computes d ln(force) / d ln(parameter) at a minimum of the load; residual and rounding are NAN.
 *
 * The adjoint equation needs no solve. With D = diag(dp/dH), the Jacobian at given approach is
 * J = 1 - coupling G D, the gradient of the load, Eq 17, is g = (2/R) D w, and the integral of Eq
 * 15 is symmetric: w_i G_ij = w_j G_ji. Then J^T D w v = D w J v, so that the solution of J^T x = g
 * is x = D w v with J v = 2/R. The tangent t of the branch solves J t = -t_Delta, hence v = -(2/R)
 * t / t_Delta. Where the approach is not stationary, t_Delta is not 0.
 *
 * Given: the surface, on whose mesh the solution is. Returned: false if it is not, or at a fold.
 * Accuracy: that of the symmetry of the discretised integral; agrees to 1e-6 with the adjoint
 * solve of po_sensitivity_make at a tolerance of 1e-6 (tests/unit/test_diagnosis.c). */
bool po_pull_off_sensitivity(const po_scene *scene, const po_surface *surface,
                             const po_solution *solution, po_sensitivity *made);

#endif
