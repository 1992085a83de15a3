/* Rigid spheres: the smooth one of Bradley, Eq 23, and the wavy one, Eqs 21 and 22. */
#ifndef PO_WAVY_RIGID_H
#define PO_WAVY_RIGID_H

/* The load W/(pi w R) = -2 (4 x^6 - 1)/(3 x^8), x = 1 - approach: Eq 23 (Bradley 1932). Given:
 * approach/eps < 1. Returned: the load, > 0 compressive, with the minimum -2 at approach 0; NaN
 * outside the domain. Accuracy: 4 ulp of the larger term (tests/theory/test_tables_theory.c). */
double po_bradley_load(double approach);

/* The load of Eq 22 with the gap of Eq 21 on the unbounded half-space. The wavelengths near the
 * axis are integrated one by one, on panels that shrink towards each crest; the sum over the others
 * is computed with the Euler-Maclaurin formula, whose integral over the number of the wavelength is
 * elementary. Given: amplitude/eps >= 0 (0: Bradley, Eq 23); alpha = A R/lambda^2 > 0; approach/eps
 * < 1. Returned: W/(pi w R), > 0 compressive; NaN outside the domain. Accuracy: 1e-10 relative,
 * measured 5.3e-11 on every row of reference/rigid_integral.csv
 * (tests/theory/test_tables_theory.c). */
double po_wavy_rigid_load(double amplitude, double alpha, double approach);

/* The derivative of the load by the approach, in 1/eps. Given: as above, amplitude > 0. */
double po_wavy_rigid_rate(double amplitude, double alpha, double approach);

typedef struct {
  double force;    /* |W|/(pi w R) */
  double approach; /* in eps */
} po_rigid_pull_off;

/* The pull-off: the global minimum of the load of Eq 22 over the approach. Given: as above.
 * Returned: NaN outside the domain. Accuracy: 1e-10 relative for the force and 1e-10 eps for the
 * approach, measured 5.9e-11 on every row of reference/rigid_pull_off.csv
 * (tests/theory/test_tables_theory.c). */
po_rigid_pull_off po_wavy_rigid_pull_off(double amplitude, double alpha);

#endif
