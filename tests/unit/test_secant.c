/* Broyden's updates. For a linear system they end after finitely many steps, for any initial
 * inverse.
 */
#include <math.h>
#include <stdbool.h>

#include "po_secant.h"
#include "run.h"

enum { N = 4 };

/* Not symmetric. Its difference from the unit matrix has the maximum norm 0.61. */
static const double MATRIX[N][N] = {{1.23, 0.11, -0.07, 0.19},
                                    {-0.31, 0.89, 0.13, 0.03},
                                    {0.05, -0.17, 1.37, 0.02},
                                    {0.09, 0.23, 0.041, 0.77}};
static const double SOLUTION[N] = {2.385, -0.613, 1.17, 0.0451};

/* MATRIX times (SOLUTION - x): the residual, with the sign of the correction. */
static void change_of(const double *x, double *change) {
  for (int i = 0; i < N; ++i) {
    change[i] = 0.0;
    for (int j = 0; j < N; ++j)
      change[i] += MATRIX[i][j] * (SOLUTION[j] - x[j]);
  }
}

/* Iterates from 0 with the unit matrix as initial inverse. Returned: the error that remains. */
static double iterate(int steps, bool updated, double scale) {
  po_secant s;
  po_arena arrays = {0};
  po_secant_allocate(&s, N, &arrays);
  ck_assert(!arrays.ran_out);
  po_secant_clear(&s, N);
  for (int j = 0; j < N; ++j)
    s.scale[j] = 1.0 + scale * j;
  double x[N] = {0.0}, change[N];
  double error = 0.0;
  for (int k = 0; k < steps; ++k) {
    change_of(x, change);
    if (updated)
      po_secant_step(&s, change);
    for (int j = 0; j < N; ++j)
      x[j] += change[j];
  }
  for (int j = 0; j < N; ++j)
    error = fmax(error, fabs(x[j] - SOLUTION[j]));
  po_arena_free(&arrays);
  return error;
}

/* D. M. Gay, SIAM J. Numer. Anal. 16 (1979) 623: after 2 n steps the solution is exact. */
LOOP_TEST(broyden_solves_a_linear_system_in_finitely_many_steps, 0, 3) {
  ck_assert_double_lt(iterate(2 * N, true, 1.7 * _i), 1e-13);
  ck_assert_double_gt(iterate(2 * N, false, 1.7 * _i), 1e-4);
}

/* If there are more steps than room for corrections, the corrections are discarded. The iteration
 * still converges. */
TEST(iteration_converges_if_corrections_are_discarded) {
  ck_assert_double_lt(iterate(3 * PO_SECANT_DEPTH, true, 0.0), 1e-13);
}
