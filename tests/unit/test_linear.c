/* OpenBLAS used to start one thread for each core in every process. The threads polled for work, so
 * that a solve of 40 ms took 80 ms of processor time. */
#include <dirent.h>
#include <math.h>

#include "po_linear.h"
#include "run.h"

enum { N = 317 }; /* OpenBLAS would use several threads for the factorisation of such a matrix */

/* The number of threads of this process. */
static int threads(void) {
  int count = 0;
  DIR *folder = opendir("/proc/self/task");
  ck_assert_ptr_nonnull(folder);
  for (struct dirent *entry; (entry = readdir(folder));)
    count += entry->d_name[0] != '.';
  closedir(folder);
  return count;
}

START_TEST(openblas_has_one_thread) {
  po_linear_single_thread();
  ck_assert_int_eq(threads(), 1);
  po_linear_single_thread();
  ck_assert_int_eq(threads(), 1);
}
END_TEST

START_TEST(linear_algebra_needs_no_threads) {
  static double a[N * N], x[N];
  static int pivots[N];
  po_linear_single_thread();
  for (int j = 0; j < N; ++j)
    for (int i = 0; i < N; ++i) {
      a[i + N * j] = (i == j ? 2.385 : 0.0) + sin(1.7 * i + 0.61 * j * j) / N;
      x[i] += a[i + N * j] * (1.0 + 0.013 * j);
    }
  ck_assert_int_eq(po_linear_factorize(N, a, N, pivots), PO_OK);
  po_linear_solve(N, a, N, pivots, x);
  for (int j = 0; j < N; ++j)
    ck_assert_double_eq_tol(x[j], 1.0 + 0.013 * j, 1e-13);
  ck_assert_int_eq(threads(), 1);
}
END_TEST

/* With two equal columns a pivot is zero, in double and in single precision. With different columns
 * it is not. */
START_TEST(singular_matrix_is_reported) {
  double a[9] = {1, 2, 3, 4, 5, 7, 4, 5, 7};
  float b[9] = {1, 2, 3, 4, 5, 7, 4, 5, 7};
  int pivots[3];
  ck_assert_int_eq(po_linear_factorize(3, a, 3, pivots), PO_SINGULAR);
  ck_assert_int_eq(po_linear_factorize_single(3, b, 3, pivots), PO_SINGULAR);
  double c[9] = {1, 2, 3, 4, 5, 7, 4, 5, 7.5}, x[3] = {9, 12, 17.5}; /* the sum of the columns */
  ck_assert_int_eq(po_linear_factorize(3, c, 3, pivots), PO_OK);
  po_linear_solve(3, c, 3, pivots, x);
  for (int j = 0; j < 3; ++j)
    ck_assert_double_eq_tol(x[j], 1.0, 1e-13);
}
END_TEST

static void add(TCase *tests) {
  tcase_add_test(tests, openblas_has_one_thread);
  tcase_add_test(tests, linear_algebra_needs_no_threads);
  tcase_add_test(tests, singular_matrix_is_reported);
}

int main(void) {
  return run_case("linear", add);
}
