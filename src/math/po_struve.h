/* Struve functions of orders 0, 1 and 2, which Eq 5 contains. */
#ifndef PO_STRUVE_H
#define PO_STRUVE_H

/* The Struve function H_n(x). Given: n = 0, 1 or 2; x >= 0. Returned: NaN outside the domain (and
 * for NaN). Source: up to x = 9 the power series, Abramowitz and Stegun 12.1.3, summed in
 * twice the precision; beyond x = 9, Y_n (po_special.h; beyond x = 25 by Hankel's expansion, 9.2.6)
 * plus po_struve_minus_bessel. Accuracy: 1e-14 of max(1, |H|) for all finite x, measured 2.3e-16 on
 * every row of reference/struve.csv (tests/theory/test_tables_math.c). */
double po_struve(int n, double x);

/* H_n(2 pi distance/wavelength), to the same accuracy. The phase is reduced before the
 * multiplication by 2 pi; otherwise the rounding of the argument would cost as many digits as the
 * number of wavelengths has. Given: distance >= 0, wavelength > 0, in the same unit. */
double po_struve_wave(int n, double distance, double wavelength);

/* H_n(x) - Y_n(x), which does not oscillate: it tends to 2/(pi x), 2/pi and 2 x/(3 pi) for large x.
 * Given: n = 0, 1 or 2; x >= 0. Returned: INFINITY at 0; NaN outside the domain. Source: for x >= 9
 * Abramowitz and Stegun 12.1.8 with a Gauss-Laguerre rule; below, the difference itself, which
 * hardly cancels there. Accuracy: 1e-14 of max(1, |H - Y|), measured 1.6e-15 on every row of
 * reference/struve.csv (tests/theory/test_tables_math.c). */
double po_struve_minus_bessel(int n, double x);

#endif
