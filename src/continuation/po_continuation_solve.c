#include <limits.h>
#include <math.h>

#include "po_continuation_parts.h"

bool po_continuation_moves(const po_continuation *t) {
  return po_surface_panels(t->c.e->surface) != NULL;
}

static bool too_large(void *prediction, po_panel panel) {
  return po_prediction_too_large(prediction, panel, 1.0);
}

static bool mesh_serves(const po_continuation *t, po_prediction *p) {
  const po_panels *panels = po_surface_panels(t->c.e->surface);
  for (size_t k = 0; k < panels->count; ++k)
    if (po_prediction_too_large(p, panels->panel[k], 2.0))
      return false;
  return true;
}

/* Sets the guess to the prediction, on the current mesh. */
static void guess(po_continuation *t, po_prediction *p) {
  po_prediction_state(p, t->c.e->surface, po_corrector_moving_nodes(&t->c), t->c.guess);
}

/* Whether panels that move with the coordinates follow all contact edges. */
static bool all_move(const po_continuation *t, const po_prediction *p) {
  return p->edges.count == t->current.edges.all;
}

/* Makes a mesh for the prediction the current one, and sets the guess on it. The current mesh is
 * kept if it is fixed, or if it may be kept and is fine enough; if it does not resolve the
 * solution, the point is solved again on another. */
static po_status mesh_for(po_continuation *t, po_prediction *p, bool may_keep_mesh) {
  if (!po_continuation_moves(t)) {
    guess(t, p);
    return PO_OK;
  }
  if (may_keep_mesh && mesh_serves(t, p)) {
    guess(t, p);
    return PO_OK;
  }
  po_panels *const panels = t->c.e->surface->draft;
  po_panels_uniform(panels, 1);
  if (!po_panels_refine(panels, INT_MAX, too_large, p))
    return t->c.trouble = po_resolution_fail(panels);
  po_status status = PO_OK;
  if (!all_move(t, p))
    status = po_corrector_adapt(&t->c, &(po_gap_field){po_prediction_gap, p}, panels);
  if (!status)
    status = po_corrector_mesh(&t->c, panels);
  if (!status)
    guess(t, p);
  return status;
}

po_status po_continuation_solve_guessed(po_continuation *t, double distance, bool keep,
                                        double precision, po_solution *out) {
  po_status status = PO_OK;
  for (int mesh = 0; mesh < PO_MOST_MESHES_A_POINT && !status; ++mesh) {
    status = po_corrector_solve(&t->c, &t->current, distance, keep, precision, out);
    if (status || po_corrector_is_resolved(&t->c, out))
      return status;
    status = po_corrector_follow_solved(&t->c, out, &t->spare);
  }
  return status ? status : PO_NOT_CONVERGED;
}

po_status po_continuation_solve(po_continuation *t, po_prediction *p, double distance, bool keep,
                                double precision, po_solution *out, double *error) {
  po_status status = mesh_for(t, p, keep);
  if (status)
    return status;
  const size_t meshes = t->c.e->work.meshes;
  status = po_continuation_solve_guessed(t, distance, keep, precision, out);
  const bool same_nodes = t->c.e->work.meshes == meshes;
  if (!status && error)
    *error = po_prediction_error(p, same_nodes ? t->c.guess : NULL, out);
  return status;
}

/* Error of the tangent with which the next step, if as long, predicts the place of a contact edge:
 * relative to the width of the edge, 1/coupling. With 1e-3 the smooth spheres of mu = 4000 and of
 * the law (4, 10) at 3000 are refused; up to mu = 300 the work is the same. */
static const double EDGE_ERROR = 1e-5;

/* The precision of the tangent in coordinates that scale with the contact: the rate of the approach
 * is then right to 1e-5 at a Tabor parameter of 10,000. */
static const double SCALED_TANGENT = 1e-9;

double po_continuation_tangent_precision(const po_continuation *t, double step) {
  if (po_equilibrium_is_narrow(t->c.e))
    return SCALED_TANGENT;
  double way = 0.0; /* of the contact edges in the step, in their widths */
  for (size_t k = 0; k < t->current.edges.count; ++k)
    way = fmax(way, step * fabs(t->current.edges.rate[k]) * t->c.e->coupling);
  return fmin(PO_STEP_TANGENT, EDGE_ERROR / way);
}

bool po_continuation_settle(po_continuation *t, double step) {
  if (!po_continuation_moves(t) || !(step > 0.0))
    return false;
  po_corrector_guess(&t->c, &t->current);
  const double place = po_corrector_place_of_guess(&t->c, &t->current);
  if (!(fabs(place) > step) ||
      po_corrector_solve(&t->c, &t->current, place, false,
                         po_continuation_tangent_precision(t, step), &t->next))
    return false;
  t->next.position = t->current.position;
  if (po_corrector_want_mesh(&t->c, &t->next))
    return false;
  po_solution_exchange(&t->current, &t->next);
  t->has_previous = false;
  t->error_factor = NAN;
  return true;
}
