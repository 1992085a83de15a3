/* A root of a function in an interval at whose ends the function has different signs. */
#ifndef PO_ROOT_H
#define PO_ROOT_H

#include <stdbool.h>

/* A function of one variable; `data` is passed through from the caller. */
typedef double (*po_function)(double x, const void *data);

/* Finds a root of f in (a, b) to rounding. Given: f finite on [a, b], with different signs at a and
 * b (a zero at an end is the root). Returned: the root; NaN if the signs agree. Source: regula
 * falsi with the Illinois weights; every third step is a bisection. Accuracy: 2 ulp of x, if the
 * sign of the computed f is right (tests/unit/test_root.c). */
double po_root(po_function f, const void *data, double a, double b);

/* Bisection, for a function of which only the sign is known or whose values are rounded. Halves the
 * bracket until it is not longer than tolerance * high, at most down to rounding relative to its
 * initial length. Given: is_low, whether x is on the same side of the root as `low`; tolerance.
 * Returned: the bracket in *low and *high. */
typedef bool (*po_side)(double x, const void *data);
void po_bisect(po_side is_low, const void *data, double tolerance, double *low, double *high);

#endif
