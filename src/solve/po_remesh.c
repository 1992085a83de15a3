/* Following the contact with the mesh: new panels for the point just reached and what lies ahead.
 */
#include <string.h>

#include "po_branch_internal.h"
#include "po_resolution.h"

static po_resolution resolution_of(const tracer *t, const double *state, const double *ahead) {
  return (po_resolution){.e = t->e,
                         .adaptive = t->options->adaptive,
                         .rule = &po_panel_table_get()->rule,
                         .legendre = &t->legendre,
                         .allowed = t->options->allowed_error,
                         .state = {state, ahead}};
}

double excess_of(const tracer *t, const branch_point *p) {
  const po_resolution r = resolution_of(t, p->state, NULL);
  return po_resolution_excess(&r);
}

/* Takes a point to the mesh in force. The deflection, not the gap, is what polynomials carry: the
 * shape is known exactly. old_shape: at the old_n nodes before. */
static void transfer_point(tracer *t, branch_point *p, size_t old_n, const double *old_shape) {
  const po_adaptive *a = t->options->adaptive;
  const double approach = p->state[old_n], rate = p->tangent[old_n];
  for (size_t j = 0; j < old_n; ++j)
    p->state[j] -= old_shape[j];
  po_adaptive_transfer(a, p->state, t->predicted);
  for (size_t j = 0; j < t->e->n; ++j)
    p->state[j] = t->predicted[j] + t->e->shape[j];
  p->state[t->e->n] = approach;
  po_adaptive_transfer(a, p->tangent, t->predicted);
  memcpy(p->tangent, t->predicted, t->e->n * sizeof *p->tangent);
  p->tangent[t->e->n] = rate;
}

/* Solves the current point on the mesh in force, at the same place of the branch. */
static po_status settle(tracer *t) {
  branch_point *p = &t->current;
  po_status status = PO_NOT_CONVERGED;
  memcpy(t->predicted, p->state, (t->e->n + 1) * sizeof *p->state);
  for (int attempt = 0; status && attempt < 2; ++attempt) {
    status = refactorize(t, p, p->state);
    if (!status)
      status = po_equilibrium_correct(t->e, p->state, t->predicted, 0.0);
    if (!status)
      status = po_equilibrium_tangent(t->e, p->tangent);
  }
  if (!status)
    finish_point(t, p);
  return status;
}

po_status remesh(tracer *t, const double *ahead, bool *changed) {
  const po_resolution r = resolution_of(t, t->current.state, ahead);
  po_leaves leaves;
  *changed = po_resolution_leaves(&r, &leaves);
  if (!*changed)
    return PO_OK;
  const size_t old_n = t->e->n;
  memcpy(t->old_shape, t->e->shape, old_n * sizeof *t->old_shape);
  po_status status = po_adaptive_mesh(t->options->adaptive, &leaves);
  if (status)
    return status;
  po_equilibrium_remesh(t->e);
  transfer_point(t, &t->current, old_n, t->old_shape);
  if (t->has_previous)
    transfer_point(t, &t->previous, old_n, t->old_shape);
  ++t->e->work.meshes;
  status = settle(t);
  return status ? po_fail(status, "the branch was lost in changing the mesh at approach %.6g",
                          point_approach(t, &t->current))
                : PO_OK;
}
