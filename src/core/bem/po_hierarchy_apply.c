/* Products with the influence matrix in hierarchical form. */
#include <string.h>

#include "po_hierarchy.h"

enum { N = PO_TABLE_ORDER };

/* The field of the charges of all panels through the kernel. The charges of the panels are set; the
 * fields of the panels are returned. */
static void apply_kernel(po_hierarchy *h) {
  memset(h->field, 0, h->cells * N * sizeof *h->field);
  for (size_t c = h->cells; c-- > 0;) {
    const po_cell *cell = h->cell + c;
    if (po_cell_is_panel(cell))
      continue;
    double *charge = h->charge + c * N;
    memset(charge, 0, N * sizeof *charge);
    po_block_apply_transposed(N, N, h->from_parent[0], h->charge + (c + 1) * N, charge);
    po_block_apply_transposed(N, N, h->from_parent[1], h->charge + cell->right * N, charge);
  }
  for (size_t k = 0; k < h->kernel.count; ++k) {
    const po_interaction *i = h->kernel.pair + k;
    const size_t a = (size_t)i->target * N, b = (size_t)i->source * N;
    po_block_apply_both(i->block, h->charge + b, h->field + a, h->charge + a, h->field + b);
  }
  for (size_t c = 0; c < h->cells; ++c) {
    const po_cell *cell = h->cell + c;
    if (po_cell_is_panel(cell))
      continue;
    po_block_apply(h->from_parent[0], h->field + c * N, h->field + (c + 1) * N);
    po_block_apply(h->from_parent[1], h->field + c * N, h->field + cell->right * N);
  }
}

/* The weights belong to the tractions: they come before the kernel, in the transpose after it. */
static void apply(po_hierarchy *h, bool transposed, const double *x, double *y) {
  for (size_t k = 0; k < h->panels.count; ++k) {
    double *charge = h->charge + (size_t)h->cell_of_panel[k] * N;
    for (size_t j = k * N; j < (k + 1) * N; ++j)
      *charge++ = transposed ? x[j] : h->weight[j] * x[j];
  }
  apply_kernel(h);
  for (size_t k = 0; k < h->panels.count; ++k) {
    const double *field = h->field + (size_t)h->cell_of_panel[k] * N;
    for (size_t j = k * N; j < (k + 1) * N; ++j, ++field)
      y[j] = transposed ? h->weight[j] * *field : *field;
  }
  if (h->unbounded)
    memset(y + h->panels.count * N, 0, N * sizeof *y);
  for (size_t k = 0; k < h->product.count; ++k) {
    const po_interaction *i = h->product.pair + k;
    const size_t target = (size_t)i->target * N, source = (size_t)i->source * N;
    if (transposed)
      po_block_apply_transposed(N, N, i->block, x + target, y + source);
    else
      po_block_apply(i->block, x + source, y + target);
  }
}

void po_hierarchy_apply(po_hierarchy *h, const double *x, double *y) {
  apply(h, false, x, y);
}

void po_hierarchy_apply_transposed(po_hierarchy *h, const double *x, double *y) {
  apply(h, true, x, y);
}

/* The kernel decreases with the distance, so the largest coefficient is in the panel of the node or
 * in a neighbour. */
void po_hierarchy_reach(const po_hierarchy *h, double *reach) {
  memset(reach, 0, po_hierarchy_nodes(h) * sizeof *reach);
  for (size_t k = 0; k < h->product.count; ++k) {
    const po_interaction *pair = h->product.pair + k;
    const double *of_block = pair->block + PO_BLOCK_SIZE;
    double *of_source = reach + (size_t)pair->source * N;
    for (size_t j = 0; j < N; ++j)
      of_source[j] = of_block[j] > of_source[j] ? of_block[j] : of_source[j];
  }
}
