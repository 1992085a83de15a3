#include <math.h>

#include "po_continuation_parts.h"
#include "po_join.h"

/* Error of the prediction, in parts of 1 + H, that a step aims at, and that it may have: with 0.14
 * a step went over the two folds of mu = 4 that lie within 1e-4 of approach -4.0232. */
static const double AIMED_ERROR = 0.01, GREATEST_ERROR = 0.05;
/* The same with waves: with 0.05 a step went over two extrema of the load, 0.026 eps apart at mu =
 * 1, A = 0.4, lambda = 10, approach 26.6, where the edge of the contact goes over a crest. */
static const double GREATEST_ERROR_OF_WAVES = 0.03;
/* Growth of a step at most. */
static const double GREATEST_GROWTH = 2.0;
/* Cosine below which the arclength functional turned too far in one step. */
static const double LEAST_COSINE = 0.7;
/* Steps are made so much shorter than what would just do for the curve between to be joined. */
static const double JOIN_MARGIN = 0.85;
/* A curve as straight as this many times what a cubic may miss is not looked at: the energies may
 * be rounded by more. */
static const double STRAIGHT = 40.0;

/* One attempt at a step. */
typedef struct {
  double step; /* tried, no longer than asked for */
  double next; /* to try then */
  bool met;    /* an equilibrium was found there */
} attempt;

/* The step whose prediction has the error aimed at, from that of one taken: it goes as the square
 * of the distance to the point it starts from, times that to the one before when a cubic. */
static double next_step(const po_continuation *t, const po_prediction *p, double step,
                        double error) {
  const double ratio = sqrt(AIMED_ERROR / fmax(error, 1e-30));
  if (!p->cubic)
    return step * fmin(ratio, GREATEST_GROWTH);
  const double before = fabs(po_solution_progress(&t->current, &t->previous));
  const double product = ratio * step * (step + before);
  const double longer = 0.5 * (sqrt(step * step + 4.0 * product) - step);
  return fmin(longer, GREATEST_GROWTH * step);
}

/* How many times as long as from current to next a step may be for the curve between to be joined
 * as asked: below 1 it is not. */
static double joined_for(const po_continuation *t) {
  const po_continuation_options *o = &t->options;
  const po_branch_point from = po_continuation_seen(t, &t->current, PO_POINT_STEP);
  const po_branch_point to = po_continuation_seen(t, &t->next, PO_POINT_STEP);
  const double sagitta = po_join_sagitta(&from, &to);
  const double by_sagitta = sqrt(o->largest_sagitta / sagitta);
  if (!(sagitta > STRAIGHT * o->largest_miss))
    return by_sagitta;
  return fmin(by_sagitta, pow(o->largest_miss / po_join_miss(&from, &to), 0.25));
}

/* Current to next. Given: the step asked for. Status: PO_OK when it is taken. */
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
  po_status status = po_continuation_solve(t, &p, a->step, !po_continuation_moves(t),
                                           PO_STEP_TANGENT, &t->next, &error);
  if (status)
    return status;
  a->met = true;
  t->next.position = t->current.position + po_solution_way(&t->current, &t->next);
  const bool wavy = po_scene_is_wavy(t->c.e->scene);
  if (error > (wavy ? GREATEST_ERROR_OF_WAVES : GREATEST_ERROR) ||
      po_solution_cosine(&t->current, &t->next) < LEAST_COSINE) {
    a->next = a->step * fmax(0.25, fmin(0.7, pow(AIMED_ERROR / error, 0.25)));
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
  bool missed = false;
  for (;;) {
    if (t->step < PO_LOCATED)
      return po_fail(PO_STEP_TOO_SMALL,
                     "the branch could not be followed with the shortest step past approach %.6g, "
                     "load %.6g",
                     po_solution_approach(&t->current), t->current.load);
    attempt a;
    const po_status status = try_step(t, t->step, &a);
    t->step = a.next;
    if (!a.met)
      t->c.e->factorized = false; /* those of a state too far from the branch */
    if (t->c.trouble)
      return t->c.trouble;
    if (!status) {
      /* waves in a row are alike: what was too long here is too long there */
      if (missed && po_scene_is_wavy(t->c.e->scene))
        t->step = fmin(a.next, a.step);
      return PO_OK;
    }
    missed = missed || !a.met;
  }
}
