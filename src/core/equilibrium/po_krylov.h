/* Linear systems with the bordered Jacobian of Eq 15, solved by GMRES with the factors as the
 * preconditioner. Compressed factors of panels miss the Jacobian by 1e-5 of the interactions of
 * neighbouring cells. Under narrow contact edges, where coupling * p' * (contact radius) exceeds
 * 10^5, this is more than the smallest singular values of the Jacobian. A few directions, in which
 * a narrow ring of contact or of tension moves nearly freely, are then so wrong that a quasi-Newton
 * iteration with these factors contracts by 1 % an iteration, or diverges. Everywhere else the
 * factors are right, so that GMRES needs as many iterations as there are such directions, and some
 * more. See doc/method.md, "Newton's method". */
#ifndef PO_KRYLOV_H
#define PO_KRYLOV_H

#include "po_equilibrium.h"

/* Solves J x = right, J the bordered Jacobian at the state last evaluated. Given: right, n + 1, may
 * be e->deflection; precision, of the preconditioned residual, relative to that of x = 0; both are
 * Euclidean norms of changes relative to the law's length (1 + H) at the factorisation. Returned:
 * x, n + 1, another array than `right`; Broyden's updates are dropped, and e->secant.sign is the
 * sign of the determinant of J over that of the factors. Status: PO_NOT_CONVERGED; those of
 * po_deadline_check. */
po_status po_krylov_solve(po_equilibrium *e, const double *right, double precision, double *x);

#endif
