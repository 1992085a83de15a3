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

#endif
