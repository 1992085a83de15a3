#include "po_track.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_hermite.h"
#include "po_landmark.h"
#include "po_memory.h"
#include "po_resolution.h"
#include "po_shape.h"
#include "po_track_point.h"

enum { ORDER = PO_TABLE_ORDER, MOST_MESHES_A_POINT = 4 };

/* Error of the prediction, in parts of 1 + H, that a step aims at, and that it may have. */
static const double AIMED_ERROR = 0.05, GREATEST_ERROR = 0.4;
/* Cosine below which the gauge turned too far in one step. */
static const double LEAST_COSINE = 0.7;
/* Cosine of gauge and its direction at the start of an interval below which a cubic is no use. */
static const double CUBIC_COSINE = 0.3;
/* Shift of a front in one step, in parts of the distance to its neighbour. */
static const double GREATEST_STRAIN = 0.08;
/* Meshes are made for this part of the allowed error, and serve while it is not exceeded: the
 * fronts may move a little on them. */
static const double MESH_MARGIN = 0.2;
static const double FIRST_STEP = 0.05, SHORTEST_STEP = 1e-9;
/* Gaps of a prediction are taken as no smaller. */
static const double CLOSEST = -0.9;

typedef struct {
  po_equilibrium *e;
  po_adaptive *adaptive;
  const po_branch_options *options;
  po_resolution resolution;
  po_legendre legendre;
  double root;
  po_track_point previous, current, next, inner, spare, at_event[PO_MOST_EVENTS];
  po_events events;
  double *border, *guess; /* capacity + 1 */
  double step;
  bool has_previous, station_met, ended;
  int unstable_modes;
  size_t points;
  po_status trouble; /* what ends the trace at once */
} tracker;

static double along(const double direction[PO_GAUGE_SIZE], const double vector[PO_GAUGE_SIZE]) {
  return direction[0] * vector[0] + direction[1] * vector[1] + direction[2] * vector[2];
}

static double progress_between(const po_track_point *from, const po_track_point *to) {
  double change[PO_GAUGE_SIZE];
  for (int i = 0; i < PO_GAUGE_SIZE; ++i)
    change[i] = to->gauge[i] - from->gauge[i];
  return along(from->rate, change);
}

static double approach_of(const po_track_point *p) {
  return p->state[p->n];
}

/* A state expected at a distance along the gauge from point a, by the cubic through a and b in
 * coordinates that move with the fronts of a; by the tangent of a alone where b does not serve. */
typedef struct {
  const tracker *t;
  const po_track_point *a, *b;
  bool cubic;
  double rate_b; /* of the gauge along a's direction, at b */
  po_hermite w;
  double shift[PO_MOST_FRONTS]; /* of a's fronts to where they are expected */
  double back[PO_MOST_FRONTS];  /* of a's fronts to those of b */
} prediction;

/* Whether the prediction is any use: fronts that do not run into each other. */
static bool predict(const tracker *t, const po_track_point *b, double distance, prediction *p) {
  const po_track_point *a = &t->current;
  *p = (prediction){.t = t, .a = a, .b = b, .w = {1.0, distance, 0.0, 0.0}};
  const po_fronts *fronts = &a->fronts;
  if (b && b->fronts.count == fronts->count) {
    const double whole = progress_between(a, b);
    p->rate_b = along(a->rate, b->rate);
    for (size_t f = 0; f < fronts->count; ++f)
      p->back[f] = b->fronts.at[f] - fronts->at[f];
    p->cubic = p->rate_b > CUBIC_COSINE && fabs(whole) > 0.0 &&
               po_front_strain(fronts, p->back) < 2.0 * GREATEST_STRAIN;
    if (p->cubic)
      p->w = po_hermite_at(distance, whole);
  }
  for (size_t f = 0; f < fronts->count; ++f) {
    p->shift[f] = p->w.d0 * fronts->rate[f];
    if (p->cubic)
      p->shift[f] += p->w.f1 * p->back[f] + p->w.d1 * b->fronts.rate[f] / p->rate_b;
  }
  return po_front_strain(fronts, p->shift) < GREATEST_STRAIN;
}

static double predicted_gap(void *data, double r) {
  const prediction *p = data;
  const po_fronts *fronts = &p->a->fronts;
  const po_scene *scene = p->t->e->scene;
  const double origin = po_front_origin(fronts, p->shift, r);
  const po_track_value a = po_track_value_at(p->a, scene, p->t->root, origin);
  const double velocity = po_front_displacement(fronts, fronts->rate, origin);
  double gap = a.gap + p->w.d0 * (a.tangent + a.slope * velocity);
  if (p->cubic) {
    const double at = origin + po_front_displacement(fronts, p->back, origin);
    const po_track_value b = po_track_value_at(p->b, scene, p->t->root, at);
    const double velocity_b = po_front_displacement(fronts, p->b->fronts.rate, origin);
    gap += p->w.f1 * (b.gap - a.gap) + p->w.d1 * (b.tangent + b.slope * velocity_b) / p->rate_b;
  }
  return fmax(gap, CLOSEST);
}

/* Component k of state and tangent at a node that no mesh moves: the panel to infinity, the
 * approach. */
static double predicted_component(const prediction *p, size_t of_a, size_t of_b) {
  double value = p->a->state[of_a] + p->w.d0 * p->a->tangent[of_a];
  if (p->cubic)
    value += p->w.f1 * (p->b->state[of_b] - p->a->state[of_a]) +
             p->w.d1 * p->b->tangent[of_b] / p->rate_b;
  return value;
}

/* The prediction at the nodes of the mesh in force. */
static void fill_guess(tracker *t, prediction *p) {
  const size_t core = po_adaptive_leaves(t->adaptive)->count * ORDER, n = t->e->n;
  for (size_t j = 0; j < core; ++j)
    t->guess[j] = predicted_gap(p, t->e->surface->node[j]);
  for (size_t back = 0; back <= n - core; ++back) /* from the approach inwards */
    t->guess[n - back] = predicted_component(p, p->a->n - back, p->cubic ? p->b->n - back : 0);
}

static po_status put_in_force(tracker *t, const po_leaves *leaves) {
  const po_status status = po_adaptive_mesh(t->adaptive, leaves);
  if (status) {
    t->trouble = status;
    return status;
  }
  po_equilibrium_remesh(t->e);
  ++t->e->work.meshes;
  return PO_OK;
}

/* How far along the gauge a state is. */
static double gauge_progress(const po_equilibrium *e, const double *state, const void *data) {
  const po_track_point *from = data;
  double value[PO_GAUGE_SIZE];
  po_gauge_values(e, state, value);
  for (int i = 0; i < PO_GAUGE_SIZE; ++i)
    value[i] -= from->gauge[i];
  return along(from->rate, value);
}

/* The equilibrium from the guess, on the mesh in force. */
static po_status solve_guess(tracker *t, double distance, po_track_point *out) {
  const po_constraint constraint = {gauge_progress, &t->current, distance};
  const size_t n = t->e->n;
  po_status status = PO_NOT_CONVERGED;
  for (int fresh = t->e->factorized ? 0 : 1; status && fresh < 2; ++fresh) {
    memcpy(out->state, t->guess, (n + 1) * sizeof *out->state);
    if (fresh) {
      po_equilibrium_evaluate(t->e, t->guess);
      po_gauge_border(t->e, t->guess, t->current.rate, t->border);
      if (po_equilibrium_factorize(t->e, t->guess, t->border))
        return PO_NOT_CONVERGED;
    }
    status = po_equilibrium_correct_to(t->e, out->state, &constraint);
    if (!status)
      status = po_equilibrium_tangent(t->e, out->tangent);
  }
  if (status)
    return status;
  po_track_point_finish(out, t->e, t->adaptive);
  return t->e->orientation > 0 ? PO_OK : PO_NOT_CONVERGED;
}

static double size_of(po_leaf leaf) {
  return po_leaf_end(leaf) - po_leaf_begin(leaf);
}

/* Size of the panels that the point a wants at the place from which a radius (in parts of the root)
 * is expected to come. */
static double wanted_size(const prediction *p, double x) {
  const double root = p->t->root;
  const double origin = po_front_origin(&p->a->fronts, p->shift, x * root) / root;
  const po_leaves *wanted = &p->a->wanted;
  return size_of(wanted->leaf[po_leaves_find(wanted, origin)]);
}

/* Whether a leaf is more than `times` larger than the panels wanted where it lies. */
static bool is_larger(const prediction *p, po_leaf leaf, double times) {
  enum { SAMPLES = 5 };
  const double begin = po_leaf_begin(leaf), size = size_of(leaf);
  for (int k = 0; k < SAMPLES; ++k)
    if (size > 1.001 * times * wanted_size(p, begin + size * (k + 0.5) / SAMPLES))
      return true;
  return false;
}

static bool too_large(void *data, po_leaf leaf) {
  return is_larger(data, leaf, 1.0);
}

static bool mesh_serves(const tracker *t, const prediction *p) {
  const po_leaves *leaves = po_adaptive_leaves(t->adaptive);
  for (size_t k = 0; k < leaves->count; ++k)
    if (is_larger(p, leaves->leaf[k], 2.0))
      return false;
  return true;
}

/* Gap of a point just solved, as a field to be meshed for. */
typedef struct {
  const tracker *t;
  const po_track_point *p;
} solved;

static double solved_gap(void *data, double r) {
  const solved *s = data;
  return po_track_value_at(s->p, s->t->e->scene, s->t->root, r).gap;
}

/* The mesh that just resolves a point just solved. */
static po_status want_mesh(tracker *t, po_track_point *p) {
  solved s = {t, p};
  const po_gap_field field = {solved_gap, &s};
  po_resolution margin = t->resolution;
  margin.allowed *= MESH_MARGIN;
  p->wanted = p->leaves;
  t->trouble = po_resolution_leaves(&margin, &field, &p->wanted);
  return t->trouble;
}

/* Takes the point just solved to the mesh it wants, as a guess. */
static po_status guess_from_solved(tracker *t, const po_track_point *out) {
  po_track_point_copy(out, &t->spare);
  solved s = {t, &t->spare};
  if (put_in_force(t, &t->spare.wanted))
    return t->trouble;
  const size_t core = t->spare.wanted.count * ORDER, n = t->e->n;
  for (size_t j = 0; j < core; ++j)
    t->guess[j] = solved_gap(&s, t->e->surface->node[j]);
  for (size_t back = 0; back <= n - core; ++back)
    t->guess[n - back] = t->spare.state[t->spare.n - back];
  return PO_OK;
}

/* Meshes for the prediction (unless the mesh in force serves and may), solves, and meshes again
 * while the solution is not resolved. Status: PO_NOT_CONVERGED also when no mesh resolves it. */
static po_status solve_prediction(tracker *t, prediction *p, double distance, bool may_keep_mesh,
                                  po_track_point *out) {
  if (!may_keep_mesh || !mesh_serves(t, p)) {
    po_leaves leaves;
    if (!po_leaves_build(&leaves, too_large, p))
      return t->trouble =
                 po_fail(PO_OUT_OF_NODES, "the traction needs more than %d panels", PO_MOST_LEAVES);
    if (!po_leaves_equal(&leaves, po_adaptive_leaves(t->adaptive)) && put_in_force(t, &leaves))
      return t->trouble;
  }
  fill_guess(t, p);
  po_status status = PO_OK;
  for (int mesh = 0; mesh < MOST_MESHES_A_POINT && !status; ++mesh) {
    status = solve_guess(t, distance, out);
    if (status || po_resolution_excess(&t->resolution, &out->leaves, out->state) <= 1.0)
      return status;
    status = want_mesh(t, out);
    if (!status)
      status = guess_from_solved(t, out);
  }
  return status ? status : PO_NOT_CONVERGED;
}

static double prediction_error(const tracker *t, const prediction *p) {
  double largest = 0.0;
  const size_t core = t->next.leaves.count * ORDER;
  for (size_t j = 0; j < core; ++j) {
    const double expected = predicted_gap((void *)p, t->e->surface->node[j]);
    largest = fmax(largest, fabs(t->next.state[j] - expected) / (1.0 + t->next.state[j]));
  }
  return largest;
}

static po_branch_point seen_point(const tracker *t, const po_track_point *p, po_point_kind kind) {
  return (po_branch_point){.kind = kind,
                           .position = p->position,
                           .approach = approach_of(p),
                           .load = p->load,
                           .approach_rate = p->tangent[p->n],
                           .load_rate = p->load_rate,
                           .unstable_modes = t->unstable_modes,
                           .n = p->leaves.count * ORDER,
                           .node = p->node,
                           .gap = p->state};
}

static void visit(tracker *t, const po_track_point *p, po_point_kind kind) {
  const po_branch_point point = seen_point(t, p, kind);
  if (t->options->visit(&point, t->options->data))
    t->ended = true;
}

static po_sample sample_of(const tracker *t, const po_track_point *p) {
  const double per_distance = 1.0 / along(t->current.rate, p->rate);
  return (po_sample){.at = progress_between(&t->current, p),
                     .value = {approach_of(p), p->load},
                     .rate = {p->tangent[p->n] * per_distance, p->load_rate * per_distance}};
}

static po_status solve_inner(void *data, double at, po_sample *sample) {
  tracker *t = data;
  prediction p;
  predict(t, &t->next, at, &p);
  const po_status status = solve_prediction(t, &p, at, true, &t->inner);
  if (status)
    return status;
  const double whole = progress_between(&t->current, &t->next);
  t->inner.position = t->current.position + (t->next.position - t->current.position) * at / whole;
  *sample = sample_of(t, &t->inner);
  return PO_OK;
}

static void keep_inner(void *data, size_t place) {
  tracker *t = data;
  po_track_point_copy(&t->inner, &t->at_event[place]);
}

static po_status find_events(tracker *t) {
  const po_interval interval = {.data = t,
                                .solve = solve_inner,
                                .keep = keep_inner,
                                .station = t->station_met ? (double)NAN : t->options->station,
                                .end = t->options->end};
  const po_sample from = sample_of(t, &t->current), to = sample_of(t, &t->next);
  return po_events_find(&interval, &from, &to, &t->events);
}

/* One attempt at a step. Returned: the factor for the next; status says whether it is taken. */
static double try_step(tracker *t, double step, po_status *status) {
  prediction p;
  *status = PO_NOT_CONVERGED;
  if (!predict(t, t->has_previous ? &t->previous : NULL, step, &p))
    return 0.5;
  *status = solve_prediction(t, &p, step, false, &t->next);
  if (*status)
    return 0.5;
  const double error = prediction_error(t, &p);
  const po_branch_point from = seen_point(t, &t->current, PO_POINT_STEP);
  const po_branch_point to = seen_point(t, &t->next, PO_POINT_STEP);
  const double sagitta = po_branch_sagitta(&from, &to) / t->options->largest_sagitta;
  *status = PO_NOT_CONVERGED;
  if (error > GREATEST_ERROR || along(t->current.rate, t->next.rate) < LEAST_COSINE)
    return fmax(0.25, fmin(0.7, pow(AIMED_ERROR / error, 0.25)));
  if (sagitta > 1.0)
    return fmax(0.25, 0.8 / sqrt(sagitta));
  t->next.position = t->current.position + step;
  *status = find_events(t);
  if (!*status)
    *status = want_mesh(t, &t->next);
  if (*status)
    return 0.5;
  return fmax(0.4, fmin(2.0, pow(AIMED_ERROR / fmax(error, 1e-30), 0.25)));
}

static po_status advance(tracker *t) {
  po_status status = PO_NOT_CONVERGED;
  while (status) {
    if (t->step < SHORTEST_STEP)
      return po_fail(PO_STEP_TOO_SMALL,
                     "the branch could not be followed with the shortest step past approach %.6g, "
                     "load %.6g",
                     approach_of(&t->current), t->current.load);
    t->step *= try_step(t, t->step, &status);
    if (t->trouble)
      return t->trouble;
  }
  return PO_OK;
}

static void visit_step(tracker *t) {
  for (size_t k = 0; k < t->events.count && !t->ended; ++k) {
    const po_event *ev = &t->events.list[k];
    const po_track_point *p = &t->at_event[ev->place];
    const po_point_kind kind = po_event_point(ev);
    t->unstable_modes += po_change_of_modes(kind, p->load_rate);
    t->station_met = t->station_met || ev->of == PO_AT_STATION;
    visit(t, p, kind);
    t->ended = t->ended || ev->of == PO_AT_END;
  }
  if (!t->ended)
    visit(t, &t->next, PO_POINT_STEP);
}

static void shift(tracker *t) {
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
static po_status start(tracker *t) {
  po_equilibrium *e = t->e;
  undeformed u = {e->scene, fmin(po_branch_start(e), t->options->begin)}; /* begin may be NaN */
  const po_gap_field field = {undeformed_gap, &u};
  po_leaves leaves = *po_adaptive_leaves(t->adaptive);
  po_status status = po_resolution_leaves(&t->resolution, &field, &leaves);
  if (!status)
    status = put_in_force(t, &leaves);
  if (status)
    return status;
  po_track_point *p = &t->current;
  for (size_t j = 0; j < e->n; ++j)
    t->guess[j] = p->state[j] = e->shape[j] - u.approach;
  t->guess[e->n] = p->state[e->n] = u.approach;
  memset(t->border, 0, (e->n + 1) * sizeof *t->border);
  t->border[e->n] = 1.0;
  status = po_equilibrium_factorize(e, p->state, t->border);
  if (!status)
    status = po_equilibrium_correct(e, p->state, t->guess, 0.0);
  if (!status)
    status = po_equilibrium_tangent(e, p->tangent);
  if (status)
    return po_fail(status, "no equilibrium found far out, at approach %g", u.approach);
  po_track_point_finish(p, e, t->adaptive);
  e->factorized = false; /* its border is not of the gauge */
  return want_mesh(t, p);
}

static double least_gap(const po_track_point *p) {
  double least = INFINITY;
  for (size_t j = 0; j < p->n; ++j)
    least = fmin(least, p->state[j]);
  return least;
}

static po_status trace(tracker *t) {
  po_status status = start(t);
  if (status)
    return status;
  visit(t, &t->current, PO_POINT_STEP);
  const double begin_gap = least_gap(&t->current);
  while (!status && !t->ended) {
    status = advance(t);
    if (!status && least_gap(&t->next) > begin_gap)
      status = po_fail(PO_NOT_CONVERGED, "the branch led back to where it began, at approach %.6g",
                       approach_of(&t->next));
    if (!status)
      visit_step(t);
    if (!status && ++t->points > t->options->most_points)
      status =
          po_fail(PO_TOO_MANY_POINTS, "more than %zu points, the last at approach %.6g, load %.6g",
                  t->options->most_points, approach_of(&t->next), t->next.load);
    shift(t);
  }
  return status;
}

po_status po_track_trace(po_equilibrium *equilibrium, po_adaptive *adaptive, double allowed_error,
                         const po_branch_options *options) {
  tracker t = {.e = equilibrium, .adaptive = adaptive, .options = options, .step = FIRST_STEP};
  const size_t capacity = po_adaptive_capacity(adaptive);
  po_track_point *points[5 + PO_MOST_EVENTS] = {&t.previous, &t.current, &t.next, &t.inner,
                                                &t.spare};
  for (int k = 0; k < PO_MOST_EVENTS; ++k)
    points[5 + k] = &t.at_event[k];
  po_status status = PO_OK;
  for (int k = 0; k < 5 + PO_MOST_EVENTS; ++k)
    status = po_track_point_allocate(points[k], capacity) ? PO_NO_MEMORY : status;
  t.border = po_allocate(capacity + 1, sizeof *t.border);
  t.guess = po_allocate(capacity + 1, sizeof *t.guess);
  t.root = po_adaptive_root(adaptive);
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  po_legendre_fill(rule, &t.legendre);
  t.resolution = (po_resolution){equilibrium, rule, &t.legendre, t.root, allowed_error};
  if (!t.border || !t.guess)
    status = PO_NO_MEMORY;
  if (!status)
    status = trace(&t);
  for (int k = 0; k < 5 + PO_MOST_EVENTS; ++k)
    po_track_point_free(points[k]);
  free(t.border);
  free(t.guess);
  return status;
}
