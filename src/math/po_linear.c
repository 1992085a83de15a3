#include "po_linear.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <threads.h>

extern void openblas_set_num_threads(int threads);
extern char *openblas_get_config(void);
extern char *openblas_get_corename(void);
extern int blas_thread_shutdown_(void) __attribute__((weak)); /* NULL: a library without threads */

/* OpenBLAS starts a thread a core when it is loaded. They wait by asking for work again and again:
 * the processor time of a short solve once more. */
static void end_threads(void) {
  openblas_set_num_threads(1);
  if (blas_thread_shutdown_)
    blas_thread_shutdown_();
}

/* Once, since openblas_set_num_threads starts ended threads again. */
void po_linear_single_thread(void) {
  static once_flag ended = ONCE_FLAG_INIT;
  call_once(&ended, end_threads);
}

const char *po_linear_library(void) {
  return openblas_get_config();
}

const char *po_linear_kernels(void) {
  return openblas_get_corename();
}

po_status po_linear_factorize(size_t n, double *a, size_t stride, int *pivots) {
  const lapack_int info = LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, (lapack_int)n, (lapack_int)n, a,
                                              (lapack_int)stride, pivots);
  return info > 0 ? PO_SINGULAR : PO_OK;
}

void po_linear_solve(size_t n, const double *a, size_t stride, const int *pivots, double *x) {
  LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'N', (lapack_int)n, 1, a, (lapack_int)stride, pivots, x,
                      (lapack_int)n);
}

po_status po_linear_factorize_single(size_t n, float *a, size_t stride, int *pivots) {
  const lapack_int info = LAPACKE_sgetrf_work(LAPACK_COL_MAJOR, (lapack_int)n, (lapack_int)n, a,
                                              (lapack_int)stride, pivots);
  return info > 0 ? PO_SINGULAR : PO_OK;
}

void po_linear_solve_single(size_t n, const float *a, size_t stride, const int *pivots, float *x) {
  LAPACKE_sgetrs_work(LAPACK_COL_MAJOR, 'N', (lapack_int)n, 1, a, (lapack_int)stride, pivots, x,
                      (lapack_int)n);
}

void po_linear_solve_transposed(size_t n, const double *a, size_t stride, const int *pivots,
                                double *x) {
  LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'T', (lapack_int)n, 1, a, (lapack_int)stride, pivots, x,
                      (lapack_int)n);
}

double po_linear_norm(size_t n, const double *a, size_t stride) {
  double largest = 0.0;
  for (size_t j = 0; j < n; ++j)
    largest = fmax(largest, cblas_dasum((int)n, a + stride * j, 1));
  return largest;
}

double po_linear_condition(size_t n, const double *a, size_t stride, double norm) {
  double reciprocal = 0.0;
  const lapack_int info = LAPACKE_dgecon(LAPACK_COL_MAJOR, '1', (lapack_int)n, a,
                                         (lapack_int)stride, norm, &reciprocal);
  return info ? (double)NAN : 1.0 / reciprocal;
}

void po_linear_apply(size_t rows, size_t columns, const double *a, size_t stride, const double *x,
                     double *y) {
  cblas_dgemv(CblasColMajor, CblasNoTrans, (int)rows, (int)columns, 1.0, a, (int)stride, x, 1, 0.0,
              y, 1);
}

void po_linear_apply_transposed(size_t rows, size_t columns, const double *a, size_t stride,
                                const double *x, double *y) {
  cblas_dgemv(CblasColMajor, CblasTrans, (int)rows, (int)columns, 1.0, a, (int)stride, x, 1, 0.0, y,
              1);
}

double po_linear_dot(size_t n, const double *x, const double *y) {
  return cblas_ddot((int)n, x, 1, y, 1);
}

void po_linear_add(size_t n, double factor, const double *x, double *y) {
  cblas_daxpy((int)n, factor, x, 1, y, 1);
}
