#include "po_linear.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "po_deadline.h"
#include "po_widths.h"

/* Strips of tiles and columns of a packed block, 32 kB, which stays in the first cache; columns
 * that are factorised without recursion; columns that are changed between two looks at the deadline,
 * some tenths of a second where there are 10,000 rows. */
enum { STRIPS = 4, DEPTH = 128, PANEL = 16, AT_ONCE = 256 };

/* The columns of the first part of a recursion: a whole number of panels. */
static size_t half_of(size_t n) {
  return (n / 2 + PANEL - 1) / PANEL * PANEL;
}

#define REAL double
#define ROWS 8
#define NAME(x) x
#include "po_dense_kernels.h"

#define REAL float
#define ROWS 16
#define NAME(x) x##_single
#include "po_dense_kernels.h"

PO_FOR_ALL_WIDTHS double po_linear_dot(size_t n, const double *x, const double *y) {
  enum { LANES = 8 };
  double sum[LANES] = {0.0};
  size_t i = 0;
  for (; i + LANES <= n; i += LANES)
    for (size_t k = 0; k < LANES; ++k)
      sum[k] += x[i + k] * y[i + k];
  for (size_t k = 0; i < n; ++i, ++k)
    sum[k] += x[i] * y[i];
  return ((sum[0] + sum[4]) + (sum[2] + sum[6])) + ((sum[1] + sum[5]) + (sum[3] + sum[7]));
}

PO_FOR_ALL_WIDTHS void po_linear_add(size_t n, double factor, const double *x, double *y) {
  for (size_t i = 0; i < n; ++i)
    y[i] += factor * x[i];
}

void po_linear_solve_transposed(size_t n, const double *a, size_t stride, const int *pivots,
                                double *x) {
  for (size_t k = 0; k < n; ++k)
    x[k] = (x[k] - po_linear_dot(k, a + k * stride, x)) / a[k + k * stride];
  for (size_t k = n; k-- > 0;)
    x[k] -= po_linear_dot(n - k - 1, a + k + 1 + k * stride, x + k + 1);
  for (size_t k = n; k-- > 0;) {
    const double above = x[k];
    x[k] = x[pivots[k] - 1];
    x[pivots[k] - 1] = above;
  }
}

double po_linear_norm(size_t n, const double *a, size_t stride) {
  double largest = 0.0;
  for (size_t j = 0; j < n; ++j) {
    double sum = 0.0;
    for (size_t i = 0; i < n; ++i)
      sum += fabs(a[i + j * stride]);
    largest = sum > largest ? sum : largest;
  }
  return largest;
}

PO_FOR_ALL_WIDTHS void po_linear_apply(size_t rows, size_t columns, const double *a, size_t stride,
                                       const double *x, double *y) {
  memset(y, 0, rows * sizeof *y);
  size_t j = 0;
  for (; j + 4 <= columns; j += 4) {
    const double *c = a + j * stride, *d = c + stride, *e = d + stride, *f = e + stride;
    for (size_t i = 0; i < rows; ++i)
      y[i] = (((y[i] + c[i] * x[j]) + d[i] * x[j + 1]) + e[i] * x[j + 2]) + f[i] * x[j + 3];
  }
  for (; j < columns; ++j)
    for (size_t i = 0; i < rows; ++i)
      y[i] += a[i + j * stride] * x[j];
}

PO_FOR_ALL_WIDTHS void po_linear_apply_transposed(size_t rows, size_t columns, const double *a,
                                                  size_t stride, const double *x, double *y) {
  for (size_t j = 0; j < columns; ++j)
    y[j] = po_linear_dot(rows, a + j * stride, x);
}
