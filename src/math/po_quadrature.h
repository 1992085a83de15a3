/* Quadrature rules on the unit interval. */
#ifndef PO_QUADRATURE_H
#define PO_QUADRATURE_H

#include <stddef.h>

#include "po_status.h"

/* Turns GSL's error handler off, once: GSL then returns its errors, as the rooms from math on
 * expect, instead of ending the program. The handler is one for the whole process, so the program
 * decides: the command line calls this first of all. Closed forms (theory) cause no error of GSL
 * except lack of memory, and do not change the handler; po_rigid, which needs it off, calls this,
 * too. */
void po_gsl_return_errors(void);

/* Gauss-Legendre on (0, 1): exact for polynomials of degree 2n - 1.
 * Given: 1 <= n <= 64. Returned: n nodes ascending, n weights of sum 1. Status: PO_NO_MEMORY. */
po_status po_gauss_rule(size_t n, double *node, double *weight);

enum { PO_LOG_RULE_POINTS = 57 };

/* A rule on (0, 1) for integrands with an endpoint singularity like log(x) at 0 and analytic
 * elsewhere (tanh-sinh; nodes near 0 are given to full relative precision). Accuracy: 1e-15 for
 * polynomials of degree up to 20 times log(x) (tests/test_quadrature.c). */
void po_log_rule(double node[PO_LOG_RULE_POINTS], double weight[PO_LOG_RULE_POINTS]);

/* Lagrange polynomials of the nodes at x by the barycentric formula; barycentric[j] are the weights
 * from po_barycentric_weights. value[j] = l_j(x). */
void po_barycentric_weights(size_t n, const double *node, double *barycentric);
void po_lagrange(size_t n, const double *node, const double *barycentric, double x, double *value);

#endif
