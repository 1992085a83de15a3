#include "po_corrector.h"

#include <stdlib.h>
#include <string.h>

#include "po_memory.h"

/* The factors are renewed so often while an iteration is so near a solution, in parts of 1 + H,
 * that Newton's converges. */
enum { MOST_RENEWALS = 2 };
static const double NEAR = 0.1;

/* Nodes that answer each other, at most. There may be many more of rigid waves: those cost but
 * their sums. */
enum { MOST_ACTIVE = 1920 };

po_status po_corrector_allocate(po_corrector *c, po_equilibrium *e, po_adaptive *adaptive) {
  *c = (po_corrector){
      .e = e, .adaptive = adaptive, .domain = po_adaptive_domain(adaptive), .direction = 1};
  e->most_active = MOST_ACTIVE;
  const size_t capacity = po_adaptive_capacity(adaptive);
  c->border = po_allocate(capacity + 1, sizeof *c->border);
  c->guess = po_allocate(capacity + 1, sizeof *c->guess);
  return c->border && c->guess ? PO_OK : PO_NO_MEMORY;
}

void po_corrector_free(po_corrector *c) {
  free(c->border);
  free(c->guess);
}

po_status po_corrector_mesh(po_corrector *c, const po_panels *panels) {
  if (po_panels_equal(panels, po_adaptive_panels(c->adaptive)))
    return PO_OK;
  c->trouble = po_adaptive_mesh(c->adaptive, panels);
  if (c->trouble)
    return c->trouble;
  po_equilibrium_remesh(c->e);
  ++c->e->work.meshes;
  return PO_OK;
}

size_t po_corrector_core_nodes(const po_corrector *c) {
  return po_adaptive_panels(c->adaptive)->count * PO_TABLE_ORDER;
}

void po_corrector_guess(po_corrector *c, const po_track_point *p) {
  const po_track_field field = {p, c->e->scene, c->domain};
  const size_t core = po_corrector_core_nodes(c), n = c->e->n;
  for (size_t j = 0; j < core; ++j)
    c->guess[j] = po_track_gap((void *)&field, c->e->surface->node[j]);
  for (size_t back = 0; back <= n - core; ++back) /* the panel to infinity and the approach stay */
    c->guess[n - back] = p->state[p->n - back];
}

/* How far along the arclength functional a state is. */
static double functional_progress(const po_equilibrium *e, const double *state, const void *data) {
  const po_track_point *from = data;
  double value[PO_ARCLENGTH_SIZE];
  po_arclength_values(e, state, value);
  for (int i = 0; i < PO_ARCLENGTH_SIZE; ++i)
    value[i] -= from->functional[i];
  return po_arclength_along(from->rate, value);
}

static po_status factorize_at(po_corrector *c, const po_track_point *from, const double *state) {
  po_equilibrium_evaluate(c->e, state);
  po_arclength_border(c->e, state, from->rate, c->border);
  const po_status status = po_equilibrium_factorize(c->e, state, c->border);
  if (status && status != PO_SINGULAR)
    c->trouble = status;
  return status;
}

/* The iteration from the state in out; where it contracts too slowly near a solution the factors
 * are renewed there, which costs less than a shorter step. */
static po_status correct(po_corrector *c, const po_track_point *from, double distance,
                         po_track_point *out) {
  const po_constraint constraint = {functional_progress, from, distance};
  po_status status = po_equilibrium_correct_to(c->e, out->state, &constraint);
  for (int k = 0; status && k < MOST_RENEWALS && c->e->last_change < NEAR; ++k) {
    if (factorize_at(c, from, out->state))
      return PO_NOT_CONVERGED;
    status = po_equilibrium_correct_to(c->e, out->state, &constraint);
  }
  return status;
}

po_status po_corrector_solve(po_corrector *c, const po_track_point *from, double distance,
                             bool keep_factors, double precision, po_track_point *out) {
  po_status status = PO_NOT_CONVERGED;
  for (int fresh = keep_factors && c->e->factorized ? 0 : 1; status && fresh < 2; ++fresh) {
    memcpy(out->state, c->guess, (c->e->n + 1) * sizeof *out->state);
    if (fresh && factorize_at(c, from, c->guess))
      return PO_NOT_CONVERGED;
    status = correct(c, from, distance, out);
    if (!status)
      status = po_equilibrium_tangent(c->e, precision, out->tangent);
  }
  if (status)
    return status;
  po_track_point_finish(out, c->e, c->adaptive);
  return c->e->orientation * c->direction > 0 ? PO_OK : PO_NOT_CONVERGED;
}
