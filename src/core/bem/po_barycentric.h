/* Interpolation between the nodes of a panel by the second barycentric formula (J.-P. Berrut, L.N.
 * Trefethen, SIAM Rev. 46, 501 (2004)). */
#ifndef PO_BARYCENTRIC_H
#define PO_BARYCENTRIC_H

#include <math.h>

#include "po_panel_table.h"

/* Values that are processed together; a panel has a whole number of them. */
enum { PO_LANES = 4, PO_LANE_GROUPS = PO_TABLE_ORDER / PO_LANES };

typedef double po_lanes
    __attribute__((vector_size(PO_LANES * sizeof(double)), aligned(8), may_alias));

_Static_assert(PO_TABLE_ORDER % PO_LANES == 0, "");

/* The terms of the formula at a place on a panel: the weights of its nodes, and their sum. */
typedef struct {
  po_lanes weight[PO_LANE_GROUPS];
  double sum;
} po_barycentric;

static inline double po_lanes_sum(po_lanes v) {
  return (v[0] + v[1]) + (v[2] + v[3]);
}

/* Given: the place, 0 to 1 on the panel. */
static inline po_barycentric po_barycentric_at(double x) {
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  po_barycentric at;
  po_lanes all = {0.0};
  for (size_t j = 0; j < PO_LANE_GROUPS; ++j) {
    at.weight[j] =
        ((const po_lanes *)rule->barycentric)[j] / (x - ((const po_lanes *)rule->node)[j]);
    all += at.weight[j];
  }
  at.sum = po_lanes_sum(all);
  if (isfinite(at.sum))
    return at;
  at.sum = 1.0; /* at a node */
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j)
    at.weight[j / PO_LANES][j % PO_LANES] = x == rule->node[j] ? 1.0 : 0.0;
  return at;
}

/* Interpolates from the values at the nodes of a panel. */
static inline double po_barycentric_value(const po_barycentric *at, const double *value) {
  po_lanes sum = {0.0};
  for (size_t j = 0; j < PO_LANE_GROUPS; ++j)
    sum += at->weight[j] * ((const po_lanes *)value)[j];
  return po_lanes_sum(sum) / at->sum;
}

#endif
