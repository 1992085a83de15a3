/* A smoothing spline through points with noise, and the uncertainty that the noise leaves in it.
 *
 * The spline f is a cubic with continuous second derivative between knots, which are some of the
 * points, and minimises
 *
 *   sum of (y - f(x))^2 + roughness * integral of f'''^2.
 *
 * A parabola is therefore not changed by any roughness. The noise of the points is independent and
 * has one standard deviation. An estimate of the expected square of the error has its minimum at a
 * roughness 64 times as large: Mallows' C_p if the deviation is known, otherwise generalised
 * cross-validation, with a parameter counted as 1.4; sharp parts are worn off by that one. There
 * are 16 knots, or twice as many until the spline uses less than a quarter of its parameters and,
 * if the noise is estimated, removes no more than noise; at most one for every other point: then the
 * knots do not decide anything. Every sum is a loop in a fixed order, so that the spline is the same on every machine. Source: C. H. Reinsch, Numer. Math.
 * 10 (1967) 177; P. Craven, G. Wahba, Numer. Math. 31 (1979) 377; C. L. Mallows, Technometrics 15
 * (1973) 661; P. H. C. Eilers, B. D. Marx, Stat. Sci. 11 (1996) 89. */
#ifndef PO_SMOOTHING_H
#define PO_SMOOTHING_H

#include <stddef.h>

#include "po_memory.h"
#include "po_status.h"

enum { PO_SMOOTHING_LEAST = 16 }; /* points */

typedef struct {
  size_t points, knots;
  double *knot, *value, *slope; /* knots: the spline, for po_hermite.h */
  double *removed;              /* points: y - f(x) */
  double deviation;             /* standard deviation of the noise: as given, or as estimated */
  double residual; /* estimate of the same by the removed part: its sum of squares over points less
                      parameters, and the root */
  double parameters;    /* effective number: trace of the matrix from y to f(x) */
  double rms, greatest; /* of the removed part */
  double *factor;       /* 4 (knots + 2): bands of the factors of the matrix of both sums */
  po_arena arrays;      /* these */
} po_smoothing;

/* Smooths points. Given: at least PO_SMOOTHING_LEAST points, x ascending; deviation, > 0, or NAN:
 * it is estimated. Returned: the spline, to be freed whatever the status. Status: PO_NO_MEMORY.
 * Accuracy: parabolas are met to 1e-9 of their range (tests/unit/test_smoothing.c). */
po_status po_smoothing_make(size_t points, const double *x, const double *y, double deviation,
                            po_smoothing *smoothing);
void po_smoothing_free(po_smoothing *smoothing);

/* The standard uncertainty of a linear function of the spline, the sum of by_value * value +
 * by_slope
 * * slope over the knots. The covariance of the coefficients is the variance of the noise times the
 * inverse of the matrix of both sums: it has the error by smoothing in it, in the mean over the
 * curves for which the roughness is the right one. Source: G. Wahba, J. R. Stat. Soc. B 45 (1983)
 * 133. Given: both weights, knots. Returned: deviation; in the place of the weights the most
 * probable change of value and slope by which the function is greater by this deviation. Status:
 * PO_NO_MEMORY. */
po_status po_smoothing_deviation(const po_smoothing *smoothing, double *by_value, double *by_slope,
                                 double *deviation);

/* The greatest standard uncertainty of the spline at a knot. Status: PO_NO_MEMORY. */
po_status po_smoothing_uncertainty(const po_smoothing *smoothing, double *greatest);

#endif
