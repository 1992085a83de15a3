/* Cubic Hermite interpolation from values and derivatives at the two ends of an interval. */
#ifndef PO_HERMITE_H
#define PO_HERMITE_H

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

#endif
