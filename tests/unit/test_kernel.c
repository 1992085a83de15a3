/* The kernel and the elliptic integrals against those of GSL, which uses another method (Carlson).
 */
#include <check.h>
#include <gsl/gsl_sf_ellint.h>
#include <math.h>

#include "po_kernel.h"
#include "run.h"

static const double RADII[][2] = {{2.385, 0.0}, {2.385, 1e-9},    {2.385, 0.7},
                                  {0.31, 2.2},  {1.0, 0.99999},   {41.7, 41.69},
                                  {1e-3, 1e4},  {3.3, 3.3000001}, {7.77, 12.5}};
enum { RADIUS_COUNT = sizeof RADII / sizeof *RADII };

static double kernel_of_paper(double r, double s) { /* Eq 12 */
  const double large = fmax(r, s), small = fmin(r, s);
  return 4.0 / (M_PI * large) * gsl_sf_ellint_Kcomp(small / large, GSL_PREC_DOUBLE);
}

LOOP_TEST(kernel_is_eq_12, 0, RADIUS_COUNT) {
  const double r = RADII[_i][0], s = RADII[_i][1];
  const double modulus = fmin(r, s) / fmax(r, s);
  /* Kcomp computes 1 - k^2, whose rounding error near r = s is 1/(1 - k) ulp. The
   * arithmetic-geometric mean has no such error. */
  const double tolerance = 1e-15 + 2e-16 / (1.0 - modulus);
  ck_assert_double_eq_tol(po_kernel(r + s, r - s) / kernel_of_paper(r, s), 1.0, tolerance);
  ck_assert_double_eq(po_kernel(r + s, r - s), po_kernel(s + r, s - r));
  double row[3];
  const double three[3] = {s, 0.5 * s + 0.1 * r, 17.0 * r};
  po_kernel_row(r, three, NULL, 3, row);
  for (int j = 0; j < 3; ++j)
    ck_assert_double_eq_tol(row[j] * (1.0 / po_kernel(r + three[j], r - three[j])), 1.0, 1e-14);
}

TEST(kernel_is_infinite_on_the_circle) {
  ck_assert(isinf(po_kernel(2.0, 0.0)));
  /* G ~ (4 / (pi 2 r)) ln(8 r / |r - s|), also where r and s differ only in their last bits */
  const double r = 1.7, d = 1e-200;
  ck_assert_double_eq_tol(po_kernel(2.0 * r, d) / (2.0 / (M_PI * r) * (log(8.0 * r) - log(d))), 1.0,
                          1e-14);
}

LOOP_TEST(disc_is_eq_a2, 0, RADIUS_COUNT) {
  const double c = RADII[_i][0], r = RADII[_i][1], k = fmin(r, c) / fmax(r, c);
  const double K = gsl_sf_ellint_Kcomp(k, GSL_PREC_DOUBLE),
               E = gsl_sf_ellint_Ecomp(k, GSL_PREC_DOUBLE);
  const double expected = r <= c ? c * E : r * (E - (1.0 - k) * (1.0 + k) * K);
  ck_assert_double_eq_tol(po_disc_deflection(c, r), expected, 2e-15 * fmax(c, r));
}

TEST(disc_at_its_edge_and_centre) {
  ck_assert_double_eq_tol(po_disc_deflection(2.385, 2.385), 2.385, 1e-15); /* E(1) = 1 */
  ck_assert_double_eq_tol(po_disc_deflection(2.385, 0.0), 2.385 * M_PI_2, 1e-15);
  ck_assert_double_eq(po_disc_deflection(0.0, 1.3), 0.0);
}

/* From nearly equal sums and differences to the smallest ratios. */
TEST(kernels_are_those_of_one) {
  enum { COUNT = 70 };
  double sum[COUNT], difference[COUNT], kernel[COUNT];
  for (int last = 0; last < COUNT; ++last) { /* the last one needs the most steps */
    for (int j = 0; j <= last; ++j) {
      sum[j] = 1.3 + j;
      difference[j] = (j % 2 ? -1.0 : 1.0) * sum[j] *
                      (j < 10 ? 1.0 - 1e-9 * pow(8.0, j) : pow(10.0, -4.7 * (j - 9)));
    }
    po_kernels((size_t)last + 1, sum, difference, kernel);
    for (int j = 0; j <= last; ++j)
      ck_assert_double_eq_tol(kernel[j] / po_kernel(sum[j], difference[j]), 1.0, 1e-15);
  }
}
