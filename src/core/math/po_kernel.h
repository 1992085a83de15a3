/* Eq 12, the kernel of the axisymmetric half-space, and Eq A2, the deflection by a uniformly loaded
 * disc. */
#ifndef PO_KERNEL_H
#define PO_KERNEL_H

#include <stddef.h>

/* The kernel G(r, s) of Eq 12: the deflection at radius r of a half-space with E* = 1 under unit
 * traction times s ds on the circle of radius s (Eq 11). Eq 12 reads (4/(pi max)) K(min/max); the
 * equivalent form used here, G = 2/agm(r + s, |r - s|) with the arithmetic-geometric mean (Gauss),
 * is symmetric and does not cancel near r = s. Given: sum = r + s > 0, difference = r - s != 0 (any
 * unit of length in which their squares are normal doubles). Returned: G in 1/length; INFINITY if
 * difference is 0. Accuracy: 4 ulp, measured 1 ulp on every row of reference/kernel.csv
 * (tests/theory/test_tables_math.c). */
double po_kernel(double sum, double difference);

/* The same for n sums and differences, none of which is 0. */
void po_kernels(size_t n, const double *sum, const double *difference, double *kernel);

/* Eq 12 for one r and n radii s, none of which equals r: kernel[j] = G(r, s[j]). Given: apart, the
 * differences r - s, where those of radii that are close to each other would lose their digits;
 * NULL: they are computed. */
void po_kernel_row(double r, const double *s, const double *apart, size_t n, double *kernel);

/* F(c, r) of Eq A2. By Eq A1, (4/pi) F is the deflection at radius r of a half-space with E* = 1
 * under unit pressure on the disc of radius c. Given: c >= 0, r >= 0. Returned: length, in the unit
 * of c and r. Accuracy: 1e-15 of max(c, r) (tests/unit/test_kernel.c). */
double po_disc_deflection(double c, double r);

#endif
