/* What lies inside a step: folds, extrema of the load, the station and the end, located on the
 * arclength by a bracketed root of the rate. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_branch_internal.h"
#include "po_hermite.h"

enum { MOST_ROOT_STEPS = 40, MOST_SPLITS = 14 };

/* A landmark is located when the value it is the extremum of changes by less than this. */
static const double LOCATED = 1e-12;

/* A rate that falls to this part of that at the ends of an interval may change sign unseen. */
static const double SUSPECT = 0.4;

/* A point of the interval as a function of the distance along the border. */
typedef struct {
  double at, value[2], rate[2]; /* of approach and load, per distance */
} sample;

static sample sample_of(const tracer *t, const branch_point *p) {
  const double per_distance = 1.0 / along_border(t, p->tangent);
  return (sample){.at = border_distance(t, p->state, t->current.state),
                  .value = {point_approach(t, p), p->load},
                  .rate = {point_approach_rate(t, p) * per_distance, p->load_rate * per_distance}};
}

/* The equilibrium at a distance between current and next, into inner. */
static po_status solve_inner(tracer *t, double distance) {
  const branch_point *a = &t->current, *b = &t->next;
  const double rate_a = along_border(t, a->tangent), rate_b = along_border(t, b->tangent);
  const double whole = border_distance(t, b->state, a->state);
  const po_hermite w = po_hermite_at(distance, whole);
  for (size_t j = 0; j <= t->e->n; ++j)
    t->inner.state[j] = a->state[j] + w.d0 * a->tangent[j] / rate_a +
                        w.f1 * (b->state[j] - a->state[j]) + w.d1 * b->tangent[j] / rate_b;
  memcpy(t->predicted, t->inner.state, (t->e->n + 1) * sizeof *t->predicted);
  po_status status = PO_NOT_CONVERGED;
  for (int fresh = 0; status && fresh < 2; ++fresh) {
    if (fresh) { /* the factors are too old: new ones, with the same border */
      memcpy(t->inner.state, t->predicted, (t->e->n + 1) * sizeof *t->predicted);
      status = po_equilibrium_factorize(t->e, t->inner.state, t->e->border);
      if (status)
        return status;
    }
    status = po_equilibrium_correct(t->e, t->inner.state, a->state, distance);
    if (!status)
      status = po_equilibrium_tangent(t->e, t->inner.tangent);
  }
  if (status)
    return status;
  finish_point(t, &t->inner);
  t->inner.position = a->position + (b->position - a->position) * distance / whole;
  return PO_OK;
}

static double target_of(const tracer *t, event_kind of) {
  return of == AT_STATION ? t->options->station : t->options->end;
}

/* The function whose root is the event. */
static double event_value(const tracer *t, event_kind of, const sample *s) {
  return of <= OF_LOAD ? s->rate[of] : s->value[OF_APPROACH] - target_of(t, of);
}

/* Whether two extrema of a event_kind hide between two samples, by the cubic between them, or
 * might: its rate falls far below that at the ends without changing sign. */
static bool is_suspect(const sample *a, const sample *b, event_kind q) {
  const double whole = b->at - a->at;
  double at[2];
  if (a->rate[q] * b->rate[q] > 0.0)
    return po_hermite_least_rate(a->value[q], a->rate[q], b->value[q], b->rate[q], whole) < SUSPECT;
  return po_hermite_extrema(a->value[q], a->rate[q], b->value[q], b->rate[q], whole, at) == 2;
}

/* Collects the events between two samples; halves the interval while extrema may hide in it. */
static po_status collect(tracer *t, const sample *a, const sample *b, int splits,
                         branch_events *found) {
  const bool split = is_suspect(a, b, OF_APPROACH) || is_suspect(a, b, OF_LOAD);
  if (split && splits < MOST_SPLITS) {
    po_status status = solve_inner(t, 0.5 * (a->at + b->at));
    if (status)
      return status;
    const sample middle = sample_of(t, &t->inner);
    status = collect(t, a, &middle, splits + 1, found);
    return status ? status : collect(t, &middle, b, splits + 1, found);
  }
  for (event_kind q = OF_APPROACH; q <= AT_END; ++q) {
    if (q == AT_STATION && t->station_met)
      continue;
    const double low = event_value(t, q, a), high = event_value(t, q, b);
    if ((low < 0.0 && high >= 0.0) || (low > 0.0 && high <= 0.0)) {
      if (found->count == MOST_EVENTS)
        return PO_NOT_CONVERGED;
      found->list[found->count] = (branch_event){.of = q,
                                                 .low = a->at,
                                                 .high = b->at,
                                                 .f_low = low,
                                                 .f_high = high,
                                                 .place = found->count};
      ++found->count;
    }
  }
  return PO_OK;
}

/* Narrows an event's bracket to its root by the Illinois variant of false position. */
static po_status locate(tracer *t, branch_event *ev) {
  double low = ev->low, high = ev->high, f_low = ev->f_low, f_high = ev->f_high;
  int side = 0;
  for (int k = 0; k < MOST_ROOT_STEPS; ++k) {
    const double at = (low * f_high - high * f_low) / (f_high - f_low);
    const po_status status = solve_inner(t, at);
    if (status)
      return status;
    const sample s = sample_of(t, &t->inner);
    const double f = event_value(t, ev->of, &s);
    ev->root = at;
    /* how far the extremum's value, or the station's approach, may still be */
    const double left = ev->of <= OF_LOAD ? 0.5 * fabs(f * (high - low)) : fabs(f);
    copy_point(t, &t->inner, &t->at_event[ev->place]);
    if (left < LOCATED)
      return PO_OK;
    const bool is_high = (f < 0.0) == (f_high < 0.0);
    if (is_high) {
      high = at;
      f_high = f;
      f_low *= side == 1 ? 0.5 : 1.0;
    } else {
      low = at;
      f_low = f;
      f_high *= side == -1 ? 0.5 : 1.0;
    }
    side = is_high ? 1 : -1;
  }
  return PO_OK;
}

static po_point_kind kind_of(const branch_event *ev) {
  if (ev->of > OF_LOAD)
    return PO_POINT_STATION;
  const bool rising = ev->f_low > 0.0;
  if (ev->of == OF_APPROACH)
    return rising ? PO_POINT_APPROACH_MAX : PO_POINT_APPROACH_MIN;
  return rising ? PO_POINT_LOAD_MAX : PO_POINT_LOAD_MIN;
}

/* Stability at fixed approach changes at a fold only, by one mode. On the side where the load falls
 * steeply with the approach the mode is stable: the potential's second derivative along it goes to
 * zero from above, and d load / d approach to minus infinity (load = dU/d approach). */
static int change_of_modes(po_point_kind kind, double load_rate) {
  if (kind == PO_POINT_APPROACH_MAX)
    return load_rate < 0.0 ? 1 : -1;
  if (kind == PO_POINT_APPROACH_MIN)
    return load_rate > 0.0 ? 1 : -1;
  return 0;
}

static void visit_event(tracer *t, const branch_event *ev) {
  const branch_point *p = &t->at_event[ev->place];
  const po_point_kind kind = kind_of(ev);
  t->unstable_modes += change_of_modes(kind, p->load_rate);
  if (ev->of == AT_STATION)
    t->station_met = true;
  visit_point(t, p, kind);
  if (ev->of == AT_END)
    t->ended = true;
}

static int by_root(const void *left, const void *right) {
  const double a = ((const branch_event *)left)->root, b = ((const branch_event *)right)->root;
  return (a > b) - (a < b);
}

po_status find_events(tracer *t) {
  branch_events *found = &t->events;
  const sample a = sample_of(t, &t->current), b = sample_of(t, &t->next);
  found->count = 0;
  po_status status = collect(t, &a, &b, 0, found);
  for (size_t k = 0; k < found->count && !status; ++k)
    status = locate(t, &found->list[k]);
  qsort(found->list, found->count, sizeof *found->list, by_root); /* next is ahead: distances > 0 */
  return status;
}

void visit_step(tracer *t) {
  for (size_t k = 0; k < t->events.count && !t->ended; ++k)
    visit_event(t, &t->events.list[k]);
  if (!t->ended)
    visit_point(t, &t->next, PO_POINT_STEP);
}
