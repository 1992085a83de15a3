/* Broyden's updates. For a linear system they end after finitely many steps, for any initial
 * inverse.
 */
#include <math.h>

#include "po_secant.h"
#include "run.h"

enum { N = 4 };

/* Not symmetric. Its difference from the unit matrix has the maximum norm 0.61. */
static const double MATRIX[N][N] = {{1.23, 0.11, -0.07, 0.19},
                                    {-0.31, 0.89, 0.13, 0.03},
                                    {0.05, -0.17, 1.37, 0.02},
                                    {0.09, 0.23, 0.041, 0.77}};
static const double SOLUTION[N] = {2.385, -0.613, 1.17, 0.0451};

/* matrix, N x N by rows, times (SOLUTION - x): the residual, with the sign of the correction. */
static void change_of(const double *matrix, const double *x, double *change) {
  for (int i = 0; i < N; ++i) {
    change[i] = 0.0;
    for (int j = 0; j < N; ++j)
      change[i] += matrix[i * N + j] * (SOLUTION[j] - x[j]);
  }
}

typedef struct {
  double error; /* that remains */
  int sign;
} outcome;

typedef enum { NO_UPDATES, UPDATES, UPDATES_OF_LINEAR } updates;

/* Iterates from 0 with the unit matrix as initial inverse. */
static outcome iterate(const double *matrix, int steps, updates which, double scale) {
  po_secant s;
  po_arena arrays = {0};
  po_secant_allocate(&s, N, &arrays);
  ck_assert(!arrays.ran_out);
  po_secant_clear(&s, N);
  for (int j = 0; j < N; ++j)
    s.scale[j] = 1.0 + scale * j;
  double x[N] = {0.0}, change[N];
  outcome o = {0.0, 0};
  for (int k = 0; k < steps; ++k) {
    change_of(matrix, x, change);
    if (which != NO_UPDATES)
      po_secant_step(&s, which == UPDATES_OF_LINEAR, change);
    for (int j = 0; j < N; ++j)
      x[j] += change[j];
  }
  for (int j = 0; j < N; ++j)
    o.error = fmax(o.error, fabs(x[j] - SOLUTION[j]));
  o.sign = s.sign;
  po_arena_free(&arrays);
  return o;
}

/* D. M. Gay, SIAM J. Numer. Anal. 16 (1979) 623: after 2 n steps the solution is exact. */
LOOP_TEST(broyden_solves_a_linear_system_in_finitely_many_steps, 0, 3) {
  ck_assert_double_lt(iterate(MATRIX[0], 2 * N, UPDATES, 1.7 * _i).error, 1e-13);
  ck_assert_double_gt(iterate(MATRIX[0], 2 * N, NO_UPDATES, 1.7 * _i).error, 1e-4);
}

/* If there are more steps than room for corrections, the corrections are discarded. The iteration
 * still converges. */
TEST(iteration_converges_if_corrections_are_discarded) {
  ck_assert_double_lt(iterate(MATRIX[0], 3 * PO_SECANT_DEPTH, UPDATES, 0.0).error, 1e-13);
}

/* The matrix has the eigenvalue `weak`, for which the unit matrix has 1. Corrections of linear
 * equations may lengthen a step by a large factor, or reverse it, and state the sign of the
 * determinant. Where the equations are not linear, such corrections are left out. */
LOOP_TEST(eigenvalue_that_the_inverse_misses_is_found, 0, 2) {
  static const double Q[N] = {0.1, -0.7, 0.5, 0.5};
  const double weak = _i ? -0.02 : 0.02;
  double matrix[N][N];
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j)
      matrix[i][j] = (i == j) - (1.0 - weak) * Q[i] * Q[j];
  const outcome linear = iterate(matrix[0], N, UPDATES_OF_LINEAR, 0.0);
  const outcome other = iterate(matrix[0], N, UPDATES, 0.0);
  ck_assert_double_lt(linear.error, 1e-12);
  ck_assert_int_eq(linear.sign, _i ? -1 : 1);
  ck_assert_double_gt(other.error, 0.1);
  ck_assert_int_eq(other.sign, 1);
}
