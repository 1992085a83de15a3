/* The factors of dense matrices are those of the plain algorithm to the last bit, whatever the
 * width of vectors and blocks: with the kernels of OpenBLAS for other processors pins did not hold.
 * OpenBLAS used to start one thread for each core in every process. The threads polled for work, so
 * that a solve of 40 ms took 80 ms of processor time. */
#include <dirent.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_linear.h"
#include "po_widths.h"
#include "run.h"

extern void openblas_set_num_threads(int threads);
extern int openblas_get_num_threads(void);

/* The parts that are written in vectors, for both lengths. */
enum { STRIPS = 4, DEPTH = 128, PANEL = 16 };
#define NAME(x) x##_tested
typedef struct {
  void (*subtract)(size_t rows, size_t columns, size_t depth, const double *a, const double *b,
                   double *c, size_t stride);
  void (*forward)(size_t n, size_t columns, const double *l, double *b, size_t stride);
} vector_parts_tested;
#define REAL double
#define ROWS 8
#define BYTES 16
#define COLUMNS 3
#define TARGET
#define SIZED(x) x##_16
#include "po_dense_tiles.h"
#if defined(__x86_64__)
#define BYTES 32
#define COLUMNS 6
#define TARGET __attribute__((target("avx2")))
#define SIZED(x) x##_32
#include "po_dense_tiles.h"
#endif

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

TEST(linear_algebra_starts_no_threads) {
  static double a[N * N], x[N];
  static int pivots[N];
  openblas_set_num_threads(2);
  const int before = threads();
  for (int j = 0; j < N; ++j)
    for (int i = 0; i < N; ++i) {
      a[i + N * j] = (i == j ? 2.385 : 0.0) + sin(1.7 * i + 0.61 * j * j) / N;
      x[i] += a[i + N * j] * (1.0 + 0.013 * j);
    }
  ck_assert_int_eq(po_linear_factorize(N, a, N, pivots), PO_OK);
  po_linear_solve(N, a, N, pivots, x);
  for (int j = 0; j < N; ++j)
    ck_assert_double_eq_tol(x[j], 1.0 + 0.013 * j, 1e-13);
  ck_assert(po_linear_condition(N, a, N, 3.0) > 1.0);
  ck_assert_int_eq(threads(), before);
  ck_assert_int_eq(openblas_get_num_threads(), 2); /* the process has its threads back */
}

/* With two equal columns a pivot is zero, in double and in single precision. With different columns
 * it is not. */
TEST(singular_matrix_is_reported) {
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

/* Numbers of all sizes from a generator of its own. */
static double draw(void) {
  static unsigned long long state = 5;
  state = state * 6364136223846793005ULL + 1442695040888963407ULL;
  const double unit = ldexp((double)(state >> 11), -53);
  return ldexp(2.0 * unit - 1.0, (int)(state >> 60) - 8);
}

static void draw_all(size_t count, double *x) {
  for (size_t i = 0; i < count; ++i)
    x[i] = draw();
}

/* The plain algorithm: columns one after another, whole rows exchanged. */
#define PLAIN(real, name)                                                                          \
  static void name(size_t n, real *a, size_t stride, int *pivots) {                                \
    for (size_t k = 0; k < n; ++k) {                                                               \
      size_t pivot = k;                                                                            \
      for (size_t i = k + 1; i < n; ++i)                                                           \
        if (fabs(a[i + k * stride]) > fabs(a[pivot + k * stride]))                                 \
          pivot = i;                                                                               \
      pivots[k] = (int)pivot + 1;                                                                  \
      for (size_t j = 0; j < n; ++j) {                                                             \
        const real above = a[k + j * stride];                                                      \
        a[k + j * stride] = a[pivot + j * stride];                                                 \
        a[pivot + j * stride] = above;                                                             \
      }                                                                                            \
      for (size_t i = k + 1; i < n; ++i)                                                           \
        a[i + k * stride] /= a[k + k * stride];                                                    \
      for (size_t j = k + 1; j < n; ++j)                                                           \
        for (size_t i = k + 1; i < n; ++i)                                                         \
          a[i + j * stride] -= a[i + k * stride] * a[k + j * stride];                              \
    }                                                                                              \
  }
PLAIN(double, plain_double)
PLAIN(float, plain_single)

TEST(factors_are_those_of_the_plain_algorithm) {
  static double a[N * N], b[N * N];
  static float c[N * N], d[N * N];
  int pivots[N], expected[N];
  for (size_t n = 1; n <= N; n = n < 70 ? n + 1 : n < 128 ? 128 : n < 150 ? n + 11 : n + 83) {
    const size_t stride = n < N ? n + 1 : n;
    draw_all(n * stride, a);
    memcpy(b, a, sizeof *a * n * stride);
    for (size_t i = 0; i < n * stride; ++i)
      c[i] = d[i] = (float)a[i];
    ck_assert_int_eq(po_linear_factorize(n, a, stride, pivots), PO_OK);
    plain_double(n, b, stride, expected);
    ck_assert_msg(!memcmp(pivots, expected, n * sizeof *pivots), "pivots of order %zu", n);
    ck_assert_msg(!memcmp(a, b, sizeof *a * n * stride), "factors of order %zu", n);
    ck_assert_int_eq(po_linear_factorize_single(n, c, stride, pivots), PO_OK);
    plain_single(n, d, stride, expected);
    ck_assert_msg(!memcmp(c, d, sizeof *c * n * stride), "factors in single precision, %zu", n);
  }
}

/* The processor of this machine uses one of the lengths; both have to give the same. */
TEST(vectors_of_all_lengths_give_the_same) {
#if defined(__x86_64__)
  enum { M = 301 };
  static double a[M * M], b[M * M];
  if (!__builtin_cpu_supports("avx2"))
    return;
  for (size_t rows = 1; rows < M / 2; rows += 13)
    for (size_t depth = 1; depth <= rows; depth += 29) {
      draw_all(M * M, a);
      memcpy(b, a, sizeof a);
      subtract_16(rows, M - depth, depth, a + depth, a + depth * M, a + depth + depth * M, M);
      subtract_32(rows, M - depth, depth, b + depth, b + depth * M, b + depth + depth * M, M);
      ck_assert_msg(!memcmp(a, b, sizeof a), "product with %zu rows, depth %zu", rows, depth);
    }
  for (size_t n = 1; n <= PANEL; ++n) {
    draw_all(M * M, a);
    memcpy(b, a, sizeof a);
    forward_16(n, M - n, a, a + n * M, M);
    forward_32(n, M - n, b, b + n * M, M);
    ck_assert_msg(!memcmp(a, b, sizeof a), "substitution of order %zu", n);
  }
#endif
}

/* LAPACK's solution differs by the rounding of both; so does that of the transpose. */
TEST(solutions_are_those_of_lapack) {
  static double a[N * N], b[N * N], x[N], y[N];
  int pivots[N], theirs[N];
  for (int n = 1; n <= N; n = 2 * n + 1) {
    draw_all((size_t)n * (size_t)n, a);
    for (int i = 0; i < n; ++i)
      a[i + n * i] += 1000.0;
    memcpy(b, a, sizeof a);
    po_linear_factorize((size_t)n, a, (size_t)n, pivots);
    LAPACKE_dgetrf(LAPACK_COL_MAJOR, n, n, b, n, theirs);
    for (int transposed = 0; transposed < 2; ++transposed) {
      draw_all((size_t)n, x);
      memcpy(y, x, sizeof x);
      (transposed ? po_linear_solve_transposed : po_linear_solve)((size_t)n, a, (size_t)n, pivots,
                                                                  x);
      LAPACKE_dgetrs(LAPACK_COL_MAJOR, transposed ? 'T' : 'N', n, 1, b, n, theirs, y, n);
      double largest = 0.0;
      for (int i = 0; i < n; ++i)
        largest = fmax(largest, fabs(y[i]));
      for (int i = 0; i < n; ++i)
        ck_assert_double_eq_tol(x[i], y[i], 1e-11 * largest);
    }
  }
}

/* NaN neither stops a factorisation nor is hidden by it. */
TEST(nan_stays) {
  double a[9] = {1, 2, 3, 4, (double)NAN, 7, 4, 5, 7}, x[3] = {1, 1, 1};
  int pivots[3];
  ck_assert_int_eq(po_linear_factorize(3, a, 3, pivots), PO_OK);
  po_linear_solve(3, a, 3, pivots, x);
  ck_assert_double_nan(x[0]);
}
