/* Factors of the bordered Jacobian of Eq 15 on a mesh of panels, in compressed form. The unknowns
 * are a value x_i at each node and one more, d:
 *
 *   x_i - sum_j G_ij factor_j x_j + d = right_i,   sum_j border_j x_j + border_n d = right_n
 *
 * doc/method.md, "Factors on panels", has the relations of a cell and its halves. The unknown d is
 * a constant field on the domain, and the border adds one row to Z. The factors of the panel to
 * infinity are taken as zero. The error is that of the skeletons (po_skeleton.h).
 *
 * Source: A. Gillman, P.M. Young, P.G. Martinsson, Front. Math. China 7, 217 (2012). */
#ifndef PO_ELIMINATION_H
#define PO_ELIMINATION_H

#include "po_hierarchy.h"

typedef struct po_elimination po_elimination;

/* Given: hierarchy, which must outlive the object. Status: PO_NO_MEMORY. */
po_status po_elimination_create(const po_hierarchy *hierarchy, po_elimination **elimination);
void po_elimination_destroy(po_elimination *elimination);

/* Factorises on the present mesh. Given: factor, one value a node of a panel, for a domain of
 * radius 1; a panel whose factors are all zero costs nothing. Status: PO_SINGULAR; PO_NO_MEMORY. */
po_status po_elimination_factorize(po_elimination *elimination, const double *factor);

/* Sets the border. Given: border, the number of nodes + 1 values. Returned: the determinant of the
 * bordered matrix over that of the matrix without it. */
double po_elimination_border(po_elimination *elimination, const double *border);

/* Returned: the sign of the determinant of the matrix without its border. */
int po_elimination_sign(const po_elimination *elimination);

/* Solves the system. Given: x, the number of nodes + 1 values, the right-hand side. Returned: in x,
 * the solution. */
void po_elimination_solve(po_elimination *elimination, double *x);

#endif
