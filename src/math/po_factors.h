/* The factors of a dense matrix that serve an iteration: in single precision, which takes half the
 * time of double, and leaves what rounding changes to the iteration. On smooth spheres up to mu =
 * 50 and wavy ones up to 10, at tolerances down to 1e-10, no iteration more was needed than with
 * double. */
#ifndef PO_FACTORS_H
#define PO_FACTORS_H

#include <stdbool.h>
#include <stddef.h>

#include "po_status.h"

typedef struct {
  size_t n;
  size_t room;   /* of matrix, in numbers */
  float *matrix; /* n x n, column-major; the factors once computed */
  float *right;  /* n: a right-hand side */
  int *pivots;   /* n, from 1 */
} po_factors;

/* For matrices of an order up to `capacity`. Returned: whether there was memory. */
bool po_factors_allocate(po_factors *f, size_t capacity);
void po_factors_free(po_factors *f);

/* Begins a matrix of order n. Returned: whether there was memory. */
bool po_factors_begin(po_factors *f, size_t n);

/* Puts a column, n. */
void po_factors_put(po_factors *f, size_t column, const double *values);

/* LU with partial pivoting of what was put. Status: PO_SINGULAR when a pivot is exactly zero. */
po_status po_factors_compute(po_factors *f);

/* Sign of the determinant. */
int po_factors_sign(const po_factors *f);

/* Given: x, n, the right-hand side. Returned there: the solution, to some six digits less those
 * that the condition of the matrix takes. */
void po_factors_solve(po_factors *f, double *x);

#endif
