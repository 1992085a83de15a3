#include "operations.h"

#include <stdbool.h>
#include <stdlib.h>

#include "po_skeleton.h"

enum { N = PO_TABLE_ORDER, K = PO_SKELETON_NODES };
static const double DOUBLE = sizeof(double);

/* The cells whose factors are not zero: panels; inner cells with one active half, and with two. */
typedef struct {
  double panels, single, both;
} active_cells;

static active_cells count_active(const po_equilibrium *e) {
  const size_t count = e->surface->hierarchy->cells;
  const po_cell *cell = e->surface->hierarchy->cell;
  bool *active = calloc(count, sizeof *active), *panel = calloc(count, sizeof *panel);
  active_cells found = {0};
  for (size_t k = 0; active && panel && k < e->active / N; ++k)
    if (e->index[k] < cell[0].end) /* that to infinity is not eliminated */
      panel[e->index[k]] = true;
  for (size_t c = count; active && panel && c-- > 0;) {
    if (cell[c].right == PO_NO_CELL) {
      active[c] = panel[cell[c].panel];
      found.panels += active[c];
      continue;
    }
    const bool left = active[c + 1], right = active[cell[c].right];
    active[c] = left || right;
    found.both += left && right;
    found.single += left != right;
  }
  free(active);
  free(panel);
  return found;
}

operations operations_of_product(const po_equilibrium *e) {
  const double n = (double)e->n;
  const po_hierarchy *h = e->surface->hierarchy;
  if (!h)
    return (operations){2.0 * n * n, DOUBLE * n * n};
  const double kernel = (double)h->kernel.count, product = (double)h->product.count;
  const double block = (double)N * N, inner = 0.5 * (double)(h->cells - 1);
  return (operations){(4.0 * kernel + 2.0 * product + 8.0 * inner) * block,
                      DOUBLE * (kernel + product) * block};
}

/* Products of matrices take 2 operations a coefficient of one and column of the other; the inverse
 * of a matrix of order n takes 2 n^3. */
operations operations_of_factors(const po_equilibrium *e) {
  const double m = (double)e->active + 1.0;
  if (!e->elimination)
    return (operations){2.0 / 3.0 * m * m * m,
                        (e->factors.is_double ? DOUBLE : sizeof(float)) * m * m};
  const active_cells a = count_active(e);
  const double k2 = (double)K * K, k3 = k2 * K, panel = 2.0 * N * (N * N + 2.0 * N * K + K * K);
  return (operations){a.panels * panel + (a.both * 22.0 + a.single * 8.0) * k3,
                      DOUBLE * (a.panels * (2.0 * N * N + 2.0 * N * K + k2) +
                                (a.both * 9.0 + a.single * 6.0) * k2)};
}

operations operations_of_solve(const po_equilibrium *e) {
  const double m = (double)e->active + 1.0;
  if (!e->elimination)
    return (operations){2.0 * m * m, (e->factors.is_double ? DOUBLE : sizeof(float)) * m * m};
  const active_cells a = count_active(e);
  const double k2 = (double)K * K, panel = N * N + 2.0 * N * K;
  return (operations){2.0 * (a.panels * panel + (a.both * 11.0 + a.single * 6.0) * k2),
                      DOUBLE * (a.panels * panel + (a.both * 8.0 + a.single * 5.0) * k2)};
}
