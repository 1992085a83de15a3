/* How the load at a minimum of a branch changes with the inputs, by the adjoint equation.
 *
 * With D = diag(dp/dH), the Jacobian at given approach is J = 1 - coupling G D, the gradient of the
 * load, Eq 17, is g = (2/R) D w, and the integral of Eq 15 is symmetric: w_i G_ij = w_j G_ji. Then
 * J^T D w v = D w J v, so that the solution of J^T x = g is x = D w v with J v = 2/R. The tangent t
 * of the branch solves J t = -t_Delta, hence v = -(2/R) t / t_Delta: no system is solved. x_i is
 * the derivative of the load by the initial gap at node i. The load is stationary along the branch,
 * so that this is also the derivative of the load at the minimum, and the sum of x is 0.
 *
 * Accuracy: that of the symmetry of the discretised integral; agrees to 1e-6 with the adjoint solve
 * of po_sensitivity_make at a tolerance of 1e-6 (tests/unit/test_diagnosis.c). */
#ifndef PO_ADJOINT_H
#define PO_ADJOINT_H

#include "po_branch_point.h"
#include "po_result.h"
#include "po_scene.h"
#include "po_solution.h"
#include "po_surface.h"

/* The sensitivity of the pull-off force; its standard deviation by the noise of a smoothed table,
 * and the change of the table that belongs to it. Given: a minimum of the load; surface, on whose
 * mesh it is, not looked at for rigid bodies, whose x is dp/dH (2/R) r dr at the initial gap.
 * Returned: in the result, `sensitivity` of the pull-off, whose residual and rounding are NAN, and
 * `has_sensitivity`, false at a fold; both are unchanged off panels; and `noise`, whose change is
 * NULL without a smoothed table, or off panels; and for another table the weights of
 * `interpolation`, likewise. Status: PO_NO_MEMORY. */
po_status po_adjoint_note(const po_scene *scene, const po_surface *surface,
                          const po_branch_point *p, po_result *result);

#endif
