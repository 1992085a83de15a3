/* Cubic interpolation of a curve from values and slopes at two ends. */
#ifndef PO_HERMITE_H
#define PO_HERMITE_H

/* The four cubic Hermite functions at x for the ends 0 and h: weights of f(0), f'(0), f(h), f'(h).
 * x may lie outside (0, h): then they extrapolate. */
typedef struct {
  double f0, d0, f1, d1;
} po_hermite;

po_hermite po_hermite_at(double x, double h);

/* The cubic with these end values and slopes at x, and its derivative. */
double po_hermite_value(double f0, double d0, double f1, double d1, double x, double h);
double po_hermite_rate(double f0, double d0, double f1, double d1, double x, double h);

/* A cubic of t in (0, 1): values and slopes at its ends. */
typedef struct {
  double f0, d0, f1, d1;
} po_cubic_ends;

/* Integral of `load` times the derivative of `way` from one t to another, exactly. */
double po_hermite_work(const po_cubic_ends *load, const po_cubic_ends *way, double from, double to);

/* The least |derivative| of the cubic with these end values and slopes on [0, h], relative to the
 * larger one at the ends; 0 when it vanishes there. */
double po_hermite_least_rate(double f0, double d0, double f1, double d1, double h);

#endif
