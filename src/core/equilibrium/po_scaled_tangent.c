#include "po_scaled_tangent.h"

#include <math.h>

#include "po_initial_gap.h"
#include "po_kernel.h"
#include "po_law.h"

/* Precision of DH, relative to its largest component, while c is known from the amount of contact
 * only. */
static const double FIRST_PRECISION = 1e-4;

/* The derivatives of what is at fixed gaps, by the logarithm of the scale of all radii. */
typedef struct {
  double load;                           /* W/(pi w R) */
  double rate[PO_ARCLENGTH_GLOBAL_SIZE]; /* coordinates of the arclength */
  double added; /* coupling * s p s at the end s of a cut surface: that of the ring that is added */
} scaling;

static scaling scaling_of(const po_equilibrium *e, const po_solution *p) {
  const po_law *law = &e->scene->law;
  const double end = e->surface->core_radius;
  const double gap = po_solution_value_at(&(po_solution_field){p, e->scene, 0}, end).gap;
  const double ring =
      isfinite(e->scene->outer_radius) ? po_law_at(law, gap).traction * end * end : 0.0;
  scaling s = {.load = 2.0 * p->load - 2.0 / e->radius * ring, .added = e->coupling * ring};
  po_arclength_rates_of_scale(e, p->coordinate, s.load, end, gap, s.rate);
  return s;
}

/* df/dr at a node. */
static double profile_slope(const po_equilibrium *e, size_t j) {
  const double r = e->surface->node[j];
  return j < e->surface->resolved ? po_initial_gap_slope(e->scene, r)
                                  : po_profile_slope(&e->scene->profile, e->radius, r);
}

/* The rate at which a contact edge moves, from the derivative DH in p->tangent, relative to nodes
 * that move with the scale. */
static double motion_of(const po_equilibrium *e, const po_solution *p, double edge) {
  const po_solution_value v = po_solution_value_at(&(po_solution_field){p, e->scene, 0}, edge);
  return -v.tangent / v.slope;
}

/* Solves for DH with c, into p->tangent. */
static po_status solve(po_equilibrium *e, const scaling *s, double along, double c,
                       double precision, po_solution *p) {
  const double approach = p->state[p->n];
  for (size_t i = 0; i < p->n; ++i) {
    const double r = p->node[i];
    const double ring = s->added != 0.0 ? s->added * po_kernel(r + e->surface->core_radius,
                                                               e->surface->core_radius - r)
                                        : 0.0;
    e->source[i] = c * (r * profile_slope(e, i) + p->deflection[i] + approach - ring);
  }
  e->source[p->n] = 1.0 - c * along;
  return po_equilibrium_solve(e, e->secant.scale, precision, p->tangent);
}

po_status po_scaled_tangent(po_equilibrium *e, const double *direction, double precision,
                            po_solution *p) {
  const scaling s = scaling_of(e, p);
  const double along = po_arclength_along(PO_ARCLENGTH_GLOBAL_SIZE, direction, s.rate);
  const double edge = p->edges.at[p->edges.count - 1];
  double c = 1.0 / along;
  po_status status = solve(e, &s, along, c, FIRST_PRECISION, p);
  if (status)
    return status;
  c += motion_of(e, p, edge) / edge;
  status = solve(e, &s, along, c, precision, p);
  if (status)
    return status;
  po_arclength_rates(p->arclength, e, p->state, p->tangent, p->rate);
  for (size_t i = 0; i < PO_ARCLENGTH_GLOBAL_SIZE; ++i)
    p->rate[i] += c * s.rate[i];
  p->load_rate = po_equilibrium_load_rate(e, p->tangent) + c * s.load;
  for (size_t k = 0; k < p->edges.count; ++k)
    p->edges.rate[k] = c * p->edges.at[k] + motion_of(e, p, p->edges.at[k]);
  for (size_t j = 0; j < p->n; ++j)
    p->tangent[j] -= c * p->node[j] * (profile_slope(e, j) + p->slope[j]);
  po_solution_scale_tangent(p);
  return PO_OK;
}
