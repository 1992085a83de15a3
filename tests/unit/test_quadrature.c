/* Quadrature rules against integrals known in closed form. */
#include <math.h>

#include "po_hermite.h"
#include "po_quadrature.h"
#include "run.h"

TEST(gauss_rule_is_exact_for_polynomials) {
  double node[9], weight[9], sum = 0.0;
  ck_assert_int_eq(po_gauss_rule(9, node, weight), PO_OK);
  for (int i = 0; i < 9; ++i)
    sum += weight[i] * pow(node[i], 17.0);
  ck_assert_double_eq_tol(sum, 1.0 / 18.0, 1e-16);
}

LOOP_TEST(log_rule_integrates_powers_times_log, 0, 20) { /* integral of x^k ln x = -1/(k + 1)^2 */
  po_near_tables tables;
  const double *node = tables.log_node, *weight = tables.log_weight;
  double log_sum = 0.0, sum = 0.0;
  ck_assert_int_eq(po_near_tables_fill(&tables), PO_OK);
  for (int i = 0; i < PO_LOG_RULE_POINTS; ++i) {
    log_sum += weight[i] * pow(node[i], _i) * log(node[i]);
    sum += weight[i] * pow(node[i], _i);
  }
  ck_assert_double_eq_tol(log_sum * (_i + 1.0) * (_i + 1.0), -1.0, 1e-13);
  ck_assert_double_eq_tol(sum * (_i + 1.0), 1.0, 1e-13);
}

/* The integral of x^power ln|x - x0| over (0, 1) for the powers 0 and 1. */
static double log_moment(double x0, int power) {
  const double a = fabs(x0), b = fabs(1.0 - x0), right = 1.0 - x0;
  const double zeroth = (b > 0.0 ? right * log(b) : 0.0) + (a > 0.0 ? x0 * log(a) : 0.0) - 1.0;
  if (power == 0)
    return zeroth;
  const double first = (b > 0.0 ? 0.5 * right * right * log(b) : 0.0) -
                       (a > 0.0 ? 0.5 * x0 * x0 * log(a) : 0.0) - 0.25 * (right * right - x0 * x0);
  return first + x0 * zeroth;
}

static const double PLACES[] = {-1.7,   -0.31, -1e-3, -1e-9, 0.0,    1e-12,
                                0.2385, 0.5,   0.99,  1.0,   1.0003, 2.6};
enum { PLACE_COUNT = sizeof PLACES / sizeof *PLACES };

LOOP_TEST(near_rule_integrates_the_logarithm_at_any_place, 0, PLACE_COUNT) {
  static const double MIRRORS[] = {1e-6, 0.13, 5.0};
  po_near_tables tables;
  ck_assert_int_eq(po_near_tables_fill(&tables), PO_OK);
  for (int m = 0; m < 3; ++m)
    for (int power = 0; power < 2; ++power) {
      po_near_rule rule = po_near_rule_begin(&tables, PLACES[_i], MIRRORS[m]);
      po_near_point point[PO_NEAR_PIECE_POINTS];
      int pieces = 0;
      double sum = 0.0;
      for (size_t count; (count = po_near_rule_next(&rule, point)) > 0; ++pieces)
        for (size_t q = 0; q < count; ++q)
          sum += point[q].weight * log(fabs(point[q].offset)) * (power ? point[q].x : 1.0);
      ck_assert_int_le(pieces, 110);
      ck_assert_double_eq_tol(sum, log_moment(PLACES[_i], power), 3e-14);
    }
}

TEST(lagrange_reproduces_a_polynomial) {
  double node[7], weight[7], barycentric[7], value[7], sum = 0.0;
  ck_assert_int_eq(po_gauss_rule(7, node, weight), PO_OK);
  po_barycentric_weights(7, node, barycentric);
  po_lagrange(7, node, barycentric, 0.2385, value);
  for (int j = 0; j < 7; ++j)
    sum += value[j] * pow(node[j] - 0.4, 6.0);
  ck_assert_double_eq_tol(sum, pow(0.2385 - 0.4, 6.0), 1e-16);
  po_lagrange(7, node, barycentric, node[3], value);
  ck_assert_double_eq(value[3], 1.0);
  ck_assert_double_eq(value[2], 0.0);
}

TEST(hermite_is_exact_for_cubics) { /* f = x^3 - 2 x^2 + 0.3 x on (0, 1.7), and outside */
  const double h = 1.7, f1 = h * h * h - 2.0 * h * h + 0.3 * h, d1 = 3.0 * h * h - 4.0 * h + 0.3;
  const double x = 2.2;
  const po_hermite w = po_hermite_at(x, h);
  ck_assert_double_eq_tol(w.d0 * 0.3 + w.f1 * f1 + w.d1 * d1, x * x * x - 2.0 * x * x + 0.3 * x,
                          1e-14);
  /* its derivative 3 x^2 - 4 x + 0.3 vanishes inside; increased by 1.2 it is positive and least at
   * x = 2/3 */
  ck_assert_double_eq(po_hermite_least_rate(0.0, 0.3, f1, d1, h, 0.0), 0.0);
  ck_assert_double_eq_tol(po_hermite_least_rate(0.0, 1.5, f1 + 1.2 * h, d1 + 1.2, h, 0.0),
                          (1.5 - 4.0 / 3.0) / (d1 + 1.2), 1e-14);
  /* g = x^2 + x on (0, h) + constant: its derivative 2 x + 1 falls to 1 towards a zero at -1/2;
   * that of x^3 + 0.3 x^2 + x has its vertex at x = -0.1 */
  ck_assert_double_eq(po_hermite_least_rate(0.0, 1.0, 6.0, 5.0, 2.0, 10.0), 1.0);
  ck_assert_double_eq(po_hermite_least_rate(0.0, 1.0, 2.3, 4.6, 1.0, 0.09), 1.0);
  ck_assert_double_eq_tol(po_hermite_least_rate(0.0, 1.0, 2.3, 4.6, 1.0, 0.11), 1.0 / 4.6, 1e-14);
}

static double integrand(double x, void *data) {
  switch (*(const int *)data) {
  case 0:
    return exp(x);
  case 1:
    return 1.0 / sqrt(x);
  case 2:
    return fabs(x - 0.3);
  case 3:
    return cos(100.0 * x);
  case 4:
    return log(x);
  case 5:
    return 1e-4 / (x * x + 1e-8);
  case 6:
    return 0.0;
  default:
    return cos(1e6 * x);
  }
}

static const struct {
  double from, to, tolerance, value;
} INTEGRALS[] = {
    {0, 1, 1e-14, 1.718281828459045235},
    {0, 1, 1e-9, 2.0},
    {0, 1, 1e-12, 0.29},
    {0, 1, 1e-12, -0.00506365641109758793},
    {0, 1, 1e-10, -1.0},
    {-1, 1, 1e-12, 3.141392653591793238},
    {2, 2.5, 1e-12, 0.0},
};
enum { INTEGRAL_COUNT = sizeof INTEGRALS / sizeof *INTEGRALS };

LOOP_TEST(adaptive_quadrature_meets_its_tolerance, 0, INTEGRAL_COUNT) {
  double found = (double)NAN, reverse = (double)NAN;
  const double from = INTEGRALS[_i].from, to = INTEGRALS[_i].to;
  const double tolerance = INTEGRALS[_i].tolerance, value = INTEGRALS[_i].value;
  ck_assert_int_eq(po_integrate(integrand, &_i, from, to, 0.0, tolerance, &found), PO_OK);
  ck_assert_double_le(fabs(found - value), tolerance * fabs(value) + 2e-16);
  ck_assert_int_eq(po_integrate(integrand, &_i, to, from, 1e-3, 0.0, &reverse), PO_OK);
  ck_assert_double_le(fabs(reverse + value), 1e-3);
}

/* On more waves than 200 intervals can resolve, and on a function that is not finite. */
TEST(adaptive_quadrature_gives_up) {
  double found;
  int waves = 7, root = 1;
  ck_assert_int_eq(po_integrate(integrand, &waves, 0, 1, 0.0, 1e-12, &found), PO_NOT_CONVERGED);
  ck_assert_int_eq(po_integrate(integrand, &root, -1, 1, 0.0, 1e-6, &found), PO_NOT_CONVERGED);
}
