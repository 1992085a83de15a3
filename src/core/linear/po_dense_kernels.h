/* The loops of po_dense.c for numbers of one type. The includer defines
 *   REAL       double or float
 *   ROWS       rows of a tile: 64 bytes
 *   NAME(x)    the name of a function x for this type */

typedef struct {
  void (*subtract)(size_t rows, size_t columns, size_t depth, const REAL *a, const REAL *b, REAL *c,
                   size_t stride);
  void (*forward)(size_t n, size_t columns, const REAL *l, REAL *b, size_t stride);
} NAME(vector_parts);

#define BYTES 16
#define COLUMNS 3
#define TARGET
#define SIZED(x) NAME(x##_16)
#include "po_dense_tiles.h"

#if PO_WIDE_VECTORS
#define BYTES 32
#define COLUMNS 6
#define TARGET __attribute__((target("avx2")))
#define SIZED(x) NAME(x##_32)
#include "po_dense_tiles.h"
#endif

/* Returned: the parts for the vectors that the processor has. */
static const NAME(vector_parts) * NAME(chosen)(void) {
#if PO_WIDE_VECTORS
  if (__builtin_cpu_supports("avx2"))
    return &NAME(parts_32);
#endif
  return &NAME(parts_16);
}

/* Factorises a panel of few columns. Returned: the pivots, from 0, and whether one is zero. Of
 * equal moduli the first is the pivot; NaN is none. */
PO_FOR_ALL_WIDTHS bool NAME(po_dense_panel)(size_t rows, size_t columns, REAL *a, size_t stride,
                                            int *pivots) {
  bool is_singular = false;
  for (size_t j = 0; j < columns; ++j) {
    REAL *column = a + j * stride, largest = -1;
    size_t pivot = j;
    for (size_t i = j; i < rows; ++i) {
      const REAL size = column[i] < 0 ? -column[i] : column[i];
      pivot = size > largest ? i : pivot;
      largest = size > largest ? size : largest;
    }
    pivots[j] = (int)pivot;
    if (largest == 0) {
      is_singular = true;
      continue;
    }
    for (size_t l = 0; l < columns && pivot != j; ++l) {
      const REAL above = a[j + l * stride];
      a[j + l * stride] = a[pivot + l * stride];
      a[pivot + l * stride] = above;
    }
    const REAL divisor = column[j];
    for (size_t i = j + 1; i < rows; ++i)
      column[i] /= divisor;
    for (size_t l = j + 1; l < columns; ++l) {
      REAL *other = a + l * stride;
      const REAL factor = other[j];
      for (size_t i = j + 1; i < rows; ++i)
        other[i] -= column[i] * factor;
    }
  }
  return is_singular;
}

/* The same for any order, by halves. */
static void NAME(forward)(size_t n, size_t columns, const REAL *l, REAL *b, size_t stride) {
  if (n <= PANEL) {
    NAME(chosen)()->forward(n, columns, l, b, stride);
    return;
  }
  const size_t half = half_of(n);
  NAME(forward)(half, columns, l, b, stride);
  NAME(chosen)()->subtract(n - half, columns, half, l + half, b, b + half, stride);
  NAME(forward)(n - half, columns, l + half + half * stride, b + half, stride);
}

static void NAME(exchange)(size_t columns, REAL *a, size_t stride, const int *pivots,
                           size_t count) {
  for (size_t j = 0; j < columns; ++j) {
    REAL *column = a + j * stride;
    for (size_t k = 0; k < count; ++k) {
      const REAL above = column[k];
      column[k] = column[pivots[k]];
      column[pivots[k]] = above;
    }
  }
}

/* Recursive by halves of the columns (S. Toledo, SIAM J. Matrix Anal. Appl. 18, 1065 (1997)).
 * Returned: the pivots, from 0. Status: as po_linear_factorize. */
static po_status NAME(factorize)(size_t rows, size_t columns, REAL *a, size_t stride, int *pivots) {
  if (columns <= PANEL)
    return NAME(po_dense_panel)(rows, columns, a, stride, pivots) ? PO_SINGULAR : PO_OK;
  const size_t half = half_of(columns), rest = columns - half;
  REAL *right = a + half * stride;
  po_status left = NAME(factorize)(rows, half, a, stride, pivots), status = PO_OK;
  if (left && left != PO_SINGULAR)
    return left;
  NAME(exchange)(rest, right, stride, pivots, half);
  for (size_t from = 0; from < rest && !status; from += AT_ONCE) {
    const size_t width = rest - from < AT_ONCE ? rest - from : AT_ONCE;
    REAL *part = right + from * stride;
    NAME(forward)(half, width, a, part, stride);
    NAME(chosen)()->subtract(rows - half, width, half, a + half, part, part + half, stride);
    status = columns < AT_ONCE ? PO_OK : po_deadline_check();
  }
  if (!status)
    status = NAME(factorize)(rows - half, rest, right + half, stride, pivots + half);
  if (status && status != PO_SINGULAR)
    return status;
  NAME(exchange)(half, a + half, stride, pivots + half, rest);
  for (size_t k = half; k < columns; ++k)
    pivots[k] += (int)half;
  return status ? status : left;
}

/* As `factorize`, but pivots are counted from 1, as LAPACK's are. */
po_status NAME(po_linear_factorize)(size_t n, REAL *a, size_t stride, int *pivots) {
  const po_status status = NAME(factorize)(n, n, a, stride, pivots);
  for (size_t k = 0; k < n; ++k)
    ++pivots[k];
  return status;
}

/* x = U^-1 L^-1 P x by columns. */
PO_FOR_ALL_WIDTHS void NAME(po_linear_solve)(size_t n, const REAL *a, size_t stride,
                                             const int *pivots, REAL *x) {
  for (size_t k = 0; k < n; ++k) {
    const REAL above = x[k];
    x[k] = x[pivots[k] - 1];
    x[pivots[k] - 1] = above;
  }
  for (size_t k = 0; k < n; ++k) {
    const REAL *column = a + k * stride, factor = x[k];
    for (size_t i = k + 1; i < n; ++i)
      x[i] -= column[i] * factor;
  }
  for (size_t k = n; k-- > 0;) {
    const REAL *column = a + k * stride, factor = x[k] /= column[k];
    for (size_t i = 0; i < k; ++i)
      x[i] -= column[i] * factor;
  }
}

#undef REAL
#undef ROWS
#undef NAME
