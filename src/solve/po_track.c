#include "po_track.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_join.h"
#include "po_landmark.h"
#include "po_memory.h"
#include "po_prediction.h"
#include "po_refine.h"
#include "po_resolution.h"
#include "po_shape.h"

enum { ORDER = PO_TABLE_ORDER, MOST_MESHES_A_POINT = 4 };

/* Error of the prediction, in parts of 1 + H, that a step aims at, and that it may have: with 0.14
 * a step went over the two folds of mu = 4 that lie within 1e-4 of approach -4.0232. */
static const double AIMED_ERROR = 0.01, GREATEST_ERROR = 0.05;
/* The same with waves: with 0.05 a step went over two extrema of the load, 0.026 eps apart at mu =
 * 1, A = 0.4, lambda = 10, approach 26.6, where the edge of the contact goes over a crest. */
static const double GREATEST_ERROR_OF_WAVES = 0.03;
/* Growth of a step at most. */
static const double GREATEST_GROWTH = 2.0;
/* A point this close to the one solved just before, in parts of the step, is on its tangent. */
static const double ON_TANGENT = 0.02;
/* Precision of the tangent at a step: it serves to predict the next, and to see what lies between.
 */
static const double STEP_TANGENT = 1e-6;
/* An event's place along the gauge. */
static const double LOCATED = 1e-9;
/* Cosine below which the gauge turned too far in one step. */
static const double LEAST_COSINE = 0.7;
/* Meshes are made for this part of the allowed error, and serve while it is not exceeded: the
 * fronts may move a little on them. */
static const double MESH_MARGIN = 0.2;
/* Steps are made so much shorter than what would just do for the curve between to be joined. */
static const double JOIN_MARGIN = 0.85;
/* A curve as straight as this many times what a cubic may miss is not looked at: the energies may
 * be rounded by more. */
static const double STRAIGHT = 40.0;
static const double FIRST_STEP = 0.05, SHORTEST_STEP = 1e-9;

struct po_tracker {
  po_corrector c;
  po_branch_options options;
  po_resolution resolution;
  po_legendre legendre;
  po_track_point previous, current, next, inner, spare, at_event[PO_MOST_EVENTS];
  po_events events;
  double step;
  double inner_at; /* of the point in inner, solved on the mesh in force; NAN: none */
  bool has_previous, station_met, ended;
  bool back;
  int beyond;      /* landmarks of the last step that lie beyond the end */
  double farthest; /* least gap where the branch began */
  int unstable_modes;
  double deepest; /* minimum of the load so far */
  size_t points;
};

static double approach_of(const po_track_point *p) {
  return p->state[p->n];
}

static bool predict(const po_tracker *t, const po_track_point *other, double distance,
                    po_prediction *p) {
  return po_prediction_make(t->c.e->scene, t->c.root, &t->current, other, distance, p);
}

static bool too_large(void *prediction, po_leaf leaf) {
  return po_prediction_too_large(prediction, leaf, 1.0);
}

static bool mesh_serves(const po_tracker *t, const po_prediction *p) {
  const po_leaves *leaves = po_adaptive_leaves(t->c.adaptive);
  for (size_t k = 0; k < leaves->count; ++k)
    if (po_prediction_too_large(p, leaves->leaf[k], 2.0))
      return false;
  return true;
}

/* The mesh that just resolves a point just solved. */
static po_status want_mesh(po_tracker *t, po_track_point *p) {
  po_track_field solved = {p, t->c.e->scene, t->c.root};
  const po_gap_field field = {po_track_gap, &solved};
  po_resolution margin = t->resolution;
  margin.allowed.gap *= MESH_MARGIN;
  margin.allowed.load *= MESH_MARGIN;
  p->wanted = p->leaves;
  t->c.trouble = po_resolution_leaves(&margin, &field, &p->wanted);
  return t->c.trouble;
}

/* Takes the point just solved to the mesh it wants, as a guess. */
static po_status guess_from_solved(po_tracker *t, const po_track_point *out) {
  po_track_point_copy(out, &t->spare);
  const po_status status = po_corrector_mesh(&t->c, &t->spare.wanted);
  if (!status)
    po_corrector_guess(&t->c, &t->spare);
  return status;
}

/* Meshes for the prediction, unless the mesh in force serves and may. */
static po_status mesh_for(po_tracker *t, po_prediction *p, bool may_keep_mesh) {
  if (may_keep_mesh && mesh_serves(t, p))
    return PO_OK;
  po_leaves leaves;
  if (!po_leaves_build(&leaves, too_large, p))
    return t->c.trouble =
               po_fail(PO_OUT_OF_NODES, "the traction needs more than %d panels", PO_MOST_LEAVES);
  return po_corrector_mesh(&t->c, &leaves);
}

/* Solves from the guess, and meshes again while the solution is not resolved. Status:
 * PO_NOT_CONVERGED also when no mesh resolves it. */
static po_status solve_resolved(po_tracker *t, double distance, bool keep_factors, double precision,
                                po_track_point *out) {
  po_status status = PO_OK;
  for (int mesh = 0; mesh < MOST_MESHES_A_POINT && !status; ++mesh) {
    status = po_corrector_solve(&t->c, &t->current, distance, keep_factors, precision, out);
    if (status || po_resolution_excess(&t->resolution, &out->leaves, out->state) <= 1.0)
      return status;
    status = want_mesh(t, out);
    if (!status)
      status = guess_from_solved(t, out);
  }
  return status ? status : PO_NOT_CONVERGED;
}

static po_branch_point seen_point(const po_tracker *t, const po_track_point *p,
                                  po_point_kind kind) {
  return (po_branch_point){.kind = kind,
                           .position = p->position,
                           .approach = approach_of(p),
                           .load = p->load,
                           .energy = p->energy,
                           .approach_error = NAN,
                           .load_error = NAN,
                           .approach_rate = p->tangent[p->n],
                           .load_rate = p->load_rate,
                           .unstable_modes = t->unstable_modes,
                           .n = p->leaves.count * ORDER,
                           .node = p->node,
                           .gap = p->state,
                           .track = p};
}

static void visit(po_tracker *t, const po_track_point *p, po_point_kind kind) {
  const po_branch_point point = seen_point(t, p, kind);
  if (t->options.visit(&point, t->options.data))
    t->ended = true;
}

/* Whether errors of a landmark are worth their price: of folds, and of a minimum of the load that
 * may be the pull-off. */
static bool is_judged(po_tracker *t, const po_branch_point *point) {
  if (point->kind == PO_POINT_APPROACH_MAX || point->kind == PO_POINT_APPROACH_MIN)
    return true;
  if (point->kind != PO_POINT_LOAD_MIN || point->load > t->deepest)
    return false;
  t->deepest = point->load;
  return true;
}

/* Visits a landmark with its errors: what a finer mesh changes, what Newton's iteration left, and
 * how far off its place it may be. */
static void visit_landmark(po_tracker *t, const po_event *ev) {
  const po_track_point *p = &t->at_event[ev->place];
  po_branch_point point = seen_point(t, p, po_event_point(ev));
  const double cosine = po_gauge_along(t->current.rate, p->rate);
  double change[2];
  if (is_judged(t, &point) &&
      po_refine(&t->c, &t->resolution, p, ev, cosine, &t->spare, change) == PO_OK) {
    point.approach_error =
        po_refine_error(&t->c, change[0], point.approach) + LOCATED * fabs(point.approach_rate);
    point.load_error =
        po_refine_error(&t->c, change[1], point.load) + LOCATED * fabs(point.load_rate);
  }
  t->c.trouble = PO_OK; /* a mesh too fine for the estimate is no trouble for the trace */
  if (t->options.visit(&point, t->options.data))
    t->ended = true;
}

/* The guess on the tangent of the inner point last solved. */
static void guess_on_tangent(po_tracker *t, double at) {
  const double step = (at - t->inner_at) / po_gauge_along(t->current.rate, t->inner.rate);
  for (size_t j = 0; j <= t->inner.n; ++j)
    t->c.guess[j] = t->inner.state[j] + step * t->inner.tangent[j];
}

/* A point between current and next. */
static po_status solve_inner(void *data, double at, po_sample *sample) {
  po_tracker *t = data;
  const double whole = po_track_progress(&t->current, &t->next);
  po_status status;
  if (fabs(at - t->inner_at) < ON_TANGENT * whole) {
    guess_on_tangent(t, at);
    status = solve_resolved(t, at, true, t->c.e->precision, &t->inner);
  } else {
    po_prediction p;
    predict(t, &t->next, at, &p);
    status = mesh_for(t, &p, true);
    if (!status) {
      po_prediction_state(&p, t->c.e->surface, po_corrector_core_nodes(&t->c), t->c.guess);
      status = solve_resolved(t, at, false, t->c.e->precision, &t->inner);
    }
  }
  t->inner_at = status ? (double)NAN : at;
  if (status)
    return status;
  t->inner.position = t->current.position + po_track_way(&t->current, &t->inner);
  *sample = po_track_sample(&t->current, &t->inner);
  return PO_OK;
}

static void keep_inner(void *data, size_t place) {
  po_tracker *t = data;
  po_track_point_copy(&t->inner, &t->at_event[place]);
}

static po_status find_events(po_tracker *t) {
  t->inner_at = NAN; /* comparisons with it are false */
  const po_interval interval = {.data = t,
                                .solve = solve_inner,
                                .keep = keep_inner,
                                .station = t->station_met ? (double)NAN : t->options.station,
                                .end = t->options.end,
                                .located = LOCATED};
  const po_sample from = po_track_sample(&t->current, &t->current),
                  to = po_track_sample(&t->current, &t->next);
  return po_events_find(&interval, &from, &to, &t->events);
}

/* The step whose prediction has the error aimed at, from that of one taken: it goes as the square
 * of the distance to the point it starts from, times that to the one before when a cubic. */
static double next_step(const po_tracker *t, const po_prediction *p, double step, double error) {
  const double ratio = sqrt(AIMED_ERROR / fmax(error, 1e-30));
  if (!p->cubic)
    return step * fmin(ratio, GREATEST_GROWTH);
  const double before = fabs(po_track_progress(&t->current, &t->previous));
  const double product = ratio * step * (step + before);
  const double longer = 0.5 * (sqrt(step * step + 4.0 * product) - step);
  return fmin(longer, GREATEST_GROWTH * step);
}

/* How many times as long as from current to next a step may be for the curve between to be joined
 * as asked: below 1 it is not. */
static double joined_for(const po_tracker *t) {
  const po_branch_options *o = &t->options;
  const po_branch_point from = seen_point(t, &t->current, PO_POINT_STEP);
  const po_branch_point to = seen_point(t, &t->next, PO_POINT_STEP);
  const double sagitta = po_join_sagitta(&from, &to);
  const double by_sagitta = sqrt(o->largest_sagitta / sagitta);
  if (!(sagitta > STRAIGHT * o->largest_miss))
    return by_sagitta;
  return fmin(by_sagitta, pow(o->largest_miss / po_join_miss(&from, &to), 0.25));
}

/* One attempt at a step: current to next. Returned: the step to take then; status says whether this
 * one is taken. */
static double try_step(po_tracker *t, double step, po_status *status) {
  po_prediction p;
  *status = PO_NOT_CONVERGED;
  if (!predict(t, t->has_previous ? &t->previous : NULL, step, &p))
    return 0.5 * step;
  *status = mesh_for(t, &p, false);
  if (*status)
    return 0.5 * step;
  po_prediction_state(&p, t->c.e->surface, po_corrector_core_nodes(&t->c), t->c.guess);
  const size_t meshes = t->c.e->work.meshes;
  *status = solve_resolved(t, step, false, STEP_TANGENT, &t->next);
  if (*status)
    return 0.5 * step;
  const bool same_nodes = t->c.e->work.meshes == meshes;
  const double error = po_prediction_error(&p, same_nodes ? t->c.guess : NULL, &t->next);
  t->next.position = t->current.position + po_track_way(&t->current, &t->next);
  const double joined = JOIN_MARGIN * joined_for(t);
  *status = PO_NOT_CONVERGED;
  const bool wavy = po_scene_is_wavy(t->c.e->scene);
  if (error > (wavy ? GREATEST_ERROR_OF_WAVES : GREATEST_ERROR) ||
      po_gauge_along(t->current.rate, t->next.rate) < LEAST_COSINE)
    return step * fmax(0.25, fmin(0.7, pow(AIMED_ERROR / error, 0.25)));
  if (joined < JOIN_MARGIN)
    return step * fmax(0.25, joined);
  *status = find_events(t);
  if (!*status)
    *status = want_mesh(t, &t->next);
  return *status ? 0.5 * step : fmin(step * joined, next_step(t, &p, step, error));
}

static po_status advance(po_tracker *t) {
  po_status status = PO_NOT_CONVERGED;
  while (status) {
    if (t->step < SHORTEST_STEP)
      return po_fail(PO_STEP_TOO_SMALL,
                     "the branch could not be followed with the shortest step past approach %.6g, "
                     "load %.6g",
                     approach_of(&t->current), t->current.load);
    t->step = try_step(t, t->step, &status);
    if (t->c.trouble)
      return t->c.trouble;
  }
  return PO_OK;
}

/* Whether an event lies beyond the end of the way out: passed in the step that ended it, and again
 * at the beginning of the way back. */
static bool is_beyond(po_tracker *t, const po_event *ev) {
  const bool beyond = t->back ? t->beyond > 0 : t->ended;
  if (beyond && ev->of <= PO_OF_LOAD)
    t->beyond += t->back ? -1 : 1;
  return beyond;
}

static void visit_step(po_tracker *t) {
  for (size_t k = 0; k < t->events.count; ++k) {
    const po_event *ev = &t->events.list[k];
    const po_track_point *p = &t->at_event[ev->place];
    const po_point_kind kind = po_event_point(ev);
    t->unstable_modes += po_change_of_modes(kind, p->load_rate);
    if (is_beyond(t, ev))
      continue;
    t->station_met = t->station_met || ev->of == PO_AT_STATION;
    if (ev->of <= PO_OF_LOAD)
      visit_landmark(t, ev);
    else
      visit(t, p, kind);
    t->ended = t->ended || ev->of == PO_AT_END;
  }
  if (!t->ended)
    visit(t, &t->next, PO_POINT_STEP);
}

static void shift(po_tracker *t) {
  const po_track_point oldest = t->previous;
  t->previous = t->current;
  t->current = t->next;
  t->next = oldest;
  t->has_previous = true;
}

typedef struct {
  const po_scene *scene;
  double approach;
} undeformed;

static double undeformed_gap(void *data, double r) {
  const undeformed *u = data;
  return po_shape(u->scene, r) - u->approach;
}

/* The first equilibrium: Newton at fixed approach from the undeformed gap. */
static po_status start(po_tracker *t) {
  po_equilibrium *e = t->c.e;
  undeformed u = {e->scene, fmin(po_branch_start(e), t->options.begin)}; /* begin may be NaN */
  const po_gap_field field = {undeformed_gap, &u};
  po_leaves leaves = *po_adaptive_leaves(t->c.adaptive);
  po_status status = po_resolution_leaves(&t->resolution, &field, &leaves);
  if (!status)
    status = po_corrector_mesh(&t->c, &leaves);
  if (status)
    return status;
  po_track_point *p = &t->current;
  for (size_t j = 0; j < e->n; ++j)
    t->c.guess[j] = p->state[j] = e->shape[j] - u.approach;
  t->c.guess[e->n] = p->state[e->n] = u.approach;
  memset(t->c.border, 0, (e->n + 1) * sizeof *t->c.border);
  t->c.border[e->n] = 1.0;
  status = po_equilibrium_factorize(e, p->state, t->c.border);
  if (!status)
    status = po_equilibrium_correct(e, p->state, t->c.guess, 0.0);
  if (!status)
    status = po_equilibrium_tangent(e, STEP_TANGENT, p->tangent);
  if (status)
    return po_fail(status, "no equilibrium found far out, at approach %g", u.approach);
  po_track_point_finish(p, e, t->c.adaptive);
  e->factorized = false; /* its border is not of the gauge */
  return want_mesh(t, p);
}

static double least_gap(const po_track_point *p) {
  double least = INFINITY;
  for (size_t j = 0; j < p->n; ++j)
    least = fmin(least, p->state[j]);
  return least;
}

/* On from the current point until the visitor ends it, or the branch is back where it began. */
static po_status go_on(po_tracker *t) {
  po_status status = PO_OK;
  visit(t, &t->current, PO_POINT_STEP);
  while (!status && !t->ended) {
    status = advance(t);
    const bool returned = !status && least_gap(&t->next) > t->farthest;
    if (returned && !t->back)
      status = po_fail(PO_NOT_CONVERGED, "the branch led back to where it began, at approach %.6g",
                       approach_of(&t->next));
    if (!status)
      visit_step(t);
    if (!status && ++t->points > t->options.most_points)
      status =
          po_fail(PO_TOO_MANY_POINTS, "more than %zu points, the last at approach %.6g, load %.6g",
                  t->options.most_points, approach_of(&t->next), t->next.load);
    t->ended = t->ended || returned;
    shift(t);
  }
  return status;
}

po_status po_track_onwards(po_tracker *t) {
  const po_status status = start(t);
  if (status)
    return status;
  t->farthest = least_gap(&t->current);
  return go_on(t);
}

/* The steps are found anew, and nothing is kept of the way so far but where it began. */
po_status po_track_back(po_tracker *t, po_branch_visit visit_back, void *data) {
  po_track_point_turn(&t->current);
  t->c.direction = -t->c.direction;
  t->c.e->factorized = false; /* its border leads the other way */
  t->c.trouble = PO_OK;
  t->options.visit = visit_back;
  t->options.data = data;
  t->options.station = t->options.end = NAN;
  t->step = FIRST_STEP;
  t->has_previous = t->ended = false;
  t->back = true;
  t->points = 0;
  return go_on(t);
}

static size_t points_of(po_tracker *t, po_track_point **points) {
  po_track_point *const own[] = {&t->previous, &t->current, &t->next, &t->inner, &t->spare};
  size_t count = 0;
  for (size_t k = 0; k < sizeof own / sizeof *own; ++k)
    points[count++] = own[k];
  for (size_t k = 0; k < PO_MOST_EVENTS; ++k)
    points[count++] = &t->at_event[k];
  return count;
}

enum { MOST_POINTS_KEPT = 5 + PO_MOST_EVENTS };

po_status po_track_create(po_equilibrium *equilibrium, po_adaptive *adaptive, po_allowance allowed,
                          const po_branch_options *options, po_tracker **tracker) {
  po_tracker *t = *tracker = po_allocate(1, sizeof *t);
  if (!t)
    return PO_NO_MEMORY;
  t->options = *options;
  t->step = FIRST_STEP;
  po_track_point *points[MOST_POINTS_KEPT];
  const size_t count = points_of(t, points), capacity = po_adaptive_capacity(adaptive);
  po_status status = po_corrector_allocate(&t->c, equilibrium, adaptive);
  for (size_t k = 0; k < count && !status; ++k)
    status = po_track_point_allocate(points[k], capacity);
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  po_legendre_fill(rule, &t->legendre);
  t->resolution = (po_resolution){equilibrium, rule, &t->legendre, t->c.root, allowed};
  if (!status)
    return PO_OK;
  po_track_destroy(t);
  *tracker = NULL;
  return status;
}

void po_track_destroy(po_tracker *t) {
  if (!t)
    return;
  po_track_point *points[MOST_POINTS_KEPT];
  const size_t count = points_of(t, points);
  for (size_t k = 0; k < count; ++k)
    po_track_point_free(points[k]);
  po_corrector_free(&t->c);
  free(t);
}
