#include <math.h>

#include "po_continuation_parts.h"
#include "po_refine.h"

/* Distance from the last inner point, relative to the step, within which its tangent is the
 * prediction. */
static const double ON_TANGENT = 0.02;

/* Sets the guess to the tangent at the last inner point. */
static void guess_on_tangent(po_continuation *t, double at) {
  const double step = (at - t->inner_at) / po_solution_cosine(&t->current, &t->inner);
  po_corrector_guess_near(&t->c, &t->inner, step);
}

/* Whether the mesh of the last inner point resolves the solution at another place: if the contact
 * edges are narrow, they may not move by more than their width. */
static bool serves_inner_mesh(const po_continuation *t, double at) {
  if (!po_equilibrium_is_narrow(t->c.e))
    return true;
  const double way = fabs(at - t->inner_at) * t->c.e->coupling;
  for (size_t k = 0; k < t->inner.edges.count; ++k)
    if (!(way * fabs(t->inner.edges.rate[k]) < 1.0))
      return false;
  return true;
}

/* Solves for a point between t->current and t->next. */
static po_status solve_inner(void *data, double at, bool roughly, po_sample *sample) {
  po_continuation *t = data;
  const double whole = po_solution_progress(&t->current, &t->next);
  const double precision = roughly && po_continuation_moves(t)
                               ? po_continuation_tangent_precision(t, whole)
                               : t->c.e->precision;
  po_status status;
  if (fabs(at - t->inner_at) < ON_TANGENT * whole && serves_inner_mesh(t, at)) {
    guess_on_tangent(t, at);
    status = po_continuation_solve_guessed(t, at, precision, &t->inner);
  } else {
    po_prediction p;
    po_prediction_make(t->c.e->scene, t->c.domain, &t->current, &t->next, at, &p);
    status = po_continuation_solve(t, &p, at, true, precision, &t->inner, NULL);
  }
  t->inner_at = status ? (double)NAN : at;
  if (status)
    return status;
  t->inner.position = t->current.position + po_solution_way(&t->current, &t->inner);
  *sample = po_corrector_sample(&t->current, &t->inner);
  return PO_OK;
}

static void keep_inner(void *data, size_t place) {
  po_continuation *t = data;
  po_solution_copy(&t->inner, &t->at_event[place]);
}

po_status po_continuation_find_events(po_continuation *t) {
  t->inner_at = NAN; /* comparisons with it are false */
  const po_interval interval = {.data = t,
                                .solve = solve_inner,
                                .keep = keep_inner,
                                .precision = t->c.e->precision,
                                .station = t->options.station,
                                .end = t->options.end};
  const po_sample from = po_corrector_sample(&t->current, &t->current),
                  to = po_corrector_sample(&t->current, &t->next);
  return po_events_find(&interval, &from, &to, &t->events);
}

po_branch_point po_continuation_seen(const po_continuation *t, const po_solution *p,
                                     po_point_kind kind) {
  const double length = po_solution_length(p);
  return (po_branch_point){.kind = kind,
                           .position = p->position,
                           .approach = po_solution_approach(p),
                           .load = p->load,
                           .energy = p->energy,
                           .approach_error = NAN,
                           .load_error = NAN,
                           .approach_rate = p->tangent[p->n] / length,
                           .load_rate = p->load_rate / length,
                           .unstable_modes = t->unstable_modes,
                           .n = p->core,
                           .node = p->node,
                           .gap = p->state,
                           .solution = p->panels->count ? p : NULL};
}

void po_continuation_visit(po_continuation *t, const po_solution *p, po_point_kind kind) {
  const po_branch_point point = po_continuation_seen(t, p, kind);
  if (t->options.visit(&point, t->options.data))
    t->ended = true;
}

/* Whether the errors of a special point are estimated: on panels, for folds if the options require
 * it, and for a minimum of the load that is the deepest so far. */
static bool is_judged(const po_continuation *t, const po_branch_point *point) {
  if (!po_continuation_moves(t))
    return false;
  if (point->kind == PO_POINT_APPROACH_MAX || point->kind == PO_POINT_APPROACH_MIN)
    return !t->options.minima_only;
  return point->kind == PO_POINT_LOAD_MIN && point->load <= t->deepest;
}

/* Estimates the errors of a special point on finer meshes. They consist of the errors of the mesh,
 * of Newton's method, and of the place of the special point. */
static void judge(po_continuation *t, const po_event *ev, po_branch_point *point) {
  const double cosine = po_solution_cosine(&t->current, point->solution);
  const double enough =
      point->kind == PO_POINT_LOAD_MIN ? t->options.sharpness * fabs(point->load) : INFINITY;
  const po_refinement how = {ev->of, po_refine_slope(ev, cosine), enough, {&t->spare, &t->inner}};
  po_refined r = {.point = point->solution, .value = {point->approach, point->load}};
  const po_status status = po_refine(&t->c, &t->resolution, &how, &r);
  if (!status) {
    point->approach_correction = r.value[0] - point->approach;
    point->load_correction = r.value[1] - point->load;
    const double beyond =
        ev->left > PO_LOCATED ? ev->left * po_solution_length(point->solution) : 0.0;
    point->approach_error = r.error[0] + beyond * fabs(point->approach_rate);
    point->load_error = r.error[1] + beyond * fabs(point->load_rate);
    point->best = r.point;
    point->finer = r.finer;
  }
  point->unmet = status == PO_NOT_CONVERGED && !t->c.trouble;
  t->c.trouble = PO_OK; /* the trace continues if the mesh of the estimate has too many panels */
}

static void visit_special_point(po_continuation *t, const po_event *ev) {
  po_branch_point point = po_continuation_seen(t, &t->at_event[ev->place], po_event_point(ev));
  if (is_judged(t, &point))
    judge(t, ev, &point);
  if (point.kind == PO_POINT_LOAD_MIN)
    t->deepest = fmin(t->deepest, point.load);
  if (t->options.visit(&point, t->options.data))
    t->ended = true;
}

/* Whether an event is beyond the end of the forward trace. The last step of the forward trace and
 * the first of the reverse trace pass it. */
static bool is_beyond(po_continuation *t, const po_event *ev) {
  const bool beyond = t->back ? t->beyond > 0 : t->ended;
  if (beyond && ev->of <= PO_OF_LOAD)
    t->beyond += t->back ? -1 : 1;
  return beyond;
}

void po_continuation_visit_step(po_continuation *t) {
  for (size_t k = 0; k < t->events.count; ++k) {
    const po_event *ev = &t->events.list[k];
    const po_solution *p = &t->at_event[ev->place];
    const po_point_kind kind = po_event_point(ev);
    t->unstable_modes += po_change_of_modes(kind, p->load_rate);
    if (is_beyond(t, ev))
      continue;
    if (ev->of <= PO_OF_LOAD)
      visit_special_point(t, ev);
    else
      po_continuation_visit(t, p, kind);
    t->ended = t->ended || ev->of == PO_AT_END;
  }
  if (!t->ended)
    po_continuation_visit(t, &t->next, PO_POINT_STEP);
}
