/* A cubic spline through points, held as values and slopes (po_hermite.h). */
#ifndef PO_SPLINE_H
#define PO_SPLINE_H

#include <stddef.h>

#include "po_status.h"

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
