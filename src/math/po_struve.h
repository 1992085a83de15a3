/* Struve functions of orders 0 and 1, of which Eq 5 is made. */
#ifndef PO_STRUVE_H
#define PO_STRUVE_H

/* The Struve function H_n(x). Given: n = 0 or 1; x >= 0. Returned: NaN outside the domain (and for
 * NaN). Source: up to x = 9 the power series, Abramowitz and Stegun 12.1.3, as a Chebyshev series;
 * beyond it Y_n, 9.2.6 with Chebyshev series, plus the integral 12.1.8 of H_n - Y_n by a
 * Gauss-Laguerre rule. Accuracy: 1e-14 of max(1, |H|) for all finite x
 * (tests/theory/test_tables_math.c: every row of reference/struve.csv). */
double po_struve(int n, double x);

/* H_n(2 pi distance/wavelength), to the same accuracy. The phase is reduced before the
 * multiplication by 2 pi; otherwise the rounding of the argument would cost as many digits as the
 * number of wavelengths has. Given: distance >= 0, wavelength > 0, in the same unit. */
double po_struve_wave(int n, double distance, double wavelength);

#endif
