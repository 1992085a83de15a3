#include <math.h>

#include "po_continuation_internal.h"
#include "po_hermite.h"
#include "po_refine.h"

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
  if (!on_panels(t))
    return false;
  if (point->kind == PO_POINT_APPROACH_MAX || point->kind == PO_POINT_APPROACH_MIN)
    return !t->options.minima_only;
  return point->kind == PO_POINT_LOAD_MIN && point->load <= t->deepest;
}

/* The slope of po_refinement at an event, by differences on the cubic of the interval. Given:
 * cosine of the angle between the direction at the event and the direction of the functional by
 * which its samples are parametrised. */
static double refine_slope(const po_event *ev, double cosine) {
  const po_sample *a = &ev->low, *b = &ev->high;
  const double h = b->at - a->at, x = ev->root - a->at, by = 0.01 * h;
  double rate[2];
  for (int k = 0; k < 2; ++k)
    rate[k] = po_hermite_rate(a->value[ev->of], a->rate[ev->of], b->value[ev->of], b->rate[ev->of],
                              x + (k ? by : -by), h);
  return (rate[1] - rate[0]) / (2.0 * by) * cosine * cosine;
}

/* Estimates the errors of a special point on finer meshes. They consist of the errors of the mesh,
 * of Newton's method, and of the place of the special point. */
static void judge(po_continuation *t, const po_event *ev, po_branch_point *point) {
  const double cosine = po_solution_cosine(&t->current, point->solution);
  const double enough =
      point->kind == PO_POINT_LOAD_MIN ? t->options.sharpness * fabs(point->load) : INFINITY;
  const po_refinement how = {ev->of, refine_slope(ev, cosine), enough, {&t->spare, &t->inner}};
  po_refined r = {.point = point->solution, .value = {point->approach, point->load}};
  const po_status status = po_refine(&t->c, &how, &r);
  if (!status) {
    point->approach_correction = r.value[0] - point->approach;
    point->load_correction = r.value[1] - point->load;
    const double beyond =
        ev->left > PO_LOCATED ? ev->left * po_solution_length(point->solution) : 0.0;
    point->approach_error = r.error[0] + beyond * fabs(point->approach_rate);
    point->load_error = r.error[1] + beyond * fabs(point->load_rate);
    point->turn = how.slope;
    point->best = r.point;
    point->finer = r.finer;
  }
  point->unmet = status == PO_NOT_CONVERGED && !t->c.trouble;
  t->c.trouble = PO_OK; /* the trace continues if the mesh of the estimate has too many panels */
}

/* The kind of the point of an event. */
static po_point_kind event_point(const po_event *ev) {
  if (ev->of > PO_OF_LOAD)
    return ev->of == PO_AT_STATION_LOAD ? PO_POINT_STATION_LOAD : PO_POINT_STATION;
  const bool rising = ev->low.rate[ev->of] > 0.0;
  if (ev->of == PO_OF_APPROACH)
    return rising ? PO_POINT_APPROACH_MAX : PO_POINT_APPROACH_MIN;
  return rising ? PO_POINT_LOAD_MAX : PO_POINT_LOAD_MIN;
}

static void visit_special_point(po_continuation *t, const po_event *ev) {
  po_branch_point point = po_continuation_seen(t, &t->at_event[ev->place], event_point(ev));
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

/* The change of the number of unstable modes at given approach when the trace passes a point. The
 * mode that changes is stable on that side of a fold on which d(load)/d(approach) goes to minus
 * infinity: there the second derivative of the potential along the mode goes to zero from above.
 * Given: the kind of the point, and the rate of the load along the branch at it. Returned: 1, -1 or
 * 0. Source: doc/method.md, "Stability". Accuracy: compared with the motion of perturbed equilibria
 * in tests/unit/test_relaxation.c. */
static int change_of_modes(po_point_kind kind, double load_rate) {
  if (kind == PO_POINT_APPROACH_MAX)
    return load_rate < 0.0 ? 1 : -1;
  if (kind == PO_POINT_APPROACH_MIN)
    return load_rate > 0.0 ? 1 : -1;
  return 0;
}

void po_continuation_visit_step(po_continuation *t) {
  for (size_t k = 0; k < t->events.count; ++k) {
    const po_event *ev = &t->events.list[k];
    const po_solution *p = &t->at_event[ev->place];
    const po_point_kind kind = event_point(ev);
    t->unstable_modes += change_of_modes(kind, p->load_rate);
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
