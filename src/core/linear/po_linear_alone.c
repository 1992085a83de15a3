/* In place of po_linear.c where there is no OpenBLAS: libraries that need the C library alone, and
 * the solver in a page. The condition number is estimated by the method of LAPACK's dgecon, with
 * the sums of po_dense.c. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "po_linear.h"
#include "po_memory.h"

/* The inverse of a matrix by its factors, whose 1-norm is estimated. */
typedef struct {
  size_t n, stride;
  const double *a;
  double *x;   /* n */
  int *pivots; /* n; none: an exchange of columns does not change the norm of the inverse */
  double estimate;
} inverse;

/* x = A^-1 x. Returned: whether the sum of the moduli is greater than the estimate, which it
 * becomes. */
static bool raise_estimate(inverse *v, double factor) {
  po_linear_solve(v->n, v->a, v->stride, v->pivots, v->x);
  double sum = 0.0;
  for (size_t i = 0; i < v->n; ++i)
    sum += fabs(v->x[i]);
  const bool greater = !(factor * sum <= v->estimate);
  v->estimate = greater ? factor * sum : v->estimate;
  return greater;
}

/* x = A^-T sign(x). Returned: the index of the greatest modulus. */
static size_t steepest(inverse *v) {
  size_t greatest = 0;
  for (size_t i = 0; i < v->n; ++i)
    v->x[i] = v->x[i] < 0.0 ? -1.0 : 1.0;
  po_linear_solve_transposed(v->n, v->a, v->stride, v->pivots, v->x);
  for (size_t i = 1; i < v->n; ++i)
    greatest = fabs(v->x[i]) > fabs(v->x[greatest]) ? i : greatest;
  return greatest;
}

/* Algorithm 4.1 of Higham, ACM Trans. Math. Softw. 14 (1988) 381-396: steps to another column of
 * the inverse while the norm grows, and at last a vector of alternating signs. */
static void estimate_norm(inverse *v) {
  enum { MOST_STEPS = 5 };
  const size_t n = v->n;
  for (size_t i = 0; i < n; ++i)
    v->x[i] = 1.0 / (double)n;
  raise_estimate(v, 1.0);
  size_t last = n;
  for (int step = 1; step < MOST_STEPS; ++step) {
    const size_t unit = steepest(v);
    if (unit == last)
      break;
    for (size_t i = 0; i < n; ++i)
      v->x[i] = i == unit;
    last = unit;
    if (!raise_estimate(v, 1.0))
      break;
  }
  for (size_t i = 0; i < n; ++i)
    v->x[i] = (i % 2 ? -1.0 : 1.0) * (1.0 + (double)i / (double)(n > 1 ? n - 1 : 1));
  raise_estimate(v, 2.0 / (3.0 * (double)n));
}

double po_linear_condition(size_t n, const double *a, size_t stride, double norm) {
  po_arena arrays = {0};
  inverse v = {.n = n,
               .stride = stride,
               .a = a,
               .x = po_arena_reserve(&arrays, n, sizeof *v.x),
               .pivots = po_arena_reserve(&arrays, n, sizeof *v.pivots)};
  double condition = (double)NAN;
  char rounded[24];
  for (size_t i = 0; i < n && v.pivots; ++i)
    v.pivots[i] = (int)i + 1;
  if (!arrays.ran_out) {
    estimate_norm(&v);
    snprintf(rounded, sizeof rounded, "%.6e", norm * v.estimate);
    condition = isfinite(v.estimate) ? strtod(rounded, NULL) : (double)INFINITY;
  }
  po_arena_free(&arrays);
  return condition;
}
