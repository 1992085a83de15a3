/* The times of the repeated solves of a point. */
#ifndef PO_TIMES_H
#define PO_TIMES_H

#include <stdbool.h>

/* Returned: the median of `count` times, of which those that are NAN are left out; NAN if all are.
 */
double po_times_median(const double *seconds, unsigned count);

/* Returned: whether the solves of a point before a round took a tenth of a second together, so
 * that it is not solved again. Given: the processor time of each round, in seconds; NAN: not
 * solved. */
bool po_times_are_enough(const double *seconds, unsigned round);

#endif
