#include <math.h>

#include "po_continuation_parts.h"
#include "po_elementary.h"
#include "po_hermite.h"
#include "po_join.h"

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

/* The factor by which the present step could be longer with the interpolation of the curve still as
 * accurate as required; below 1 the step is too long. */
static double joined_for(const po_continuation *t) {
  const po_continuation_options *o = &t->options;
  const po_branch_point from = po_continuation_seen(t, &t->current, PO_POINT_STEP);
  const po_branch_point to = po_continuation_seen(t, &t->next, PO_POINT_STEP);
  const double sagitta = po_join_sagitta(&from, &to);
  const double by_sagitta = sqrt(o->largest_sagitta / sagitta);
  if (!(sagitta > STRAIGHT * o->largest_miss))
    return by_sagitta;
  const double miss = fmax(po_join_miss(&from, &to), foretold_miss(t));
  return fmin(by_sagitta, sqrt(sqrt(o->largest_miss / miss)));
}

/* One attempt to step from t->current to t->next. Given: the length of the step. Status: PO_OK if
 * the step is accepted. */
static po_status try_step(po_continuation *t, double step, attempt *a) {
  po_prediction p;
  if (!po_continuation_moves(t))
    po_corrector_aim(&t->c, &t->current);
  a->step = po_prediction_reach(t->c.e->scene, t->c.domain, &t->current,
                                t->has_previous ? &t->previous : NULL, step, AIMED_ERROR, &p);
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
  status = po_continuation_find_events(t);
  if (!status)
    status = po_continuation_want_mesh(t, &t->next);
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
