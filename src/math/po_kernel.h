/* The kernel of the axisymmetric half-space, Eq 12, and the complete elliptic integrals of App. A.
 */
#ifndef PO_KERNEL_H
#define PO_KERNEL_H

#include <stddef.h>

/* G = 2 / agm(sum, |difference|) with sum = r + s, difference = r - s: the deflection at radius r
 * of a half-space (E* = 1) under a unit line load p s ds on the circle of radius s, Eq 12, which
 * reads (4/(pi max)) K(min/max); the form with the arithmetic-geometric mean is Gauss's, symmetric,
 * and does not cancel near r = s. Given: sum > 0, difference != 0 (any unit of length in which
 * their squares are normal doubles). Returned: 1/length; INFINITY when difference is 0. Accuracy: 4
 * ulp, measured 1 on every row of reference/kernel.csv (tests/theory/test_tables_math.c). */
double po_kernel(double sum, double difference);

/* The same for one r and n radii s, none of them equal to r: kernel[j] = G(r, s[j]). */
void po_kernel_row(double r, const double *s, size_t n, double *kernel);

/* F(c, r) of Eq A2: (4/pi) F is the deflection at r of a unit pressure (E* = 1) over the disc of
 * radius c. Given: c >= 0, r >= 0. Accuracy: 1e-15 of max(c, r) (tests/unit/test_kernel.c). */
double po_disc_deflection(double c, double r);

#endif
