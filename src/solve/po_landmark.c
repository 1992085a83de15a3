#include "po_landmark.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "po_hermite.h"

enum { MOST_ROOT_STEPS = 40, MOST_SPLITS = 14 };

/* A landmark is located when the value it is the extremum of changes by less than this. */
static const double LOCATED = 1e-12;

/* A rate that falls to this part of that at the ends of an interval may change sign unseen. */
static const double SUSPECT = 0.4;

/* The function whose root is the event; NaN when nothing is asked for. */
static double event_value(const po_interval *interval, po_event_kind of, const po_sample *s) {
  if (of <= PO_OF_LOAD)
    return s->rate[of];
  return s->value[PO_OF_APPROACH] - (of == PO_AT_STATION ? interval->station : interval->end);
}

/* Whether two extrema of a quantity hide between two samples, by the cubic between them, or might:
 * its rate falls far below that at the ends without changing sign. */
static bool is_suspect(const po_sample *a, const po_sample *b, po_event_kind q) {
  const double whole = b->at - a->at;
  double at[2];
  if (a->rate[q] * b->rate[q] > 0.0)
    return po_hermite_least_rate(a->value[q], a->rate[q], b->value[q], b->rate[q], whole) < SUSPECT;
  return po_hermite_extrema(a->value[q], a->rate[q], b->value[q], b->rate[q], whole, at) == 2;
}

static po_status collect_between(const po_interval *interval, const po_sample *a,
                                 const po_sample *b, po_events *found) {
  for (po_event_kind q = PO_OF_APPROACH; q <= PO_AT_END; ++q) {
    const double low = event_value(interval, q, a), high = event_value(interval, q, b);
    if (!((low < 0.0 && high >= 0.0) || (low > 0.0 && high <= 0.0)))
      continue;
    if (found->count == PO_MOST_EVENTS)
      return PO_NOT_CONVERGED;
    found->list[found->count] = (po_event){
        .of = q, .low = a->at, .high = b->at, .f_low = low, .f_high = high, .place = found->count};
    ++found->count;
  }
  return PO_OK;
}

/* Collects the events between two samples; halves the interval while extrema may hide in it. */
static po_status collect(const po_interval *interval, const po_sample *a, const po_sample *b,
                         int splits, po_events *found) {
  const bool split = is_suspect(a, b, PO_OF_APPROACH) || is_suspect(a, b, PO_OF_LOAD);
  if (!split || splits == MOST_SPLITS)
    return collect_between(interval, a, b, found);
  po_sample middle;
  po_status status = interval->solve(interval->data, 0.5 * (a->at + b->at), &middle);
  if (!status)
    status = collect(interval, a, &middle, splits + 1, found);
  return status ? status : collect(interval, &middle, b, splits + 1, found);
}

/* Narrows an event's bracket to its root by the Illinois variant of false position. */
static po_status locate(const po_interval *interval, po_event *ev) {
  double low = ev->low, high = ev->high, f_low = ev->f_low, f_high = ev->f_high;
  int side = 0;
  for (int k = 0; k < MOST_ROOT_STEPS; ++k) {
    const double at = (low * f_high - high * f_low) / (f_high - f_low);
    po_sample s;
    const po_status status = interval->solve(interval->data, at, &s);
    if (status)
      return status;
    const double f = event_value(interval, ev->of, &s);
    ev->root = at;
    interval->keep(interval->data, ev->place);
    /* how far the extremum's value, or the approach asked for, may still be */
    const double left = ev->of <= PO_OF_LOAD ? 0.5 * fabs(f * (high - low)) : fabs(f);
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
  return PO_NOT_CONVERGED;
}

static int by_root(const void *left, const void *right) {
  const double a = ((const po_event *)left)->root, b = ((const po_event *)right)->root;
  return (a > b) - (a < b);
}

po_status po_events_find(const po_interval *interval, const po_sample *from, const po_sample *to,
                         po_events *found) {
  found->count = 0;
  po_status status = collect(interval, from, to, 0, found);
  for (size_t k = 0; k < found->count && !status; ++k)
    status = locate(interval, &found->list[k]);
  qsort(found->list, found->count, sizeof *found->list, by_root);
  return status;
}

po_point_kind po_event_point(const po_event *ev) {
  if (ev->of > PO_OF_LOAD)
    return PO_POINT_STATION;
  const bool rising = ev->f_low > 0.0;
  if (ev->of == PO_OF_APPROACH)
    return rising ? PO_POINT_APPROACH_MAX : PO_POINT_APPROACH_MIN;
  return rising ? PO_POINT_LOAD_MAX : PO_POINT_LOAD_MIN;
}

/* On the side of a fold where the load falls steeply with the approach the mode that changes is
 * stable: the potential's second derivative along it goes to zero from above, and d load / d
 * approach to minus infinity (load = dU/d approach). */
int po_change_of_modes(po_point_kind kind, double load_rate) {
  if (kind == PO_POINT_APPROACH_MAX)
    return load_rate < 0.0 ? 1 : -1;
  if (kind == PO_POINT_APPROACH_MIN)
    return load_rate > 0.0 ? 1 : -1;
  return 0;
}
