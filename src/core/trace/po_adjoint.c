#include "po_adjoint.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_diagnosis.h"
#include "po_initial_gap.h"
#include "po_memory.h"
#include "po_profile_table.h"

static double slope_at(const po_scene *scene, const po_surface *surface, size_t j, double gap) {
  return (j < surface->resolved
              ? po_law_at(&scene->law, gap)
              : po_law_averaged(&scene->law, gap, po_initial_gap_amplitude(scene)))
      .slope;
}

/* x at node j. */
static double adjoint_at(const po_scene *scene, const po_surface *surface, const po_solution *p,
                         size_t j) {
  return -2.0 / scene->radius * surface->weight[j] * slope_at(scene, surface, j, p->state[j]) *
         p->tangent[j] / p->tangent[p->n];
}

/* Whether a solution is on the mesh of the surface, and not at a fold. */
static bool has_adjoint(const po_surface *surface, const po_solution *p) {
  return surface->n == p->n && memcmp(surface->node, p->node, p->n * sizeof *p->node) == 0 &&
         p->tangent[p->n] != 0.0;
}

/* d ln(force) / d ln(parameter). Returned: whether it is known. */
static bool find_sensitivity(const po_scene *scene, const po_surface *surface, const po_solution *p,
                             po_sensitivity *made) {
  *made = (po_sensitivity){.residual = NAN, .rounding = NAN};
  if (!has_adjoint(surface, p))
    return false;
  for (size_t j = 0; j < p->n; ++j) {
    const double adjoint = adjoint_at(scene, surface, p, j);
    const po_sensitivity s = po_sensitivity_sources(scene, p->node[j], j < surface->resolved,
                                                    p->deflection[j] + p->state[p->n]);
    made->tabor += adjoint * s.tabor;
    made->amplitude += adjoint * s.amplitude;
    made->wavelength += adjoint * s.wavelength;
    made->radius += adjoint * s.radius;
  }
  made->radius -= p->load; /* the 1/R of Eq 17 */
  double *const parts[] = {&made->tabor, &made->amplitude, &made->wavelength, &made->radius};
  for (size_t k = 0; k < sizeof parts / sizeof *parts; ++k)
    *parts[k] /= p->load;
  return true;
}

/* Their sum with a change of the gap is the change of the load. */
typedef struct {
  po_gap_weight *list;
  size_t count, room;
} weights;

static po_status add_weight(weights *w, double r, double weight) {
  po_gap_weight *list = po_grow(w->list, w->count, &w->room, sizeof *list);
  if (!list)
    return PO_NO_MEMORY;
  w->list = list;
  list[w->count++] = (po_gap_weight){r, weight};
  return PO_OK;
}

static po_status weigh_elastic(const po_scene *scene, const po_surface *surface,
                               const po_solution *p, weights *w) {
  po_status status = PO_OK;
  for (size_t j = 0; j < p->n && !status; ++j)
    status = add_weight(w, p->node[j], adjoint_at(scene, surface, p, j));
  return status;
}

/* Midpoints of intervals over which the gap changes by at most this part of the length of the law,
 * which are at most this part of a wave and longer than the interval before by this part of it.
 * They end at a gap of so many such lengths, from which on the rest is less than 1e-6. */
static const double CHANGE = 0.03, PART_OF_WAVE = 0.0625, GROWTH = 0.25, FARTHEST = 1e3;

static po_status weigh_rigid(const po_scene *scene, double approach, weights *w) {
  const double far = FARTHEST * po_law_size(&scene->law, 0.0);
  const double wave = PART_OF_WAVE * po_initial_gap_detail(scene);
  po_status status = PO_OK;
  double r = 0.0, next = po_profile_next_joint(&scene->profile, 0.0);
  while (!status && po_initial_gap_beyond(scene, r) - approach < far) {
    const double gap = po_initial_gap(scene, r);
    const double most = CHANGE * po_law_size(&scene->law, gap - approach);
    double length = fmin(next, wave);
    while (fabs(po_initial_gap(scene, r + length) - gap) > most)
      length *= 0.5;
    next = (1.0 + GROWTH) * length;
    const double middle = r + 0.5 * length;
    const double slope = po_law_at(&scene->law, po_initial_gap(scene, middle) - approach).slope;
    status = add_weight(w, middle, 2.0 / scene->radius * slope * middle * length);
    r += length;
  }
  return status;
}

static po_status find_noise(const po_profile_table *table, const weights *w, po_result *o) {
  o->noise.change = po_allocate(2 * table->rows, sizeof *o->noise.change);
  return o->noise.change ? po_profile_table_noise(table, w->count, w->list, &o->noise.deviation,
                                                  o->noise.change)
                         : PO_NO_MEMORY;
}

/* Keeps the weights for the readings of a table without noise. */
static po_status keep_weights(const weights *w, po_result *o) {
  double *kept = o->interpolation.weights = po_allocate(2 * w->count, sizeof *kept);
  o->interpolation.weight_count = w->count;
  for (size_t i = 0; kept && i < w->count; ++i) {
    kept[2 * i] = w->list[i].r;
    kept[2 * i + 1] = w->list[i].weight;
  }
  return kept ? PO_OK : PO_NO_MEMORY;
}

static po_status weigh_table(const po_scene *scene, const po_surface *surface,
                             const po_branch_point *p, po_result *o) {
  const po_profile_table *table = scene->profile.table;
  free(o->noise.change);
  free(o->interpolation.weights);
  o->noise.change = o->interpolation.weights = NULL;
  if (!po_profile_is_table(&scene->profile) ||
      (p->solution ? !has_adjoint(surface, p->solution) : p->gap != NULL))
    return PO_OK;
  weights w = {0};
  po_status status = p->solution ? weigh_elastic(scene, surface, p->solution, &w)
                                 : weigh_rigid(scene, p->approach, &w);
  if (!status)
    status = table->smoothing.knots ? find_noise(table, &w, o) : keep_weights(&w, o);
  free(w.list);
  return status;
}

po_status po_adjoint_note(const po_scene *scene, const po_surface *surface,
                          const po_branch_point *p, po_result *o) {
  if (p->solution)
    o->pull_off.has_sensitivity =
        find_sensitivity(scene, surface, p->solution, &o->pull_off.sensitivity);
  return weigh_table(scene, surface, p, o);
}
