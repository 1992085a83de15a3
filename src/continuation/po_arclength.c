#include "po_arclength.h"

#include <math.h>

/* Weight of the approach: along a curve it goes over several mu while the load goes over one or
 * two. */
static double approach_weight(const po_equilibrium *e) {
  return 1.0 / (2.0 + 2.0 * e->scene->tabor);
}

/* Contact is measured in radii at which the undeformed gap is eps. */
static double contact_weight(const po_equilibrium *e) {
  return 1.0 / sqrt(2.0 * e->radius);
}

/* Nodes of the core: the panel to infinity touches nothing. */
static size_t core_nodes(const po_equilibrium *e) {
  size_t n = e->n;
  while (n > 0 && e->surface->node[n - 1] > e->surface->core_radius)
    --n;
  return n;
}

void po_arclength_values(const po_equilibrium *e, const double *state,
                         double value[PO_ARCLENGTH_SIZE]) {
  double contact = 0.0;
  for (size_t j = core_nodes(e); j-- > 0;)
    contact += e->surface->length[j] / ((1.0 + state[j]) * (1.0 + state[j]));
  value[0] = approach_weight(e) * state[e->n];
  value[1] = po_equilibrium_load(e);
  value[2] = contact_weight(e) * contact;
}

void po_arclength_rates(const po_equilibrium *e, const double *state, const double *change,
                        double rate[PO_ARCLENGTH_SIZE]) {
  double contact = 0.0;
  for (size_t j = core_nodes(e); j-- > 0;) {
    const double h = 1.0 + state[j];
    contact -= 2.0 * e->surface->length[j] / (h * h * h) * change[j];
  }
  rate[0] = approach_weight(e) * change[e->n];
  rate[1] = po_equilibrium_load_rate(e, change);
  rate[2] = contact_weight(e) * contact;
}

double po_arclength_along(const double direction[PO_ARCLENGTH_SIZE],
                          const double value[PO_ARCLENGTH_SIZE]) {
  return direction[0] * value[0] + direction[1] * value[1] + direction[2] * value[2];
}

void po_arclength_border(const po_equilibrium *e, const double *state,
                         const double direction[PO_ARCLENGTH_SIZE], double *border) {
  const size_t core = core_nodes(e);
  for (size_t j = 0; j < e->n; ++j)
    border[j] = 2.0 / e->radius * direction[1] * e->surface->weight[j] * e->slope[j];
  for (size_t j = 0; j < core; ++j) {
    const double h = 1.0 + state[j];
    border[j] -= 2.0 * contact_weight(e) * direction[2] * e->surface->length[j] / (h * h * h);
  }
  border[e->n] = approach_weight(e) * direction[0];
}
