/* Struve functions of orders 0, 1, 2, which GSL has not. */
#ifndef PO_STRUVE_H
#define PO_STRUVE_H

/* H_n(x). Given: n 0, 1 or 2; x >= 0. Returned: NaN outside the domain (NaN included). Source:
 * Abramowitz and Stegun 12.1.3 (power series, summed with 64 bits) up to x = 9, from there on Y_n
 * (GSL; from x = 25 Hankel's expansion, 9.2.6) plus po_struve_minus_bessel. Accuracy: 1e-14 of
 * max(1, |H|) for all finite x, measured 2.3e-16 on every row of reference/struve.csv
 * (tests/theory/test_tables_math.c). */
double po_struve(int n, double x);

/* H_n(2 pi distance/wavelength), as accurate: the rounding of the argument, which would cost as
 * many digits as the number of waves has, is kept out of the phase. Given: distance >= 0,
 * wavelength > 0. */
double po_struve_wave(int n, double distance, double wavelength);

/* H_n(x) - Y_n(x), which does not oscillate: 2/(pi x), 2/pi, 2 x/(3 pi) for large x. Given: n 0, 1
 * or 2; x >= 0. Returned: INFINITY at 0; NaN outside the domain. Source: Abramowitz and Stegun
 * 12.1.8 by a Gauss-Laguerre rule for x >= 9; the difference itself below, where nothing cancels
 * badly. Accuracy: 1e-14 of max(1, |H - Y|), measured 1.6e-15 on every row of
 * reference/struve.csv (tests/theory/test_tables_math.c). */
double po_struve_minus_bessel(int n, double x);

#endif
