#include "po_factors.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_linear.h"
#include "po_memory.h"

bool po_factors_allocate(po_factors *f, size_t capacity) {
  *f = (po_factors){.right = po_allocate(capacity, sizeof *f->right),
                    .pivots = po_allocate(capacity, sizeof *f->pivots)};
  return f->right && f->pivots;
}

void po_factors_free(po_factors *f) {
  free(f->matrix);
  free(f->wide);
  free(f->right);
  free(f->pivots);
}

bool po_factors_begin(po_factors *f, size_t n) {
  f->n = n;
  f->is_double = f->in_double;
  if (f->is_double) {
    f->wide = po_reserve_matrix(f->wide, &f->wide_room, n, sizeof *f->wide);
    return f->wide;
  }
  f->matrix = po_reserve_matrix(f->matrix, &f->room, n, sizeof *f->matrix);
  return f->matrix;
}

void po_factors_put(po_factors *f, size_t column, const double *values) {
  if (f->is_double) {
    memcpy(f->wide + f->n * column, values, f->n * sizeof *values);
    return;
  }
  float *to = f->matrix + f->n * column;
  for (size_t i = 0; i < f->n; ++i)
    to[i] = (float)values[i];
}

po_status po_factors_compute(po_factors *f) {
  return f->is_double ? po_linear_factorize(f->n, f->wide, f->n, f->pivots)
                      : po_linear_factorize_single(f->n, f->matrix, f->n, f->pivots);
}

int po_factors_sign(const po_factors *f) {
  int sign = 1;
  for (size_t i = 0; i < f->n; ++i) { /* pivot indices start from 1 */
    const size_t diagonal = i + f->n * i;
    const bool negative = f->is_double ? f->wide[diagonal] < 0.0 : f->matrix[diagonal] < 0.0F;
    if ((f->pivots[i] != (int)i + 1) != negative)
      sign = -sign;
  }
  return sign;
}

void po_factors_solve(po_factors *f, double *x) {
  if (f->is_double) {
    po_linear_solve(f->n, f->wide, f->n, f->pivots, x);
    return;
  }
  double scale = 0.0; /* scaling prevents overflow and underflow in single precision */
  for (size_t i = 0; i < f->n; ++i)
    scale = fmax(scale, fabs(x[i]));
  if (scale == 0.0)
    return;
  for (size_t i = 0; i < f->n; ++i)
    f->right[i] = (float)(x[i] / scale);
  po_linear_solve_single(f->n, f->matrix, f->n, f->pivots, f->right);
  for (size_t i = 0; i < f->n; ++i)
    x[i] = scale * (double)f->right[i];
}
