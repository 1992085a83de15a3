/* Dense linear algebra. Matrices are flat and column-major. The order of all operations is fixed,
 * so that the results are the same on every processor (po_dense.c). Only the condition number is
 * LAPACK's (po_linear.c). */
#ifndef PO_LINEAR_H
#define PO_LINEAR_H

#include <stddef.h>

#include "po_status.h"

/* The version of the loaded library, e.g. "OpenBLAS 0.3.21 ...". */
const char *po_linear_library(void);

/* LU factorisation in place with partial pivoting, in double or single precision (see
 * po_equilibrium.h). Given: a, n x n with leading dimension `stride`. Returned: the factors in a;
 * pivots, n, from 1 as LAPACK's. Of equal moduli the first is the pivot. Error: as dgetrf, whose
 * factors differ by rounding. Status: PO_SINGULAR if a pivot is exactly zero; those of
 * po_deadline_check, with which the factors are unfinished. */
po_status po_linear_factorize(size_t n, double *a, size_t stride, int *pivots);
po_status po_linear_factorize_single(size_t n, float *a, size_t stride, int *pivots);

/* Solves a linear system with the LU factors. Given: x, n, the right-hand side. Returned: in x, the
 * solution. */
void po_linear_solve(size_t n, const double *a, size_t stride, const int *pivots, double *x);
void po_linear_solve_single(size_t n, const float *a, size_t stride, const int *pivots, float *x);

/* As po_linear_solve, with the transpose of the matrix. */
void po_linear_solve_transposed(size_t n, const double *a, size_t stride, const int *pivots,
                                double *x);

/* Returned: the 1-norm of the matrix, the largest sum of the moduli of a column. */
double po_linear_norm(size_t n, const double *a, size_t stride);

/* An estimate of the condition number in the 1-norm; it is a lower bound, mostly within a factor of
 * 3 (Higham, Accuracy and Stability, Ch. 15), and rounded to seven digits: the last ones depend on
 * the processor. Given: the LU factors; norm, the 1-norm of the matrix before the factorisation.
 * Returned: INFINITY for a singular matrix; NaN if memory runs out. */
double po_linear_condition(size_t n, const double *a, size_t stride, double norm);

/* y = A x. Given: a, rows x columns with leading dimension `stride`; x, columns. Returned: y,
 * rows. */
void po_linear_apply(size_t rows, size_t columns, const double *a, size_t stride, const double *x,
                     double *y);

/* y = A^T x. Given: a as above; x, rows. Returned: y, columns. */
void po_linear_apply_transposed(size_t rows, size_t columns, const double *a, size_t stride,
                                const double *x, double *y);

/* y += factor * x, vectors of length n. */
void po_linear_add(size_t n, double factor, const double *x, double *y);

/* Returned: the scalar product of x and y, vectors of length n. */
double po_linear_dot(size_t n, const double *x, const double *y);

#endif
