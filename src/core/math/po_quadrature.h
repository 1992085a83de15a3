/* Quadrature rules on the unit interval; among them one for an element if the logarithmic
 * singularity of the kernel lies on the element or close to it. Adaptive quadrature on any
 * interval. */
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

/* The Lagrange polynomials of the nodes by the barycentric formula. po_barycentric_weights returns
 * the weights, n; po_lagrange returns value[j] = l_j(x), n. */
void po_barycentric_weights(size_t n, const double *node, double *barycentric);
void po_lagrange(size_t n, const double *node, const double *barycentric, double x, double *value);

enum { PO_NEAR_GAUSS_POINTS = 16, PO_LOG_RULE_POINTS = 57 };
enum { PO_NEAR_PIECE_POINTS = PO_LOG_RULE_POINTS };

/* The rules of the pieces of a po_near_rule on (0, 1), filled once by po_near_tables_fill: Gauss's,
 * and a tanh-sinh rule for integrands with a singularity like log(x) at 0 and analytic elsewhere.
 * Nodes of the latter near 0 have full relative precision. Accuracy: 1e-15 for log(x) times
 * polynomials of degree up to 20 (tests/unit/test_quadrature.c). */
typedef struct {
  double gauss_node[PO_NEAR_GAUSS_POINTS], gauss_weight[PO_NEAR_GAUSS_POINTS];
  double log_node[PO_LOG_RULE_POINTS], log_weight[PO_LOG_RULE_POINTS];
} po_near_tables;

po_status po_near_tables_fill(po_near_tables *tables);

/* A quadrature point: x in (0, 1), and its distance from the singularity, stored separately so that
 * the argument of the kernel does not cancel. */
typedef struct {
  double x;      /* position of the point */
  double offset; /* x - x0, to full relative precision */
  double weight;
} po_near_point;

/* A quadrature rule over x in (0, 1) for integrands that are a polynomial of degree up to 20 times
 * a function with a logarithmic singularity at x0, inside the interval, at an end or outside. The
 * rule is composed of pieces whose length grows geometrically away from x0; the piece at x0 uses
 * the rule for logarithms, the others a Gauss rule. Pieces double in length from the rounding unit
 * to 1, so that there are at most 110. */
typedef struct {
  const po_near_tables *tables;
  double x0, mirror;
  double sign, near, to; /* the side of x0, and the distances from x0 that are left on it */
} po_near_rule;

/* Given: x0; mirror > 0, a lower bound of the distance from x0 to the other singularity of the
 * kernel (at s = -r). Accuracy: 1e-14 relative (tests/unit/test_quadrature.c). */
po_near_rule po_near_rule_begin(const po_near_tables *tables, double x0, double mirror);

/* Fills the points of the next piece. Returned: their number; 0 if there is none. */
size_t po_near_rule_next(po_near_rule *rule, po_near_point point[PO_NEAR_PIECE_POINTS]);

/* Returned: whether a Gauss rule of n points over (0, 1) is exact to rounding if the singularity is
 * at x0. */
int po_near_is_far(double x0, size_t n);

/* A function of one variable; `data` is passed through from the caller. */
typedef double (*po_integrand)(double x, void *data);

/* The integral of f from `from` to `to`, by bisection of the interval with the largest error until
 * the estimated error is at most the greater of `absolute` and `relative` times the integral, or is
 * rounding. Returned: *integral. Status: PO_NOT_CONVERGED, without a message, if 200 intervals do
 * not suffice or f is not finite. Source: the rule of 10 and 21 points of Gauss and Kronrod, as in
 * QUADPACK (R. Piessens et al., Springer 1983), routine qag. */
po_status po_integrate(po_integrand f, void *data, double from, double to, double absolute,
                       double relative, double *integral);

#endif
