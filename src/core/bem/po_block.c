#include "po_block.h"

#include <math.h>
#include <stdint.h>

#include "po_barycentric.h"
#include "po_widths.h"

/* The most groups of PO_LANES values in a column. */
enum { MOST_GROUPS = 4 };
typedef double lanes __attribute__((vector_size(PO_LANES * sizeof(double)), aligned(8), may_alias));
typedef int64_t mask __attribute__((vector_size(PO_LANES * sizeof(int64_t))));

/* y = start + A x, with 4 * groups rows. */
PO_INLINE void apply(size_t groups, size_t columns, const double *a, const double *x,
                     const double *start, double *y) {
  const lanes *from = (const lanes *)a;
  lanes *to = (lanes *)y, sum[MOST_GROUPS];
  for (size_t p = 0; p < groups; ++p)
    sum[p] = ((const lanes *)start)[p];
  for (size_t j = 0; j < columns; ++j, from += groups)
    for (size_t p = 0; p < groups; ++p)
      sum[p] += from[p] * x[j];
  for (size_t p = 0; p < groups; ++p)
    to[p] = sum[p];
}

/* Adds the sums (v_0 + v_1) + (v_2 + v_3) of four vectors to the lanes of another. */
PO_INLINE void add_sums(const lanes *v, lanes *to) {
  const lanes first = __builtin_shufflevector(v[0], v[1], 0, 4, 2, 6) +
                      __builtin_shufflevector(v[0], v[1], 1, 5, 3, 7);
  const lanes second = __builtin_shufflevector(v[2], v[3], 0, 4, 2, 6) +
                       __builtin_shufflevector(v[2], v[3], 1, 5, 3, 7);
  *to += __builtin_shufflevector(first, second, 0, 1, 4, 5) +
         __builtin_shufflevector(first, second, 2, 3, 6, 7);
}

PO_INLINE void apply_transposed(size_t groups, size_t columns, const double *a, const double *x,
                                double *y) {
  const lanes *from = (const lanes *)a;
  lanes own[MOST_GROUPS];
  for (size_t p = 0; p < groups; ++p)
    own[p] = ((const lanes *)x)[p];
  for (size_t j = 0; j < columns; j += PO_LANES) {
    lanes part[PO_LANES];
    for (size_t k = 0; k < PO_LANES; ++k, from += groups) {
      part[k] = from[0] * own[0];
      for (size_t p = 1; p < groups; ++p)
        part[k] += from[p] * own[p];
    }
    add_sums(part, (lanes *)(y + j));
  }
}

PO_FOR_ALL_WIDTHS void po_block_apply(const double *block, const double *x, double *y) {
  apply(PO_TABLE_ORDER / PO_LANES, PO_TABLE_ORDER, block, x, y, y);
}

PO_FOR_ALL_WIDTHS void po_block_apply_from(size_t columns, const double *a, const double *x,
                                           const double *start, double *y) {
  apply(4, columns, a, x, start, y);
}

PO_FOR_ALL_WIDTHS void po_block_apply_transposed(size_t rows, size_t columns, const double *a,
                                                 const double *x, double *y) {
  if (rows == 12)
    apply_transposed(3, columns, a, x, y);
  else
    apply_transposed(4, columns, a, x, y);
}

PO_FOR_ALL_WIDTHS void po_block_apply_both(const double *block, const double *x, double *y,
                                           const double *u, double *v) {
  const lanes *b = (const lanes *)block, *from = (const lanes *)u;
  lanes *to = (lanes *)y;
  lanes y0 = to[0], y1 = to[1], y2 = to[2];
  const lanes u0 = from[0], u1 = from[1], u2 = from[2];
  for (size_t j = 0; j < PO_TABLE_ORDER; j += PO_LANES) {
    lanes part[PO_LANES];
    for (size_t k = 0; k < PO_LANES; ++k, b += 3) {
      const lanes b0 = b[0], b1 = b[1], b2 = b[2];
      y0 += b0 * x[j + k];
      y1 += b1 * x[j + k];
      y2 += b2 * x[j + k];
      part[k] = b0 * u0 + b1 * u1 + b2 * u2;
    }
    add_sums(part, (lanes *)(v + j));
  }
  to[0] = y0;
  to[1] = y1;
  to[2] = y2;
}

/* Rows of the larger matrices; columns of a product that are made together, so that a value of A is
 * read once for both. */
enum { ROWS = 16, PAIR = 2 };

PO_FOR_ALL_WIDTHS void po_block_multiply(size_t inner, size_t columns, const double *a,
                                         const double *b, const double *start, double *c) {
  for (size_t j = 0; j < columns;
       j += PAIR, b += PAIR * ROWS, start += PAIR * ROWS, c += PAIR * ROWS) {
    const lanes *from = (const lanes *)a;
    lanes sum[PAIR * MOST_GROUPS];
    for (size_t p = 0; p < PAIR * MOST_GROUPS; ++p)
      sum[p] = ((const lanes *)start)[p];
    for (size_t k = 0; k < inner; ++k, from += MOST_GROUPS)
      for (size_t p = 0; p < MOST_GROUPS; ++p) {
        sum[p] += from[p] * b[k];
        sum[MOST_GROUPS + p] += from[p] * b[k + ROWS];
      }
    for (size_t p = 0; p < PAIR * MOST_GROUPS; ++p)
      ((lanes *)c)[p] = sum[p];
  }
}

PO_INLINE void exchange(size_t groups, lanes *a, lanes *b) {
  for (size_t p = 0; p < groups; ++p) {
    const lanes x = a[p];
    a[p] = b[p];
    b[p] = x;
  }
}

/* a - factor * b, with a = 0 where the mask is 0. */
PO_INLINE void subtract(size_t groups, const mask *keep, double factor, const lanes *b, lanes *a) {
  for (size_t p = 0; p < groups; ++p)
    a[p] = (lanes)((mask)a[p] & keep[p]) - factor * b[p];
}

/* Works on the columns as the rows of the transpose, whose inverse is the transpose of the inverse.
 * Column k of the rows is replaced by a mask: a store of one value, before its vector is read,
 * makes the processor wait. */
PO_INLINE int invert(size_t groups, double *a) {
  const size_t n = groups * PO_LANES;
  size_t from[MOST_GROUPS * PO_LANES];
  int sign = 1;
  for (size_t k = 0; k < n; ++k) {
    size_t best = k;
    for (size_t i = k + 1; i < n; ++i)
      if (fabs(a[k + n * i]) > fabs(a[k + n * best]))
        best = i;
    from[k] = best;
    lanes *row = (lanes *)(a + n * k);
    if (best != k) {
      exchange(groups, row, (lanes *)(a + n * best));
      sign = -sign;
    }
    const double pivot = a[k + n * k];
    if (!(fabs(pivot) > 0.0))
      return 0;
    if (pivot < 0.0)
      sign = -sign;
    static const mask FIRST = {0, 1, 2, 3};
    static const lanes ONE = {1.0, 1.0, 1.0, 1.0};
    lanes own[MOST_GROUPS];
    mask keep[MOST_GROUPS];
    for (size_t p = 0; p < groups; ++p) {
      keep[p] = FIRST != (int64_t)k - (int64_t)(p * PO_LANES);
      own[p] = (lanes)(((mask)row[p] & keep[p]) | ((mask)ONE & ~keep[p])) * (1.0 / pivot);
    }
    for (size_t i = 0; i < n; ++i)
      subtract(groups, keep, a[k + n * i], own, (lanes *)(a + n * i));
    for (size_t p = 0; p < groups; ++p)
      row[p] = own[p];
  }
  for (size_t k = n; k-- > 0;) /* the rows that were exchanged are columns of the inverse */
    if (from[k] != k)
      for (size_t i = 0; i < n; ++i) {
        const double x = a[k + n * i];
        a[k + n * i] = a[from[k] + n * i];
        a[from[k] + n * i] = x;
      }
  return sign;
}

PO_FOR_ALL_WIDTHS int po_block_invert(size_t n, double *a) {
  return n == 12 ? invert(3, a) : invert(4, a);
}
