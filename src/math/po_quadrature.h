/* Quadrature rules on the unit interval. */
#ifndef PO_QUADRATURE_H
#define PO_QUADRATURE_H

#include <stddef.h>

#include "po_status.h"

/* Turns off the error handler of GSL, so that GSL returns its errors, as the functions of this
 * program expect, instead of ending the program. The handler belongs to the whole process, so the
 * program decides: the command line calls this function first. The only error is lack of memory. */
void po_gsl_return_errors(void);

/* The Gauss-Legendre rule on (0, 1), exact for polynomials of degree 2n - 1. Given: 1 <= n <= 64.
 * Returned: node, n, ascending; weight, n, of sum 1. Status: PO_NO_MEMORY. */
po_status po_gauss_rule(size_t n, double *node, double *weight);

enum { PO_LOG_RULE_POINTS = 57 };

/* A tanh-sinh rule on (0, 1) for integrands with a singularity like log(x) at 0 and analytic
 * elsewhere. Nodes near 0 have full relative precision. Accuracy: 1e-15 for log(x) times
 * polynomials of degree up to 20 (tests/unit/test_quadrature.c). */
void po_log_rule(double node[PO_LOG_RULE_POINTS], double weight[PO_LOG_RULE_POINTS]);

/* The Lagrange polynomials of the nodes by the barycentric formula. po_barycentric_weights returns
 * the weights, n; po_lagrange returns value[j] = l_j(x), n. */
void po_barycentric_weights(size_t n, const double *node, double *barycentric);
void po_lagrange(size_t n, const double *node, const double *barycentric, double x, double *value);

#endif
