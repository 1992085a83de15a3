/* The condition number that po_linear_alone.c estimates is that of LAPACK's dgecon to the digits
 * that are printed. */
#include <lapacke.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "po_linear.h"
#include "run.h"

enum { MOST = 90 };

static double random_number(unsigned *state) {
  *state = *state * 1664525u + 1013904223u;
  return (double)(*state >> 8) / (1 << 23) - 1.0;
}

/* A matrix of order n, whose columns have sizes from 1 to 10^-decades. */
static void fill(size_t n, double decades, unsigned seed, double *a) {
  for (size_t j = 0; j < n; ++j)
    for (size_t i = 0; i < n; ++i)
      a[i + n * j] =
          (random_number(&seed) + (i == j)) * pow(10.0, -decades * (double)j / (double)n);
}

LOOP_TEST(it_is_that_of_lapack, 0, MOST) {
  static const double DECADES[] = {0.0, 3.0, 11.0};
  static double a[MOST * MOST];
  const size_t n = (size_t)_i + 1;
  for (int k = 0; k < 3; ++k) {
    int pivots[MOST];
    double reciprocal;
    char of_lapack[24], own[24];
    fill(n, DECADES[k], 7u * (unsigned)_i + (unsigned)k, a);
    const double norm = po_linear_norm(n, a, n);
    ck_assert_int_eq(po_linear_factorize(n, a, n, pivots), PO_OK);
    ck_assert_int_eq(
        LAPACKE_dgecon(LAPACK_COL_MAJOR, '1', (lapack_int)n, a, (lapack_int)n, norm, &reciprocal),
        0);
    snprintf(of_lapack, sizeof of_lapack, "%.6e", 1.0 / reciprocal);
    snprintf(own, sizeof own, "%.6e", po_linear_condition(n, a, n, norm));
    ck_assert_str_eq(own, of_lapack);
  }
}

TEST(that_of_a_singular_matrix_is_infinite) {
  double a[] = {1.0, 2.0, 2.0, 4.0};
  int pivots[2];
  ck_assert_int_eq(po_linear_factorize(2, a, 2, pivots), PO_SINGULAR);
  ck_assert_double_infinite(po_linear_condition(2, a, 2, 6.0));
}
