/* The rigid wavy sphere. */
#ifndef PO_WAVY_RIGID_H
#define PO_WAVY_RIGID_H

/* The load of Eqs 21 and 22 on the unbounded surface. Waves near the axis are integrated one by
 * one, on panels that shrink towards the crest; the sum over the others is Euler's and Maclaurin's,
 * whose integral over the number of the wave is elementary. Given: amplitude/eps > 0 (0: Bradley);
 * alpha = A R/lambda^2 > 0; approach/eps < 1. Returned: W/(pi w R), > 0 compressive; NaN outside
 * the domain. Accuracy: 1e-10 relative, measured 5.3e-11 on every row of
 * reference/rigid_integral.csv (tests/theory/test_tables_theory.c). */
double po_wavy_rigid_load(double amplitude, double alpha, double approach);

/* Its slope dW/d(approach), in 1/eps. */
double po_wavy_rigid_rate(double amplitude, double alpha, double approach);

typedef struct {
  double force;    /* |W|/(pi w R) */
  double approach; /* in eps */
} po_rigid_pull_off;

/* The global minimum of the load over the approach. Given: as above. Returned: NaN outside the
 * domain. Accuracy: 1e-10, of the force relative, of the approach in eps, measured 5.9e-11 on every
 * row of reference/rigid_pull_off.csv. */
po_rigid_pull_off po_wavy_rigid_pull_off(double amplitude, double alpha);

#endif
