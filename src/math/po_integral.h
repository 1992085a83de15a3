/* Adaptive quadrature. */
#ifndef PO_INTEGRAL_H
#define PO_INTEGRAL_H

#include "po_status.h"

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
