/* LU factors of a dense matrix in single or double precision, for the solution of linear systems
 * inside an iteration (of rings and triangles). Single precision takes half the time of double
 * precision; the iteration corrects the effect of its rounding. On smooth spheres up to mu = 50 and
 * wavy spheres up to mu = 10, at tolerances down to 1e-10, no more iterations were needed than with
 * double precision. */
#ifndef PO_FACTORS_H
#define PO_FACTORS_H

#include <stdbool.h>
#include <stddef.h>

#include "po_status.h"

typedef struct {
  size_t n;
  size_t room;      /* allocated size of `matrix`, in elements */
  float *matrix;    /* n x n, column-major; the LU factors after po_factors_compute */
  float *right;     /* n: the scaled right-hand side */
  bool in_double;   /* for the owner: the next matrix is in double precision */
  bool is_double;   /* the present one is */
  size_t wide_room; /* as room, of `wide` */
  double *wide;     /* as matrix, in double precision */
  int *pivots;      /* n, row indices from 1 (LAPACK) */
} po_factors;

/* Allocates factors of matrices up to order `capacity`. Returned: false if memory runs out. */
bool po_factors_allocate(po_factors *f, size_t capacity);
void po_factors_free(po_factors *f);

/* Starts a new matrix of order n. Returned: false if memory runs out. */
bool po_factors_begin(po_factors *f, size_t n);

/* Sets a column of the matrix. Given: values, n. */
void po_factors_put(po_factors *f, size_t column, const double *values);

/* Computes the LU factors with partial pivoting. Status: PO_SINGULAR if a pivot is exactly zero. */
po_status po_factors_compute(po_factors *f);

/* Returned: the sign of the determinant, from the LU factors. */
int po_factors_sign(const po_factors *f);

/* Solves the linear system. Given: x, n, the right-hand side. Returned: in x, the solution.
 * Accuracy: about six digits, less the digits that the condition number of the matrix costs. */
void po_factors_solve(po_factors *f, double *x);

#endif
