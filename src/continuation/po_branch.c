#include "po_branch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_hermite.h"
#include "po_join.h"
#include "po_memory.h"
#include "po_special_point.h"

/* Weight of the approach in the metric, against gaps in parts of 1 + H. */
static const double APPROACH_WEIGHT = 0.05;
/* Nodes with 1 + H above this do not count in the metric. */
static const double FAR_GAP = 10.0;
/* Error of the prediction, in parts of 1 + H, that a step aims at, and that it may have. */
static const double AIMED_ERROR = 0.02, GREATEST_ERROR = 0.2;
/* An event's place along the branch. */
static const double LOCATED = 1e-8;
/* Cosine below which the tangent turned too far in one step. */
static const double LEAST_COSINE = 0.7;
/* Cosine of tangent and border below which the border is renewed. */
static const double OLD_BORDER = 0.5;
/* Part of 1 + H that a prediction may take from a gap. */
static const double GREATEST_CLOSING = 0.6;
static const double FIRST_STEP = 0.05, SHORTEST_STEP = 1e-9;
/* Feedback of the undeformed gap below which the start is safe. */
static const double SAFE_FEEDBACK = 0.25;
enum { MOST_DOUBLINGS = 40 };

/* A point of the branch: state and unit tangent, n + 1 each. */
typedef struct {
  double *state, *tangent;
  double position, load, load_rate, energy;
} branch_point;

typedef struct {
  po_equilibrium *e;
  const po_branch_options *options;
  branch_point previous, current, next;  /* current and next are the ends of the last step */
  branch_point inner;                    /* a point between them */
  po_events events;                      /* between them */
  branch_point at_event[PO_MOST_EVENTS]; /* their points, in the order they were found */
  double *border, *metric, *predicted;   /* n + 1 */
  double step;                           /* arclength to try */
  bool has_previous;
  int unstable_modes;
  size_t points;
  size_t core; /* nodes inside the core radius */
  bool ended;
} tracer;

po_branch_options po_branch_options_default(void) {
  return (po_branch_options){.station = {NAN, NAN},
                             .end = NAN,
                             .begin = NAN,
                             .largest_sagitta = INFINITY,
                             .largest_miss = INFINITY,
                             .sharpness = INFINITY,
                             .most_points = 30000};
}

static double point_approach(const tracer *t, const branch_point *p) {
  return p->state[t->e->n];
}
static double point_approach_rate(const tracer *t, const branch_point *p) {
  return p->tangent[t->e->n];
}

static void set_metric(tracer *t, const double *state) {
  const po_surface *s = t->e->surface;
  const double per_length = 1.0 / sqrt(2.0 * t->e->radius);
  for (size_t j = 0; j < t->e->n; ++j) {
    const double h = 1.0 + state[j];
    t->metric[j] = h < FAR_GAP ? s->length[j] * per_length / (h * h) : 0.0;
  }
  t->metric[t->e->n] = APPROACH_WEIGHT;
}

static void finish_point(tracer *t, branch_point *p) {
  double sum = 0.0;
  set_metric(t, p->state);
  for (size_t j = 0; j <= t->e->n; ++j)
    sum += t->metric[j] * p->tangent[j] * p->tangent[j];
  const double scale = 1.0 / sqrt(sum);
  for (size_t j = 0; j <= t->e->n; ++j)
    p->tangent[j] *= scale;
  p->load = po_equilibrium_load(t->e);
  p->load_rate = po_equilibrium_load_rate(t->e, p->tangent);
  p->energy = po_equilibrium_energy(t->e, p->state);
}

static double along_border(const tracer *t, const double *vector) {
  double sum = 0.0;
  for (size_t j = 0; j <= t->e->n; ++j)
    sum += t->e->border[j] * vector[j];
  return sum;
}

static double border_distance(const tracer *t, const double *to, const double *from) {
  double sum = 0.0;
  for (size_t j = 0; j <= t->e->n; ++j)
    sum += t->e->border[j] * (to[j] - from[j]);
  return sum;
}

static po_status refactorize(tracer *t, const branch_point *at, const double *state) {
  set_metric(t, at->state);
  for (size_t j = 0; j <= t->e->n; ++j)
    t->border[j] = t->metric[j] * at->tangent[j];
  return po_equilibrium_factorize(t->e, state, t->border);
}

static po_branch_point seen_point(const tracer *t, const branch_point *p, po_point_kind kind) {
  return (po_branch_point){.kind = kind,
                           .position = p->position,
                           .approach = point_approach(t, p),
                           .load = p->load,
                           .energy = p->energy,
                           .approach_error = NAN,
                           .load_error = NAN,
                           .approach_rate = point_approach_rate(t, p),
                           .load_rate = p->load_rate,
                           .unstable_modes = t->unstable_modes,
                           .n = t->core,
                           .node = t->e->surface->node,
                           .gap = p->state};
}

static void visit_point(tracer *t, const branch_point *p, po_point_kind kind) {
  const po_branch_point point = seen_point(t, p, kind);
  if (t->options->visit(&point, t->options->data))
    t->ended = true;
}

static void copy_point(const tracer *t, const branch_point *from, branch_point *to) {
  branch_point copy = *from;
  copy.state = to->state;
  copy.tangent = to->tangent;
  memcpy(copy.state, from->state, (t->e->n + 1) * sizeof *copy.state);
  memcpy(copy.tangent, from->tangent, (t->e->n + 1) * sizeof *copy.tangent);
  *to = copy;
}

double po_branch_start(po_equilibrium *e) {
  double approach = -2.0;
  for (int k = 0; k < MOST_DOUBLINGS; ++k, approach *= 2.0) {
    for (size_t j = 0; j < e->n; ++j)
      e->right[j] = e->shape[j] - approach;
    po_equilibrium_evaluate(e, e->right);
    if (po_equilibrium_feedback(e) < SAFE_FEEDBACK)
      break;
  }
  return approach;
}

/* The first equilibrium: Newton at fixed approach from the undeformed gap. */
static po_status start(tracer *t) {
  po_equilibrium *e = t->e;
  branch_point *p = &t->current;
  const double approach = fmin(po_branch_start(e), t->options->begin); /* begin may be NaN */
  for (size_t j = 0; j < e->n; ++j)
    p->state[j] = e->shape[j] - approach;
  p->state[e->n] = approach;
  memset(t->border, 0, (e->n + 1) * sizeof *t->border);
  t->border[e->n] = 1.0;
  memcpy(t->predicted, p->state, (e->n + 1) * sizeof *p->state);
  po_status status = po_equilibrium_factorize(e, p->state, t->border);
  if (!status)
    status = po_equilibrium_correct(e, p->state, t->predicted, 0.0);
  if (!status)
    status = po_equilibrium_tangent(e, e->precision, p->tangent);
  if (status)
    return po_fail(status, "no equilibrium found far out, at approach %g", approach);
  finish_point(t, p);
  return PO_OK;
}

/* Fills predicted: the state at `distance` along the border. Returned: whether every gap stays
 * open. */
static bool predict(tracer *t, double distance) {
  const size_t n = t->e->n;
  const branch_point *c = &t->current, *b = &t->previous;
  const double rate = along_border(t, c->tangent);
  const double back = t->has_previous ? border_distance(t, b->state, c->state) : 0.0;
  const double back_rate = t->has_previous ? along_border(t, b->tangent) : 0.0;
  const bool cubic = back * rate < 0.0 && back_rate * rate > 0.0;
  const po_hermite w =
      cubic ? po_hermite_at(distance, back) : (po_hermite){1.0, distance, 0.0, 0.0};
  bool open = true;
  for (size_t j = 0; j <= n; ++j) {
    /* about the current state, so that the weights' sum of one does not cancel */
    t->predicted[j] = c->state[j] + w.d0 * c->tangent[j] / rate;
    if (cubic)
      t->predicted[j] += w.f1 * (b->state[j] - c->state[j]) + w.d1 * b->tangent[j] / back_rate;
    if (j < n && !(1.0 + t->predicted[j] > (1.0 - GREATEST_CLOSING) * (1.0 + c->state[j])))
      open = false;
  }
  return open;
}

/* Largest difference of the corrected gaps from the predicted, in parts of 1 + H. */
static double prediction_error(const tracer *t) {
  double largest = 0.0;
  for (size_t j = 0; j < t->e->n; ++j)
    largest = fmax(largest, fabs(t->next.state[j] - t->predicted[j]) / (1.0 + t->next.state[j]));
  return largest;
}

static double cosine(tracer *t) {
  double dot = 0.0, of_current = 0.0, of_next = 0.0;
  for (size_t j = 0; j <= t->e->n; ++j) { /* metric is that of the next point */
    const double a = t->current.tangent[j], b = t->next.tangent[j], m = t->metric[j];
    dot += m * a * b;
    of_current += m * a * a;
    of_next += m * b * b;
  }
  return dot / sqrt(of_current * of_next);
}

/* Corrects the prediction and takes the tangent there with the factors in hand, or new ones. */
static po_status correct(tracer *t, double step) {
  po_status status = PO_NOT_CONVERGED;
  for (int fresh = t->e->factorized ? 0 : 1; status && fresh < 2; ++fresh) {
    if (fresh) {
      const bool open = predict(t, step * along_border(t, t->current.tangent));
      if (!open)
        return PO_NOT_CONVERGED;
      status = refactorize(t, &t->current, t->predicted);
      if (status)
        return PO_NOT_CONVERGED;
    }
    const double distance = step * along_border(t, t->current.tangent);
    if (!predict(t, distance))
      return PO_NOT_CONVERGED;
    memcpy(t->next.state, t->predicted, (t->e->n + 1) * sizeof *t->predicted);
    status = po_equilibrium_correct(t->e, t->next.state, t->current.state, distance);
    if (!status)
      status = po_equilibrium_tangent(t->e, t->e->precision, t->next.tangent);
  }
  return status;
}

static po_sample sample_of(const tracer *t, const branch_point *p) {
  const double per_distance = 1.0 / along_border(t, p->tangent);
  return (po_sample){
      .at = border_distance(t, p->state, t->current.state),
      .value = {point_approach(t, p), p->load},
      .rate = {point_approach_rate(t, p) * per_distance, p->load_rate * per_distance}};
}

/* The equilibrium at a distance between current and next, into inner. */
static po_status solve_inner(void *data, double distance, po_sample *sample) {
  tracer *t = data;
  const branch_point *a = &t->current, *b = &t->next;
  const double rate_a = along_border(t, a->tangent), rate_b = along_border(t, b->tangent);
  const double whole = border_distance(t, b->state, a->state);
  const po_hermite w = po_hermite_at(distance, whole);
  for (size_t j = 0; j <= t->e->n; ++j)
    t->predicted[j] = a->state[j] + w.d0 * a->tangent[j] / rate_a +
                      w.f1 * (b->state[j] - a->state[j]) + w.d1 * b->tangent[j] / rate_b;
  po_status status = PO_NOT_CONVERGED;
  for (int fresh = 0; status && fresh < 2; ++fresh) {
    memcpy(t->inner.state, t->predicted, (t->e->n + 1) * sizeof *t->predicted);
    if (fresh) { /* the factors are too old: new ones, with the same border */
      status = po_equilibrium_factorize(t->e, t->inner.state, t->e->border);
      if (status)
        return status;
    }
    status = po_equilibrium_correct(t->e, t->inner.state, a->state, distance);
    if (!status)
      status = po_equilibrium_tangent(t->e, t->e->precision, t->inner.tangent);
  }
  if (status)
    return status;
  finish_point(t, &t->inner);
  t->inner.position = a->position + (b->position - a->position) * distance / whole;
  *sample = sample_of(t, &t->inner);
  return PO_OK;
}

static void keep_inner(void *data, size_t place) {
  tracer *t = data;
  copy_point(t, &t->inner, &t->at_event[place]);
}

static po_status find_events(tracer *t) {
  const po_interval interval = {.data = t,
                                .solve = solve_inner,
                                .keep = keep_inner,
                                .station = t->options->station,
                                .end = t->options->end,
                                .located = LOCATED};
  const po_sample from = sample_of(t, &t->current), to = sample_of(t, &t->next);
  return po_events_find(&interval, &from, &to, &t->events);
}

/* Visits the events found and then next. Sets t->ended when the trace is to end. */
static void visit_step(tracer *t) {
  for (size_t k = 0; k < t->events.count && !t->ended; ++k) {
    const po_event *ev = &t->events.list[k];
    const branch_point *p = &t->at_event[ev->place];
    const po_point_kind kind = po_event_point(ev);
    t->unstable_modes += po_change_of_modes(kind, p->load_rate);
    visit_point(t, p, kind);
    t->ended = t->ended || ev->of == PO_AT_END;
  }
  if (!t->ended)
    visit_point(t, &t->next, PO_POINT_STEP);
}

/* One attempt at a step. Returned: the factor for the next step; status says whether it is taken.
 */
static double try_step(tracer *t, double step, po_status *status) {
  *status = correct(t, step);
  if (*status) {
    t->e->factorized = false;
    return 0.5;
  }
  const double error = prediction_error(t);
  finish_point(t, &t->next);
  if (error > GREATEST_ERROR || cosine(t) < LEAST_COSINE || t->e->orientation < 0) {
    *status = PO_NOT_CONVERGED;
    t->e->factorized = false;
    return fmax(0.25, fmin(0.7, pow(AIMED_ERROR / error, 0.25)));
  }
  const po_branch_point from = seen_point(t, &t->current, PO_POINT_STEP);
  const po_branch_point to = seen_point(t, &t->next, PO_POINT_STEP);
  const double sagitta = po_join_sagitta(&from, &to) / t->options->largest_sagitta;
  if (sagitta > 1.0) {
    *status = PO_NOT_CONVERGED;
    return fmax(0.25, 0.8 / sqrt(sagitta));
  }
  t->next.position = t->current.position + step;
  *status = find_events(t);
  if (*status || along_border(t, t->next.tangent) < OLD_BORDER)
    t->e->factorized = false;
  if (*status)
    return 0.5;
  return fmax(0.4, fmin(2.0, pow(AIMED_ERROR / fmax(error, 1e-30), 0.25)));
}

/* Takes one step: next is a new point of the branch. */
static po_status advance(tracer *t) {
  for (;;) {
    const double step = t->step;
    if (step < SHORTEST_STEP)
      return po_fail(PO_STEP_TOO_SMALL,
                     "the branch could not be followed with the shortest step past approach %.6g, "
                     "load %.6g",
                     point_approach(t, &t->current), t->current.load);
    po_status status;
    const double factor = try_step(t, step, &status);
    t->step = step * factor;
    if (!status)
      return PO_OK;
  }
}

static double least_gap(const tracer *t, const branch_point *p) {
  double least = INFINITY;
  for (size_t j = 0; j < t->e->n; ++j)
    least = fmin(least, p->state[j]);
  return least;
}

static void shift(tracer *t) {
  const branch_point oldest = t->previous;
  t->previous = t->current;
  t->current = t->next;
  t->next = oldest;
  t->has_previous = true;
}

static bool allocate_point(branch_point *p, size_t n) {
  p->state = po_allocate(n + 1, sizeof *p->state);
  p->tangent = po_allocate(n + 1, sizeof *p->tangent);
  return p->state && p->tangent;
}

static void free_point(branch_point *p) {
  free(p->state);
  free(p->tangent);
}

po_status po_branch_trace(po_equilibrium *equilibrium, const po_branch_options *options) {
  tracer t = {.e = equilibrium, .options = options, .step = FIRST_STEP};
  const size_t n = equilibrium->n;
  branch_point *const points[] = {&t.previous, &t.current, &t.next, &t.inner};
  bool had = true;
  for (int k = 0; k < 4; ++k)
    had = allocate_point(points[k], n) && had;
  for (int k = 0; k < PO_MOST_EVENTS; ++k)
    had = allocate_point(&t.at_event[k], n) && had;
  t.border = po_allocate(n + 1, sizeof *t.border);
  t.metric = po_allocate(n + 1, sizeof *t.metric);
  t.predicted = po_allocate(n + 1, sizeof *t.predicted);
  while (t.core < n && equilibrium->surface->node[t.core] <= equilibrium->surface->core_radius)
    ++t.core;
  po_status status = had && t.border && t.metric && t.predicted ? PO_OK : PO_NO_MEMORY;
  if (!status)
    status = start(&t);
  if (!status)
    visit_point(&t, &t.current, PO_POINT_STEP);
  const double begin_gap = status ? 0.0 : least_gap(&t, &t.current);
  while (!status && !t.ended) {
    status = advance(&t);
    if (!status && least_gap(&t, &t.next) > begin_gap)
      status = po_fail(PO_NOT_CONVERGED, "the branch led back to where it began, at approach %.6g",
                       point_approach(&t, &t.next));
    if (!status)
      visit_step(&t);
    if (!status && ++t.points > options->most_points)
      status =
          po_fail(PO_TOO_MANY_POINTS, "more than %zu points, the last at approach %.6g, load %.6g",
                  options->most_points, point_approach(&t, &t.next), t.next.load);
    shift(&t);
  }
  for (int k = 0; k < 4; ++k)
    free_point(points[k]);
  for (int k = 0; k < PO_MOST_EVENTS; ++k)
    free_point(&t.at_event[k]);
  free(t.border);
  free(t.metric);
  free(t.predicted);
  return status;
}
