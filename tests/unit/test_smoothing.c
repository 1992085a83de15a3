/* Smoothing splines: parabolas stay, noise goes, and what remains has the stated deviation. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "po_hermite.h"
#include "po_smoothing.h"
#include "run.h"

enum { MOST = 2000 };
static double X[MOST], Y[MOST];

/* Uniform numbers on (-1, 1), and from them noise that is nearly normal, with deviation 1. */
static uint64_t state;
static double draw(void) {
  double sum = 0.0;
  for (int k = 0; k < 12; ++k) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    sum += (double)(state >> 11) / 9007199254740992.0 - 0.5;
  }
  return sum;
}

static double tip(double x) {
  return 50.0 - sqrt(2500.0 - x * x) + 0.6 * (1.0 - cos(0.4 * x));
}

static double parabola(double x) {
  return 0.31 - 0.07 * x + 0.013 * x * x;
}

/* Rows that are nearer to each other at the axis. */
static void fill(size_t points, double (*f)(double x), double noise) {
  for (size_t i = 0; i < points; ++i) {
    const double part = (double)i / (double)(points - 1);
    X[i] = 30.0 * part * (0.4 + 0.6 * part);
    Y[i] = f(X[i]) + noise * draw();
  }
}

static double value_of(const po_smoothing *s, double x) {
  size_t k = 0;
  while (k + 2 < s->knots && x >= s->knot[k + 1])
    ++k;
  return po_hermite_value(s->value[k], s->slope[k], s->value[k + 1], s->slope[k + 1],
                          x - s->knot[k], s->knot[k + 1] - s->knot[k]);
}

LOOP_TEST(parabolas_stay, 0, 4) {
  static const size_t POINTS[] = {16, 23, 400, MOST};
  fill(POINTS[_i], parabola, 0.0);
  po_smoothing s;
  ck_assert_int_eq(po_smoothing_make(POINTS[_i], X, Y, 0.1, &s), PO_OK);
  for (double x = 0.0; x <= 30.0; x += 0.237)
    ck_assert_double_eq_tol(value_of(&s, x), parabola(x), 1e-7);
  /* at 64 times the roughness 3.05 at most: what is beyond 3 grows no faster than the roughness
   * falls */
  ck_assert_double_gt(s.parameters, 3.0);
  ck_assert_double_lt(s.parameters, 3.5);
  ck_assert_double_lt(s.greatest, 1e-7);
  po_smoothing_free(&s);
}

/* The estimated deviation is right within four times its own, 1/sqrt(2 points), and the spline is
 * much nearer to the curve than the points. */
LOOP_TEST(noise_goes, 0, 6) {
  static const double NOISE[] = {1e-3, 0.03, 0.5};
  const double noise = NOISE[_i % 3];
  const bool known = _i >= 3;
  state = (uint64_t)_i;
  fill(MOST, tip, noise);
  po_smoothing s;
  ck_assert_int_eq(po_smoothing_make(MOST, X, Y, known ? noise : NAN, &s), PO_OK);
  double squares = 0.0;
  for (size_t i = 0; i < MOST; ++i) {
    ck_assert_double_eq_tol(Y[i] - value_of(&s, X[i]), s.removed[i], 1e-12);
    squares += pow(value_of(&s, X[i]) - tip(X[i]), 2);
  }
  const double error = sqrt(squares / MOST), expected = noise * sqrt(s.parameters / MOST);
  ck_assert_double_eq_tol(s.residual, noise, 4.0 * noise / sqrt(2.0 * MOST));
  ck_assert_double_lt(error, 1.6 * expected);
  ck_assert_double_lt(s.parameters, 0.05 * MOST);
  po_smoothing_free(&s);
}

/* The value at x, as weights of values and slopes at the knots. */
static void weigh(const po_smoothing *s, double x, double *by_value, double *by_slope) {
  size_t k = 0;
  while (k + 2 < s->knots && x >= s->knot[k + 1])
    ++k;
  const po_hermite w = po_hermite_at(x - s->knot[k], s->knot[k + 1] - s->knot[k]);
  by_value[k] += w.f0;
  by_value[k + 1] += w.f1;
  by_slope[k] += w.d0;
  by_slope[k + 1] += w.d1;
}

/* The deviation of the value at a place over 2,000 draws is the stated one, within four times the
 * 1.6 % by which such a number scatters. */
LOOP_TEST(deviation_is_that_of_draws, 0, 4) {
  enum { DRAWS = 2000, POINTS = 160 };
  static const double AT[] = {0.0, 3.1, 11.7, 29.4};
  const double x = AT[_i];
  double sum = 0.0, squares = 0.0, stated = 0.0, shift = 0.0;
  state = 77;
  for (int k = 0; k < DRAWS; ++k) {
    po_smoothing s;
    double by_value[POINTS] = {0}, by_slope[POINTS] = {0}, deviation;
    fill(POINTS, parabola, 0.05);
    ck_assert_int_eq(po_smoothing_make(POINTS, X, Y, 1e6, &s), PO_OK); /* always the smoothest */
    s.deviation = 0.05;
    const double off = value_of(&s, x) - parabola(x);
    sum += off;
    squares += off * off;
    weigh(&s, x, by_value, by_slope);
    ck_assert_int_eq(po_smoothing_deviation(&s, by_value, by_slope, &deviation), PO_OK);
    stated = deviation;
    for (size_t i = 0; i < s.knots; ++i) { /* the change is added to the spline */
      s.value[i] += by_value[i];
      s.slope[i] += by_slope[i];
    }
    shift = value_of(&s, x) - parabola(x) - off;
    po_smoothing_free(&s);
  }
  const double deviation = sqrt((squares - sum * sum / DRAWS) / (DRAWS - 1));
  ck_assert_double_eq_tol(deviation, stated, 4.0 * stated / sqrt(2.0 * DRAWS));
  ck_assert_double_eq_tol(shift, stated, 1e-9 * stated);
}
