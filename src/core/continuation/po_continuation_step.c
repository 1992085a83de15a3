#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_continuation_internal.h"
#include "po_elementary.h"
#include "po_hermite.h"
#include "po_margins.h"

/* Error of the prediction, relative to 1 + H, that a step aims at, and the greatest that is
 * accepted. With a limit of 0.14 a step passed over the two folds of mu = 4 that are within 1e-4 of
 * approach -4.0232. */
static const double AIMED_ERROR = 0.01, GREATEST_ERROR = 0.05;

/* The greatest error for wavy scenes. With 0.05 a step passed over two extrema of the load, 0.026
 * eps apart at mu = 1, A = 0.4, lambda = 10, approach 26.6, where the contact edge passes a crest.
 */
static const double GREATEST_ERROR_OF_WAVES = PO_REFUSED * AIMED_ERROR;

/* First change of Newton's method, relative to the greatest error, at which an attempt is given up.
 */
static const double FAR_GUESS = 1.25;

/* Least cosine of the angle between the directions at both ends of a step. */
static const double LEAST_COSINE = 0.7;

/* If the sagitta of a step is below this multiple of largest_miss, the error of the cubic is not
 * computed: the rounding of the energies may exceed it. */
static const double STRAIGHT = 40.0;

/* -- One point -- */

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
  if (!on_panels(t) || (may_keep_mesh && mesh_serves(t, p))) {
    guess(t, p);
    return PO_OK;
  }
  po_panels *const panels = t->c.e->surface->draft;
  po_panels_uniform(panels, 1);
  if (!po_panels_refine(panels, INT_MAX, too_large, p))
    return t->c.trouble = po_resolution_fail(t->c.e->scene, panels);
  po_status status = PO_OK;
  if (!all_move(t, p))
    status = po_corrector_adapt(&t->c, &(po_gap_field){po_prediction_gap, p}, panels);
  if (!status)
    status = po_corrector_mesh(&t->c, panels);
  if (!status)
    guess(t, p);
  return status;
}

/* Solves for the equilibrium at a distance along the arclength functional from the current point,
 * from the guess of the corrector; repeated on a new mesh while the solution is not resolved.
 * Given: keep, whether the present factors are tried first; precision of the tangent. Status:
 * PO_NOT_CONVERGED, also if no mesh resolves the solution; PO_OUT_OF_NODES. */
static po_status solve_guessed(po_continuation *t, double distance, bool keep, double precision,
                               po_solution *out) {
  po_status status = PO_OK;
  for (int mesh = 0; mesh < PO_MOST_MESHES_A_POINT && !status; ++mesh) {
    status = po_corrector_solve(&t->c, &t->current, distance, keep, precision, out);
    if (status || po_corrector_is_resolved(&t->c, out))
      return status;
    status = po_corrector_follow_solved(&t->c, out, &t->spare);
  }
  return status ? status : PO_NOT_CONVERGED;
}

/* The same from the prediction. Given: keep, whether the current mesh and factors may be used.
 * Returned: error, that of the prediction, relative to 1 + H, unless NULL. */
static po_status solve_predicted(po_continuation *t, po_prediction *p, double distance, bool keep,
                                 double precision, po_solution *out, double *error) {
  po_status status = mesh_for(t, p, keep);
  if (status)
    return status;
  const size_t meshes = t->c.e->work.meshes;
  status = solve_guessed(t, distance, keep, precision, out);
  const bool same_nodes = t->c.e->work.meshes == meshes;
  if (!status && error)
    *error = po_prediction_error(&(po_gap_field){po_prediction_gap, p}, &t->c.e->scene->law,
                                 same_nodes ? t->c.guess : NULL, out);
  return status;
}

/* Error of the tangent with which the next step, if as long, predicts the place of a contact edge:
 * relative to the width of the edge, 1/coupling. With 1e-3 the smooth spheres of mu = 4000 and of
 * the law (4, 10) at 3000 are refused; up to mu = 300 the work is the same. */
static const double EDGE_ERROR = 1e-5;

/* Precision of the tangents in a step of this length. */
static double tangent_precision(const po_continuation *t, double step) {
  if (t->c.e->narrow) /* in coordinates that scale with the contact */
    return t->c.e->precision;
  double way = 0.0; /* of the contact edges in the step, in their widths */
  for (size_t k = 0; k < t->current.edges.count; ++k)
    way = fmax(way, step * fabs(t->current.edges.rate[k]) * t->c.e->coupling);
  return fmin(PO_STEP_TANGENT, EDGE_ERROR / way);
}

/* -- One step -- */

/* Why an attempt at a step was refused. */
typedef enum {
  UNSOLVED,  /* no equilibrium was found */
  FAR_OFF,   /* the prediction was off by more than the greatest error */
  TURNED,    /* the branch turned by too large an angle */
  BENT,      /* the curve between the ends is not interpolated as accurately as required */
  UNLOCATED, /* a special point between the ends was not located */
  REASONS
} refusal;
_Static_assert((int)REASONS == (int)PO_REFUSALS, "po_continuation counts them");

/* Attempts are counted since the last step longer than this. */
static const double LONG_STEP = 1e-3;

static const char *const REFUSALS[REASONS] = {
    [UNSOLVED] = "no equilibrium was found",
    [FAR_OFF] = "the prediction was too far off",
    [TURNED] = "the branch turned too far",
    [BENT] = "the curve between its ends was not accurate enough",
    [UNLOCATED] = "a special point was not located"};

/* One attempt at a step. */
typedef struct {
  double step;    /* length of the attempt, at most the one given */
  double next;    /* length of the next attempt, or of the next step */
  bool met;       /* an equilibrium was found */
  refusal reason; /* of an attempt that was refused */
} attempt;

static double greatest_error(const po_continuation *t) {
  return po_scene_is_simple(t->c.e->scene) ? GREATEST_ERROR : GREATEST_ERROR_OF_WAVES;
}

/* The length of a step with the aimed error, from the error of the step just made. The error of the
 * tangent goes as the square of the length; that of the cubic as the square of the length times the
 * distance from the previous point, times a factor that changes along the branch: where it grows,
 * it is expected to grow once more as it did in the last step, but to shorten the step by no more
 * than a step may grow. */
static double next_step(po_continuation *t, const po_prediction *p, double step, double error) {
  const double known = t->error_factor, ratio = sqrt(AIMED_ERROR / fmax(error, 1e-30));
  t->error_factor = NAN;
  if (!p->cubic)
    return step * fmin(ratio, PO_STEP_GROWTH);
  const double before = fabs(po_solution_progress(&t->current, &t->previous));
  const double way = step * (step + before);
  t->error_factor = on_panels(t) ? error / (way * way) : (double)NAN;
  const double growth = isnan(known) ? 1.0 : t->error_factor / known;
  const double product = ratio * way / fmax(1.0, fmin(sqrt(growth), PO_STEP_GROWTH));
  const double longer = 0.5 * (sqrt(step * step + 4.0 * product) - step);
  return fmin(longer, PO_STEP_GROWTH * step);
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
  if (!t->c.e->narrow)
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
  const double precision =
      roughly && on_panels(t) ? tangent_precision(t, whole) : t->c.e->precision;
  po_status status;
  if (fabs(at - t->inner_at) < ON_TANGENT * whole && serves_inner_mesh(t, at)) {
    guess_on_tangent(t, at);
    status = solve_guessed(t, at, true, precision, &t->inner);
  } else {
    po_prediction p;
    po_prediction_make(t->c.e, &t->current, &t->next, at, &p);
    status = solve_predicted(t, &p, at, true, precision, &t->inner, NULL);
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
                                .station_load = t->options.station_load,
                                .end = t->options.end};
  const po_sample from = po_corrector_sample(&t->current, &t->current),
                  to = po_corrector_sample(&t->current, &t->next);
  return po_events_find(&interval, &from, &to, &t->events);
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
  if (!on_panels(t))
    corrector_aim(&t->c, &t->current);
  a->step = po_prediction_reach(t->c.e, &t->current, t->has_previous ? &t->previous : NULL, step,
                                AIMED_ERROR, &p);
  a->next = 0.5 * a->step;
  a->met = false;
  a->reason = UNSOLVED;
  if (!(a->step > 0.0))
    return PO_NOT_CONVERGED;
  double error;
  if (on_panels(t)) /* the factors are new, so that the first change is the error */
    t->c.farthest = FAR_GUESS * greatest_error(t);
  po_status status = solve_predicted(t, &p, a->step, !on_panels(t), tangent_precision(t, a->step),
                                     &t->next, &error);
  t->c.farthest = INFINITY;
  if (status)
    return status;
  a->met = true;
  t->next.position = t->current.position + po_solution_way(&t->current, &t->next);
  const bool far_off = error > greatest_error(t);
  if (far_off || po_solution_cosine(&t->current, &t->next) < LEAST_COSINE) {
    a->reason = far_off ? FAR_OFF : TURNED;
    a->next = a->step * fmax(PO_STEP_CUT, fmin(0.7, sqrt(sqrt(AIMED_ERROR / error))));
    return PO_NOT_CONVERGED;
  }
  const double joined = PO_AIM * joined_for(t);
  if (joined < PO_AIM) {
    a->reason = BENT;
    a->next = a->step * fmax(PO_STEP_CUT, joined);
    return PO_NOT_CONVERGED;
  }
  a->reason = UNLOCATED;
  status = find_events(t);
  if (!status)
    status = po_corrector_want_mesh(&t->c, &t->next);
  if (!status)
    a->next = fmin(a->step * joined, next_step(t, &p, a->step, error));
  return status;
}

/* Fails with the reasons for which the last attempts were refused, the most frequent first. */
static po_status stuck(const po_continuation *t) {
  char why[300] = "";
  int left[REASONS], all = 0;
  for (int r = 0; r < REASONS; ++r)
    all += left[r] = t->refused[r];
  for (size_t length = 0;;) {
    int most = 0;
    for (int r = 1; r < REASONS; ++r)
      most = left[r] > left[most] ? r : most;
    if (left[most] == 0 || length >= sizeof why)
      break;
    length += (size_t)snprintf(why + length, sizeof why - length, "%s %s (%d of %d attempts)",
                               length ? "," : ":", REFUSALS[most], left[most], all);
    left[most] = 0;
  }
  return po_fail(PO_STEP_TOO_SMALL,
                 "the continuation failed with the shortest step at approach %.6g, load %.6g%s",
                 po_solution_approach(&t->current) * po_scene_length_unit(t->c.e->scene),
                 t->current.load * po_scene_load_unit(t->c.e->scene), why);
}

po_status po_continuation_advance(po_continuation *t) {
  for (;;) {
    if (t->step < PO_LOCATED)
      return stuck(t);
    attempt a;
    const po_status status = try_step(t, t->step, &a);
    t->step = a.next;
    if (!a.met)
      t->c.e->factorized = false; /* they are of a state too far from the branch */
    if (t->c.trouble)
      return t->c.trouble;
    if (!status && a.step > LONG_STEP)
      memset(t->refused, 0, sizeof t->refused);
    if (!status)
      return PO_OK;
    ++t->refused[a.reason];
  }
}
