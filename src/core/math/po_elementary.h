/* Elementary functions whose results are the same to the last bit on every processor, with every
 * compiler and every C library: plain double arithmetic in an order that the source fixes. No
 * function of the C library that rounds is called on the way of a result; sqrt, rint, fmod,
 * remainder, frexp and ldexp are exact or correctly rounded everywhere
 * (doc/method.md#the-same-bits).
 *
 * Results outside the domain are NaN; results that are too large are infinite. Accuracy: the error
 * is below 0.95 units in the last place beside mpmath (reference/elementary.csv and, over millions
 * of points, doc/method.md). */
#ifndef PO_ELEMENTARY_H
#define PO_ELEMENTARY_H

#include "po_dd.h"

double po_exp(double x);
double po_log(double x);
double po_expm1(double x);
double po_log1p(double x);
double po_log10(double x);

/* Given: x >= 0. */
double po_pow(double x, double exponent);

/* The same in two steps, for several powers of one base: po_power(po_base_of(x), exponent) is
 * po_pow(x, exponent). */
typedef struct {
  double x;
  po_dd logarithm; /* high has 26 bits */
} po_base;
po_base po_base_of(double x);
double po_power(po_base base, double exponent);

double po_sin(double x);
double po_cos(double x);

/* sin(pi x) and cos(pi x), for any x: the phase of a wave is computed without the rounding of
 * pi. */
double po_sinpi(double x);
double po_cospi(double x);

double po_atan2(double y, double x);
double po_sinh(double x);
double po_cosh(double x);
double po_asinh(double x);
double po_cbrt(double x);
double po_hypot(double x, double y);

#endif
