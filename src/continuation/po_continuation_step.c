#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_continuation_parts.h"
#include "po_elementary.h"
#include "po_hermite.h"
#include "po_join.h"
#include "po_refine.h"

/* Error of the prediction, relative to 1 + H, that a step aims at, and the greatest that is
 * accepted. With a limit of 0.14 a step passed over the two folds of mu = 4 that are within 1e-4 of
 * approach -4.0232. */
static const double AIMED_ERROR = 0.01, GREATEST_ERROR = 0.05;

/* The greatest error for wavy scenes. With 0.05 a step passed over two extrema of the load, 0.026
 * eps apart at mu = 1, A = 0.4, lambda = 10, approach 26.6, where the contact edge passes a crest.
 */
static const double GREATEST_ERROR_OF_WAVES = 0.03;

/* First change of Newton's method, relative to the greatest error, at which an attempt is given up.
 */
static const double FAR_GUESS = 1.25;

/* Greatest growth of the factor of the error from one step to the next that is expected. */
static const double GREATEST_INCREASE = 4.0;

/* Greatest ratio of the lengths of successive steps. */
static const double GREATEST_GROWTH = 2.0;

/* Least cosine of the angle between the directions at both ends of a step. */
static const double LEAST_COSINE = 0.7;

/* The length of a step relative to the greatest for which the curve between its ends is
 * interpolated as accurately as required. */
static const double JOIN_MARGIN = 0.85;

/* If the sagitta of a step is below this multiple of largest_miss, the error of the cubic is not
 * computed: the rounding of the energies may exceed it. */
static const double STRAIGHT = 40.0;

/* One attempt at a step. */
typedef struct {
  double step; /* length of the attempt, at most the one given */
  double next; /* length of the next attempt, or of the next step */
  bool met;    /* an equilibrium was found */
} attempt;

static double greatest_error(const po_continuation *t) {
  return po_scene_is_simple(t->c.e->scene) ? GREATEST_ERROR : GREATEST_ERROR_OF_WAVES;
}

/* The length of a step with the aimed error, from the error of the step just made. The error of the
 * tangent goes as the square of the length; that of the cubic as the square of the length times the
 * distance from the previous point, times a factor that changes along the branch: where it grows,
 * it is expected to grow once more as it did in the last step. */
static double next_step(po_continuation *t, const po_prediction *p, double step, double error) {
  const double known = t->error_factor, ratio = sqrt(AIMED_ERROR / fmax(error, 1e-30));
  t->error_factor = NAN;
  if (!p->cubic)
    return step * fmin(ratio, GREATEST_GROWTH);
  const double before = fabs(po_solution_progress(&t->current, &t->previous));
  const double way = step * (step + before);
  t->error_factor = po_continuation_moves(t) ? error / (way * way) : (double)NAN;
  const double growth = isnan(known) ? 1.0 : t->error_factor / known;
  const double product = ratio * way / sqrt(fmax(1.0, fmin(growth, GREATEST_INCREASE)));
  const double longer = 0.5 * (sqrt(step * step + 4.0 * product) - step);
  return fmin(longer, GREATEST_GROWTH * step);
}

/* Distance of the curve from the cubic of the present step, from the error with which the cubic of
 * the last step foretells its end: both go as the fourth derivative. Unlike po_join_miss, it does
 * not depend on the energies, whose errors may compensate the distance. 0 for the first step. */
static double foretold_miss(const po_continuation *t) {
  if (!t->has_previous)
    return 0.0;
  const po_sample from = po_corrector_sample(&t->current, &t->current);
  const po_sample back = po_corrector_sample(&t->current, &t->previous);
  const po_sample to = po_corrector_sample(&t->current, &t->next);
  double off[2];
  for (int q = 0; q < 2; ++q)
    off[q] = to.value[q] - po_hermite_value(from.value[q], from.rate[q], back.value[q],
                                            back.rate[q], to.at, back.at);
  const double across =
      (off[0] * to.rate[1] - off[1] * to.rate[0]) / po_hypot(to.rate[0], to.rate[1]);
  const double of_step = 0.25 * to.at / (to.at - back.at);
  return fabs(across) * of_step * of_step;
}

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
    status = po_continuation_solve_guessed(t, at, true, precision, &t->inner);
  } else {
    po_prediction p;
    po_prediction_make(t->c.e, &t->current, &t->next, at, &p);
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

/* Finds the special points and stations between t->current and t->next. */
static po_status find_events(po_continuation *t) {
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

static po_branch_point seen(const po_continuation *t, const po_solution *p, po_point_kind kind) {
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
  const po_branch_point point = seen(t, p, kind);
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

/* The slope of po_refinement at an event. Given: cosine of the angle between the direction at the
 * event and the direction of the functional by which its samples are parametrised. */
/* By differences on the cubic of the interval. */
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
    point->best = r.point;
    point->finer = r.finer;
  }
  point->unmet = status == PO_NOT_CONVERGED && !t->c.trouble;
  t->c.trouble = PO_OK; /* the trace continues if the mesh of the estimate has too many panels */
}

/* The kind of the point of an event. */
static po_point_kind event_point(const po_event *ev) {
  if (ev->of > PO_OF_LOAD)
    return PO_POINT_STATION;
  const bool rising = ev->low.rate[ev->of] > 0.0;
  if (ev->of == PO_OF_APPROACH)
    return rising ? PO_POINT_APPROACH_MAX : PO_POINT_APPROACH_MIN;
  return rising ? PO_POINT_LOAD_MAX : PO_POINT_LOAD_MIN;
}

static void visit_special_point(po_continuation *t, const po_event *ev) {
  po_branch_point point = seen(t, &t->at_event[ev->place], event_point(ev));
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

/* The change of the number of unstable modes at given approach when the trace passes a point.
 * Given: the kind of the point, and the rate of the load along the branch at it. Returned: 1, -1 or
 * 0. Source: doc/method.md, "Stability". Accuracy: compared with the motion of perturbed equilibria
 * in tests/unit/test_relaxation.c. */
/* The mode that changes is stable on that side of a fold on which d(load)/d(approach) goes to minus
 * infinity: there the second derivative of the potential along the mode goes to zero from above. */
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

/* The factor by which the present step could be longer with the interpolation of the curve still as
 * accurate as required; below 1 the step is too long. */
static double joined_for(const po_continuation *t) {
  const po_continuation_options *o = &t->options;
  const po_branch_point from = seen(t, &t->current, PO_POINT_STEP);
  const po_branch_point to = seen(t, &t->next, PO_POINT_STEP);
  const double sagitta = po_join_sagitta(&from, &to);
  const double by_sagitta = sqrt(o->largest_sagitta / sagitta);
  if (!(sagitta > STRAIGHT * o->largest_miss))
    return by_sagitta;
  const double miss = fmax(po_join_miss(&from, &to), foretold_miss(t));
  return fmin(by_sagitta, sqrt(sqrt(o->largest_miss / miss)));
}

/* Replaces the border of the present factors, if any, by that of another point. */
static void corrector_aim(po_corrector *c, const po_solution *from) {
  if (!c->e->factorized)
    return;
  po_equilibrium_evaluate(c->e, from->state);
  po_arclength_border(from->arclength, c->e, from->state, from->rate, c->border);
  po_equilibrium_change_border(c->e, c->border);
}

/* One attempt to step from t->current to t->next. Given: the length of the step. Status: PO_OK if
 * the step is accepted. */
static po_status try_step(po_continuation *t, double step, attempt *a) {
  po_prediction p;
  if (!po_continuation_moves(t))
    corrector_aim(&t->c, &t->current);
  a->step = po_prediction_reach(t->c.e, &t->current, t->has_previous ? &t->previous : NULL, step,
                                AIMED_ERROR, &p);
  a->next = 0.5 * a->step;
  a->met = false;
  if (!(a->step > 0.0))
    return PO_NOT_CONVERGED;
  double error;
  if (po_continuation_moves(t)) /* the factors are new, so that the first change is the error */
    t->c.farthest = FAR_GUESS * greatest_error(t);
  po_status status =
      po_continuation_solve(t, &p, a->step, !po_continuation_moves(t),
                            po_continuation_tangent_precision(t, a->step), &t->next, &error);
  t->c.farthest = INFINITY;
  if (status)
    return status;
  a->met = true;
  t->next.position = t->current.position + po_solution_way(&t->current, &t->next);
  if (error > greatest_error(t) || po_solution_cosine(&t->current, &t->next) < LEAST_COSINE) {
    a->next = a->step * fmax(0.25, fmin(0.7, sqrt(sqrt(AIMED_ERROR / error))));
    return PO_NOT_CONVERGED;
  }
  const double joined = JOIN_MARGIN * joined_for(t);
  if (joined < JOIN_MARGIN) {
    a->next = a->step * fmax(0.25, joined);
    return PO_NOT_CONVERGED;
  }
  status = find_events(t);
  if (!status)
    status = po_corrector_want_mesh(&t->c, &t->next);
  if (!status)
    a->next = fmin(a->step * joined, next_step(t, &p, a->step, error));
  return status;
}

po_status po_continuation_advance(po_continuation *t) {
  bool missed = false, settled = false;
  for (;;) {
    if (t->step < PO_LOCATED)
      return po_fail(PO_STEP_TOO_SMALL,
                     "the continuation failed with the shortest step at approach %.6g, "
                     "load %.6g",
                     po_solution_approach(&t->current),
                     t->current.load * po_scene_load_unit(t->c.e->scene));
    attempt a;
    const po_status status = try_step(t, t->step, &a);
    t->step = a.next;
    if (!a.met)
      t->c.e->factorized = false; /* they are of a state too far from the branch */
    if (t->c.trouble)
      return t->c.trouble;
    if (!a.met && !settled)
      settled = po_continuation_settle(t, a.step);
    if (!status) {
      /* waves are alike: a length that failed here would fail at the next wave, too */
      if (missed && !po_scene_is_simple(t->c.e->scene))
        t->step = fmin(a.next, a.step);
      return PO_OK;
    }
    missed = missed || !a.met;
  }
}
