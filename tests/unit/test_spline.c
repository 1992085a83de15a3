/* Cubic splines through points: cubics are met to rounding, and points that rise are joined by
 * curves that rise. */
#include <math.h>

#include "po_hermite.h"
#include "run.h"

static const double X[] = {0.0, 0.3, 1.1, 1.9, 3.7, 4.0, 6.2};
enum { COUNT = sizeof X / sizeof *X };

static double cubic(double x) {
  return 0.7 - 1.3 * x + 0.4 * x * x - 0.11 * x * x * x;
}

TEST(cubics_are_met_to_rounding) {
  double y[COUNT], slope[COUNT];
  for (int k = 0; k < COUNT; ++k)
    y[k] = cubic(X[k]);
  ck_assert_int_eq(po_spline_slopes(COUNT, X, y, slope), PO_OK);
  for (int k = 0; k < COUNT; ++k)
    ck_assert_double_eq_tol(slope[k], -1.3 + 0.8 * X[k] - 0.33 * X[k] * X[k], 1e-13);
}

/* The error falls as the fourth power of the distance of the points. */
TEST(error_is_of_fourth_order) {
  double error[2] = {0.0, 0.0};
  for (int refine = 0; refine < 2; ++refine) {
    enum { MOST = 41 };
    const size_t count = refine ? MOST : 21;
    double x[MOST], y[MOST], slope[MOST];
    for (size_t k = 0; k < count; ++k) {
      x[k] = 4.0 * (double)k / (double)(count - 1);
      y[k] = sin(x[k]);
    }
    ck_assert_int_eq(po_spline_slopes(count, x, y, slope), PO_OK);
    for (size_t k = 0; k + 1 < count; ++k) {
      const double h = x[k + 1] - x[k];
      const double value = po_hermite_value(y[k], slope[k], y[k + 1], slope[k + 1], 0.5 * h, h);
      error[refine] = fmax(error[refine], fabs(value - sin(x[k] + 0.5 * h)));
    }
  }
  ck_assert_double_gt(error[0] / error[1], 12.0);
  ck_assert_double_lt(error[0] / error[1], 40.0);
}

/* The spline of a step overshoots; the limited one does not, and keeps the slopes of a smooth
 * rise. */
TEST(limited_splines_rise_with_their_points) {
  static const double STEP[COUNT] = {0.0, 0.01, 0.02, 0.9, 1.0, 1.01, 1.02};
  double slope[COUNT], limited[COUNT];
  int falls = 0;
  ck_assert_int_eq(po_spline_slopes(COUNT, X, STEP, slope), PO_OK);
  ck_assert_int_eq(po_spline_slopes(COUNT, X, STEP, limited), PO_OK);
  po_spline_limit(COUNT, X, STEP, limited);
  for (int k = 0; k + 1 < COUNT; ++k)
    for (int i = 0; i <= 100; ++i) {
      const double h = X[k + 1] - X[k], at = 0.01 * i * h;
      falls += po_hermite_rate(STEP[k], slope[k], STEP[k + 1], slope[k + 1], at, h) < 0.0;
      ck_assert_double_ge(po_hermite_rate(STEP[k], limited[k], STEP[k + 1], limited[k + 1], at, h),
                          -1e-14);
    }
  ck_assert_int_gt(falls, 0);
  double parabola[COUNT];
  for (int k = 0; k < COUNT; ++k)
    parabola[k] = X[k] * X[k];
  ck_assert_int_eq(po_spline_slopes(COUNT, X, parabola, limited), PO_OK);
  po_spline_limit(COUNT, X, parabola, limited);
  for (int k = 0; k < COUNT; ++k)
    ck_assert_double_eq_tol(limited[k], 2.0 * X[k], 1e-13);
}
