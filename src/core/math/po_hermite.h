/* Cubic Hermite interpolation from values and derivatives at the two ends of an interval, and cubic
 * splines held as values and slopes. */
#ifndef PO_HERMITE_H
#define PO_HERMITE_H

#include <stddef.h>

#include "po_status.h"

/* The four cubic Hermite basis functions at x for the interval (0, h): the weights of f(0), f'(0),
 * f(h) and f'(h). x may lie outside the interval; the cubic then extrapolates. */
typedef struct {
  double f0, d0, f1, d1;
} po_hermite;

po_hermite po_hermite_at(double x, double h);

/* The value, and the derivative, at x of the cubic with these end values and derivatives on (0,
 * h). */
double po_hermite_value(double f0, double d0, double f1, double d1, double x, double h);
double po_hermite_rate(double f0, double d0, double f1, double d1, double x, double h);

/* A cubic in t on (0, 1): its values and derivatives at both ends. */
typedef struct {
  double f0, d0, f1, d1;
} po_cubic_ends;

/* Returned: the integral of f(t) g'(t) dt between two values of t, exact for cubics. */
double po_hermite_integral(const po_cubic_ends *f, const po_cubic_ends *g, double from, double to);

/* Returned: the smallest modulus of the derivative of the cubic with these end values and
 * derivatives on [0, h], relative to the larger of the moduli at the ends; 0 if the derivative has
 * a zero there; 1 if its only extremum is outside the interval by more than beyond * h. */
double po_hermite_least_rate(double f0, double d0, double f1, double d1, double h, double beyond);

/* The slopes of the spline with continuous second derivative that is one cubic over the first two
 * and over the last two intervals (not-a-knot). Given: count >= 4 points, x ascending. Returned:
 * slope, count. Status: PO_NO_MEMORY. Accuracy: cubics are met to rounding
 * (tests/unit/test_spline.c). */
po_status po_spline_slopes(size_t count, const double *x, const double *y, double *slope);

/* Limits the slopes so that the cubic of an interval rises or falls with its points where the
 * points rise or fall over three successive intervals; at the ends, over two. Source: J. M. Hyman,
 * SIAM J. Sci. Stat. Comput. 4 (1983) 645, with the limit of F. N. Fritsch and R. E. Carlson, SIAM
 * J. Numer. Anal. 17 (1980) 238. */
void po_spline_limit(size_t count, const double *x, const double *y, double *slope);

#endif
