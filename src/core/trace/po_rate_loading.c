#include "po_rate_loading.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_continuation.h"
#include "po_corrector.h"
#include "po_deadline.h"
#include "po_memory.h"
#include "po_trace.h"

/* Distance of the approach from that of the preload that is rounding, relative to 1 + the latter.
 */
static const double AT_PRELOAD = 1e-9;

/* Keeps the states that loading at given approach visits, until the preload. */
static bool visit_loading(const po_branch_point *point, void *data) {
  po_relaxed_loading *l = data;
  l->status = po_deadline_check();
  if (l->status)
    return true;
  if (l->request->watch)
    l->request->watch(l->request->watcher, point->approach, point->load);
  l->most_nodes = l->surface->n > l->most_nodes ? l->surface->n : l->most_nodes;
  const bool first = l->reached->n == 0;
  if (!point->solution || (!first && !(point->approach > l->greatest)))
    return false;
  l->greatest = point->approach;
  *(point->load < l->load ? &l->low : &l->high) = (po_preload){point->approach, point->load};
  if (first)
    po_solution_copy(point->solution, l->first);
  po_solution_copy(point->solution, l->reached);
  const double end = l->preload.approach;
  l->met = point->load >= l->preload.load ||
           fabs(point->approach - end) < AT_PRELOAD * (1.0 + fabs(end));
  return l->met;
}

static double load_of(const po_equilibrium *e, const double *state, const void *data) {
  (void)state;
  (void)data;
  return po_equilibrium_load(e);
}

/* Parts into which the way to the load is divided at most, by halving. */
enum { MOST_PARTS = 256 };

/* Relative distance from the load of the preload that is rounding. */
static const double AT_LOAD = 1e-8;

/* Newton's method from a state of loading near the load of the preload to that load. */
static po_status go_to_load(po_equilibrium *e, const po_relaxed_loading *l) {
  po_solution *p = l->reached;
  const double from = p->load;
  po_status status = po_surface_mesh(e->surface, p->panels);
  if (status)
    return status;
  po_equilibrium_remesh(e);
  double *border = po_allocate(2 * (e->n + 1), sizeof *border), *state = border + e->n + 1;
  if (!border)
    return PO_NO_MEMORY;
  for (int parts = 1; parts <= MOST_PARTS; parts *= 2) {
    memcpy(state, p->state, (e->n + 1) * sizeof *state);
    for (int k = 1; k <= parts; ++k) {
      const double part = (double)k / parts;
      const po_constraint to = {load_of, NULL, from + part * (l->load - from), INFINITY};
      po_equilibrium_evaluate(e, state);
      for (size_t j = 0; j < e->n; ++j)
        border[j] = 2.0 / e->radius * e->surface->weight[j] * e->slope[j];
      border[e->n] = 0.0;
      status = po_corrector_factorize(e, state, border);
      if (!status)
        status = po_equilibrium_correct_to(e, state, &to);
      if (!status && fabs(po_equilibrium_load(e) - to.target) > AT_LOAD * (1.0 + fabs(to.target)))
        status = PO_NOT_CONVERGED;
      if (status)
        break;
    }
    if (status != PO_NOT_CONVERGED && status != PO_SINGULAR)
      break;
  }
  if (!status) {
    memcpy(p->state, state, (e->n + 1) * sizeof *state);
    po_solution_take_state(p, e);
  }
  free(border);
  if (status == PO_NOT_CONVERGED || status == PO_SINGULAR)
    return po_fail(
        PO_NOT_CONVERGED,
        "the load of the preload, %.6g, was not found from the state of load %.6g; expected "
        "the preload as an approach, %.6g or less",
        l->load * po_scene_load_unit(e->scene), from * po_scene_load_unit(e->scene), l->greatest);
  return status;
}

bool po_rate_is_loaded(const po_request *request) {
  return request->load_speed > 0.0;
}

/* Loads until the approach or the load of the preload is reached. */
static po_status load_once(const po_request *request, po_equilibrium *e, po_relaxed_loading *l) {
  po_continuation_options options = po_continuation_options_default();
  options.minima_only = true;
  options.end = l->preload.approach;
  options.begin =
      fmin(request->approach_start, po_rate_is_loaded(request) ? -PO_APART : (double)NAN);
  if (isfinite(l->preload.approach))
    options.begin = fmin(options.begin, l->preload.approach - 1.0);
  options.visit = visit_loading;
  options.data = l;
  po_continuation *trace = NULL;
  po_status status =
      po_continuation_create(e, po_trace_allowance(request->mesh.tolerance), &options, &trace);
  if (!status)
    status = po_continuation_run(trace);
  po_continuation_destroy(trace);
  if (!status)
    status = l->status;
  if (!status && !l->met)
    status = po_fail(PO_NOT_FOUND, "the preload was not reached: loading ended at approach %.6g",
                     l->greatest);
  return status;
}

/* Newton's method goes to the load of the preload from a state whose load differs by less than
 * NEAR_LOAD of 1 + that load: then no contact edge moves by more than its width. */
static const double NEAR_LOAD = 2e-4;
enum { MOST_LOADINGS = 12 };

/* An approach between the states below and beyond the load, nearer to the one that is nearer. */
static double next_approach(const po_relaxed_loading *l) {
  const double part = (l->load - l->low.load) / (l->high.load - l->low.load);
  return l->low.approach + fmin(fmax(part, 0.02), 0.98) * (l->high.approach - l->low.approach);
}

/* The last step of a trace may pass the load by much: it is then approached by traces that end at
 * an approach. */
po_status po_rate_load_relaxed(const po_request *request, po_equilibrium **e,
                               po_relaxed_loading *l) {
  const double near = NEAR_LOAD * (1.0 + fabs(l->load));
  po_status status = PO_OK;
  for (int k = 0; k < MOST_LOADINGS; ++k) {
    po_equilibrium_destroy(*e);
    *e = NULL;
    l->greatest = -INFINITY;
    l->reached->n = 0;
    l->met = false;
    status = po_equilibrium_create(&request->scene, l->surface, e);
    if (status)
      return status;
    (*e)->precision = po_trace_precision(request->mesh.tolerance);
    status = load_once(request, *e, l);
    if (status || isnan(l->load) || (k == 0 && l->reached->load < l->load))
      return status;
    if (fabs(l->reached->load - l->load) < near && !(status = go_to_load(*e, l)))
      return PO_OK;
    l->preload = (po_preload){next_approach(l), NAN};
  }
  return status ? status : go_to_load(*e, l);
}
