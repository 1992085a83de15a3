/* A root of a function between two points where its signs differ. */
#ifndef PO_ROOT_H
#define PO_ROOT_H

#include <stdbool.h>

/* A function of one variable, with what it needs. */
typedef double (*po_function)(double x, const void *data);

/* The root of f in (a, b), to the last bits of x. Given: f finite on [a, b], f(a) and f(b) of
 * different signs (zero counts as a root). Returned: the root; NaN when the signs agree. Source:
 * regula falsi with the Illinois weights, and a bisection whenever it shrinks the bracket by less
 * than half. Accuracy: 2 ulp of x where the sign of f is right (tests/unit/test_struve.c). */
double po_root(po_function f, const void *data, double a, double b);

/* Narrows a bracket by halves, to the last bits of the wider of its ends or to a part of `high`:
 * where only the side of a place is known, or its value is rounded. Given: whether a place is on
 * the side of low. */
typedef bool (*po_side)(double x, const void *data);
void po_bisect(po_side is_low, const void *data, double tolerance, double *low, double *high);

#endif
