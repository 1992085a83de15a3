/* The minima of a function of one variable that has many, found by branch and bound: intervals are
 * halved, and those in which a lower bound of the function excludes a minimum are left out. */
#ifndef PO_MINIMA_H
#define PO_MINIMA_H

#include <stddef.h>

#include "po_root.h"
#include "po_status.h"

typedef struct {
  const void *data;
  po_function value, rate; /* the function and its derivative; at a corner, where the derivative
                              jumps, that on the left */
  double (*below)(double low, double high, const void *data);   /* no greater than the function
                                                                   anywhere on [low, high] */
  double (*slowest)(double low, double high, const void *data); /* no greater than the derivative
                                                                   anywhere on [low, high] */
  double (*detail)(double x, const void *data); /* length of an interval at x in which the
                                                   derivative changes its sign once at most */
  const double *edge; /* edges, ascending and > 0: the ends of the search, and corners between */
  size_t edges;       /* at least 2 */
} po_minima_function;

/* Finds the lowest minimum, or the last minimum (greatest x) whose value is at most `most`. A
 * corner at which the derivative rises through zero is a minimum. Returned: *x. Status:
 * PO_NOT_FOUND if there is none; PO_TOO_MANY_POINTS if too many intervals would have to be
 * searched. Accuracy: x to rounding of the derivative. */
po_status po_minima_least(const po_minima_function *function, double *x);
po_status po_minima_last(const po_minima_function *function, double most, double *x);

#endif
