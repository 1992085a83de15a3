/* Dense linear algebra: the only file that names LAPACKE and CBLAS. Matrices are flat,
 * column-major. */
#ifndef PO_LINEAR_H
#define PO_LINEAR_H

#include <stddef.h>

#include "po_status.h"

/* Keeps OpenBLAS to one thread: solves run in parallel, not the algebra inside them. Does nothing
 * the second time. */
void po_linear_single_thread(void);

/* The same, and makes sure that so many threads of the program can solve at a time. OpenBLAS maps a
 * work area of 128 MB of address space (x86-64) for each when it first solves, and where there is
 * no room for it tries again for ever. Does nothing when they are there.
 * Status: PO_NO_MEMORY when the address space is too small. */
po_status po_linear_reserve(int threads);

/* "OpenBLAS 0.3.21 ..." : the library this process runs on; "Haswell": the kernels it chose for the
 * processor, or OPENBLAS_CORETYPE did. Both determine the last bits of results. */
const char *po_linear_library(void);
const char *po_linear_kernels(void);

/* LU in place with partial pivoting; in single precision, see po_factors.h. Given: a, n x n with
 * leading dimension `stride`; pivots, n. Status: PO_SINGULAR when a pivot is exactly zero. */
po_status po_linear_factorize(size_t n, double *a, size_t stride, int *pivots);
po_status po_linear_factorize_single(size_t n, float *a, size_t stride, int *pivots);

/* Solves with the factors; x, n, holds the right-hand side and then the solution. */
void po_linear_solve(size_t n, const double *a, size_t stride, const int *pivots, double *x);
void po_linear_solve_single(size_t n, const float *a, size_t stride, const int *pivots, float *x);

/* The same with the transpose of the matrix. */
void po_linear_solve_transposed(size_t n, const double *a, size_t stride, const int *pivots,
                                double *x);

/* The 1-norm: the largest sum of the moduli of a column. */
double po_linear_norm(size_t n, const double *a, size_t stride);

/* An estimate (from below, mostly within a factor of 3: Higham, Accuracy and Stability, Ch. 15) of
 * the condition number in the 1-norm. Given: the factors, and the norm before. Returned: INFINITY
 * when singular; NaN without memory. */
double po_linear_condition(size_t n, const double *a, size_t stride, double norm);

/* y = A x, A rows x columns with leading dimension `stride`. */
void po_linear_apply(size_t rows, size_t columns, const double *a, size_t stride, const double *x,
                     double *y);

/* The same with the transpose: y (columns) = A^T x (rows). */
void po_linear_apply_transposed(size_t rows, size_t columns, const double *a, size_t stride,
                                const double *x, double *y);

/* y += factor x, n. */
void po_linear_add(size_t n, double factor, const double *x, double *y);

double po_linear_dot(size_t n, const double *x, const double *y);

#endif
