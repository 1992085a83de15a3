/* Products of small matrices, column-major, with 12 or 16 rows. They are compiled for several
 * widths of vector registers; the sums are the same, in the same order, for all of them. */
#ifndef PO_BLOCK_H
#define PO_BLOCK_H

#include <stddef.h>

#include "po_panel_table.h"

/* Values of the influence block of two panels. */
enum { PO_BLOCK_SIZE = PO_TABLE_ORDER * PO_TABLE_ORDER };

/* y += B x, for the influence block of two panels. */
void po_block_apply(const double *block, const double *x, double *y);

/* y += A^T x. Given: A, rows x columns; rows, 12 or 16; columns, a multiple of 4. */
void po_block_apply_transposed(size_t rows, size_t columns, const double *a, const double *x,
                               double *y);

/* y = start + A x, for a matrix of 16 rows. Given: start, which may be y. A start that has just
 * been written in parts narrower than a register, as by memset, is slow to read. */
void po_block_apply_from(size_t columns, const double *a, const double *x, const double *start,
                         double *y);

/* y += B x and v += B^T u, for the influence block of two panels. */
void po_block_apply_both(const double *block, const double *x, double *y, const double *u,
                         double *v);

/* C = start + A B, for matrices of 16 rows. Given: inner, the columns of A, and
 * the rows of B that are read; columns of B and C, a multiple of 2; start, which may be C. */
void po_block_multiply(size_t inner, size_t columns, const double *a, const double *b,
                       const double *start, double *c);

/* Replaces a square matrix of order 12 or 16 by its inverse (Gauss and Jordan, with partial
 * pivoting). Returned: the sign of its determinant; 0 if it is singular, and then the matrix is
 * undefined. */
int po_block_invert(size_t n, double *a);

#endif
