/* Roots between two points at which the function has different signs, and intervals without a
 * root. */
#include <float.h>
#include <math.h>
#include <stdint.h>

#include "po_root.h"
#include "run.h"

/* scale (x - root) (1 + (x - root)^2), which has one zero. */
typedef struct {
  double root, scale;
  int calls;
} cubic;

static double cubic_at(double x, const void *data) {
  cubic *c = (cubic *)(uintptr_t)data;
  ++c->calls;
  const double d = x - c->root;
  return c->scale * d * (1.0 + d * d);
}

static const struct {
  double root, scale, a, b;
} CROSSED[] = {{2.385, 1.0, 1.0, 3.0},         {2.385, -1.0, 1.0, 3.0},
               {2.385, 1.0, 3.0, 1.0},         {2.385, -1.0, 3.0, 1.0},
               {-0.613, 1e-12, -7.0, 40},      {0.071, -1e12, -50.0, 0.1},
               {1e-9, 1.0, -1.0, 2.0},         {1234.5, 1.0, 0.0, 1e6},
               {2.385, 1.0, 2.385 - 1e-14, 9}, {2.385, 1.0, -9, 2.385 + 1e-14}};

TABLE_TEST(a_change_of_sign_is_found, CROSSED) {
  cubic c = {CROSSED[_i].root, CROSSED[_i].scale, 0};
  const double x = po_root(cubic_at, &c, CROSSED[_i].a, CROSSED[_i].b);
  ck_assert_double_eq_tol(x, c.root, 2.0 * DBL_EPSILON * fabs(c.root));
  ck_assert_int_le(c.calls, 200);
}

/* Both ends are on the same side of the root, in either order, or one end is NaN. */
LOOP_TEST(without_a_change_of_sign_there_is_no_root, 0, 6) {
  static const double ENDS[][2] = {{3.0, 4.0}, {4.0, 3.0}, {1.0, 2.0},
                                   {2.0, 1.0}, {NAN, 3.0}, {1.0, NAN}};
  cubic up = {2.385, 1.0, 0}, down = {2.385, -1.0, 0};
  ck_assert_double_nan(po_root(cubic_at, &up, ENDS[_i][0], ENDS[_i][1]));
  ck_assert_double_nan(po_root(cubic_at, &down, ENDS[_i][0], ENDS[_i][1]));
}

TEST(an_end_may_be_the_root) {
  cubic c = {2.385, 1.0, 0};
  ck_assert_double_eq(po_root(cubic_at, &c, 2.385, 3.0), 2.385);
  ck_assert_double_eq(po_root(cubic_at, &c, 1.0, 2.385), 2.385);
}

/* A step from -1 to 1. Its slope does not help, so it is found by bisection, to the last bit. */
static double step_at(double x, const void *data) {
  return x < *(const double *)data ? -1.0 : 1.0;
}

TEST(a_step_is_found_to_the_last_bit) {
  const double at = 0.71;
  const double x = po_root(step_at, &at, -3.0, 5.0);
  ck_assert_double_eq_tol(x, at, 2.0 * DBL_EPSILON);
}

static bool is_below(double x, const void *data) {
  return x < *(const double *)data;
}

TEST(bisection_ends_at_the_last_bits_or_at_a_tolerance) {
  const double at = 2.385;
  double low = 1.0, high = 3.0;
  po_bisect(is_below, &at, 0.0, &low, &high);
  ck_assert_double_le(low, at);
  ck_assert_double_ge(high, at);
  ck_assert_double_le(high - low, 2.0 * DBL_EPSILON * at);
  low = 1.0;
  high = 3.0;
  po_bisect(is_below, &at, 1e-3, &low, &high);
  ck_assert_double_lt(high - low, 1e-3 * high);
  ck_assert_double_gt(high - low, 0.25e-3 * high);
}
