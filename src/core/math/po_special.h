/* Special functions whose results are the same on every machine (po_elementary.h). */
#ifndef PO_SPECIAL_H
#define PO_SPECIAL_H

/* Gamma(x), and the Beta function B(a, b) = Gamma(a) Gamma(b)/Gamma(a + b). Given: x, a, b > 0; NaN
 * otherwise. Source: Stirling's series in twice the precision (Abramowitz and Stegun 6.1.41).
 * Accuracy: 2e-16 relative (reference/elementary.csv). */
double po_gamma(double x);
double po_beta(double a, double b);

/* The incomplete Beta function B_x(a, b), the integral of t^(a - 1) (1 - t)^(b - 1) from 0 to x.
 * Given: 0 <= x <= 1; a, b > 0. Source: the series of positive terms of Abramowitz and
 * Stegun 26.5.4, from the end that is nearer. Accuracy: 1e-14 relative for a and b up to 1e3. */
double po_beta_incomplete(double a, double b, double x);

/* exp(-|x|) I_0(x), the scaled modified Bessel function. Source: power series (Abramowitz and
 * Stegun 9.6.10), whose terms are positive, and Hankel's expansion (9.7.1). Accuracy: 2e-15
 * relative. */
double po_bessel_i0_scaled(double x);

/* The Struve function H_n(x), of which Eq 5 is made. Given: n = 0 or 1; x >= 0. Returned: NaN
 * outside the domain (and for NaN). Source: up to x = 9 the power series, Abramowitz and
 * Stegun 12.1.3, as a Chebyshev series; beyond it Y_n, 9.2.6 with Chebyshev series, plus the
 * integral 12.1.8 of H_n - Y_n by a Gauss-Laguerre rule. Accuracy: 1e-14 of max(1, |H|) for all
 * finite x (tests/theory/test_tables_math.c: every row of reference/struve.csv). */
double po_struve(int n, double x);

/* H_n(2 pi distance/wavelength), to the same accuracy. The phase is reduced before the
 * multiplication by 2 pi; otherwise the rounding of the argument would cost as many digits as the
 * number of wavelengths has. Given: distance >= 0, wavelength > 0, in the same unit. */
double po_struve_wave(int n, double distance, double wavelength);

#endif
