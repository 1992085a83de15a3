#include "po_equilibrium.h"

#include <math.h>
#include <stdlib.h>

#include "po_far_energy.h"
#include "po_initial_gap.h"
#include "po_law.h"
#include "po_linear.h"
#include "po_memory.h"
#include "po_scales.h"

/* The rounding error of the sums over the influence matrix is 1e-14; this is a margin of 20. */
const double PO_FINEST_PRECISION = 2e-13;

void po_equilibrium_rescale(po_equilibrium *e) {
  const po_scales scales = po_scene_scales(e->scene);
  e->load_weight = 1.0 / scales.load_factor;
  e->approach_scale = 2.0 + 2.0 * scales.stretch;
}

void po_equilibrium_remesh(po_equilibrium *e) {
  const po_surface *s = e->surface;
  e->radius = e->scene->radius;
  e->amplitude = po_initial_gap_amplitude(e->scene);
  e->coupling = po_scene_coupling(e->scene);
  e->energy_at_zero = po_scene_has_infinite_energy(e->scene);
  e->energy_apart = s->tail > 0 && po_far_energy_is_apart(e->scene);
  e->n = s->n;
  e->factorized = false;
  for (size_t j = 0; j < e->n; ++j) {
    const double r = s->node[j];
    e->initial_gap[j] =
        j < s->resolved ? po_initial_gap(e->scene, r) : po_initial_gap_mean(e->scene, r);
  }
}

po_status po_equilibrium_create(const po_scene *scene, po_surface *surface,
                                po_equilibrium **equilibrium) {
  const size_t capacity = surface->capacity;
  po_equilibrium *e = po_allocate(1, sizeof *e);
  *equilibrium = e;
  if (!e)
    return PO_NO_MEMORY;
  e->scene = scene;
  e->surface = surface;
  e->gain = e->share = 1.0;
  po_equilibrium_rescale(e);
  e->precision = PO_FINEST_PRECISION;
  e->together = surface->hierarchy ? PO_TABLE_ORDER : 1;
  double **const vectors[] = {&e->initial_gap, &e->traction, &e->slope,   &e->deflection,
                              &e->border,      &e->right,    &e->scratch, &e->measure,
                              &e->column,      &e->row,      &e->change,  &e->response,
                              &e->source};
  po_arena *const all = &e->arrays;
  for (size_t k = 0; k < sizeof vectors / sizeof *vectors; ++k)
    *vectors[k] = po_arena_reserve(all, capacity + 1, sizeof(double));
  e->weak = po_arena_reserve(all, PO_MOST_WEAK * (capacity + 1), sizeof *e->weak);
  e->weak_functional =
      po_arena_reserve(all, PO_MOST_WEAK * (capacity + 1), sizeof *e->weak_functional);
  e->krylov = po_arena_reserve(all, (PO_KRYLOV_DEPTH + 1) * (capacity + 1), sizeof *e->krylov);
  e->index = po_arena_reserve(all, capacity, sizeof *e->index);
  po_secant_allocate(&e->secant, capacity + 1, all);
  po_status status = PO_OK;
  if (surface->hierarchy) {
    status = po_elimination_create(surface->hierarchy, &e->elimination);
  } else {
    e->factors.right = po_arena_allocate(all, capacity + 1, sizeof *e->factors.right);
    e->factors.pivots = po_arena_allocate(all, capacity + 1, sizeof *e->factors.pivots);
  }
  if (status || all->ran_out) {
    po_equilibrium_destroy(e);
    *equilibrium = NULL;
    return PO_NO_MEMORY;
  }
  po_equilibrium_remesh(e);
  return PO_OK;
}

void po_equilibrium_destroy(po_equilibrium *e) {
  if (!e)
    return;
  po_arena_free(&e->arrays);
  free(e->factors.matrix);
  free(e->factors.wide);
  po_elimination_destroy(e->elimination);
  free(e);
}

size_t po_equilibrium_core(const po_equilibrium *e) {
  size_t n = e->n;
  while (n > 0 && e->surface->node[n - 1] > e->surface->core_radius)
    --n;
  return n;
}

void po_equilibrium_evaluate(po_equilibrium *e, const double *state) {
  const po_law *law = &e->scene->law;
  const size_t resolved = e->surface->resolved;
  for (size_t j = 0; j < e->n; ++j) {
    const po_law_value p =
        j < resolved ? po_law_at(law, state[j]) : po_law_averaged(law, state[j], e->amplitude);
    e->traction[j] = p.traction;
    e->slope[j] = p.slope;
  }
}

void po_equilibrium_deflect(const po_equilibrium *e, const double *traction, double *deflection) {
  po_surface_apply(e->surface, traction, deflection);
  for (size_t i = 0; i < e->n; ++i)
    deflection[i] *= e->coupling;
}

/* Eq 15: the residual at each node. */
void po_equilibrium_residual(po_equilibrium *e, const double *state, double *residual) {
  po_equilibrium_evaluate(e, state);
  po_equilibrium_deflect(e, e->traction, residual);
  for (size_t i = 0; i < e->n; ++i)
    residual[i] += e->initial_gap[i] - state[e->n] - state[i];
}

double po_equilibrium_load(const po_equilibrium *e) {
  return 2.0 / e->radius * po_linear_dot(e->n, e->surface->weight, e->traction);
}

/* The energy of the interaction at a node for a gap. */
static double energy_of_gap(const po_equilibrium *e, size_t j, double gap) {
  return j < e->surface->resolved ? po_law_energy(&e->scene->law, gap)
                                  : po_law_energy_averaged(&e->scene->law, gap, e->amplitude);
}

/* The energy of the interaction at a node that is not on a panel to infinity with an integral of
 * its own. */
static double interaction_at(const po_equilibrium *e, size_t j, double gap) {
  const bool relative = e->energy_at_zero && e->surface->node[j] > e->surface->core_radius;
  return energy_of_gap(e, j, gap) - (relative ? energy_of_gap(e, j, e->initial_gap[j]) : 0.0);
}

double po_equilibrium_energy(const po_equilibrium *e, const double *state) {
  const po_surface *s = e->surface;
  const size_t near = e->n - (e->energy_apart ? s->tail : 0);
  const double approach = state[e->n];
  double sum = 0.0;
  for (size_t j = 0; j < e->n; ++j) {
    const double interaction = j < near ? interaction_at(e, j, state[j]) : 0.0;
    const double deflection = state[j] + approach - e->initial_gap[j];
    sum += s->weight[j] * (interaction + 0.5 * e->traction[j] * deflection);
  }
  if (near < e->n)
    sum += po_far_energy(e->scene, s->tail_begin, s->tail, s->node + near, state + near, approach);
  return 2.0 / e->radius * sum;
}

double po_equilibrium_load_rate(const po_equilibrium *e, const double *change) {
  double sum = 0.0;
  for (size_t j = 0; j < e->n; ++j)
    sum += e->surface->weight[j] * e->slope[j] * change[j];
  return 2.0 / e->radius * sum;
}
