#include "po_special_point.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "po_hermite.h"
#include "po_root.h"

enum { MOST_ROOT_STEPS = 40, LEAST_ROOT_STEPS = 5, MOST_SPLITS = 14 };

const double PO_LOCATED = 1e-9;

/* Accuracy to which a station is met, eps. */
static const double ARRIVED = 3e-11;

/* If the rate of the cubic falls below this part of the greater end value, two special points are
 * suspected in the interval. */
static const double SUSPECT = 0.4;

/* But not if the rate of the cubic, a parabola, has its vertex farther outside the interval than
 * this, relative to the length of the interval: the rate then falls towards a special point of the
 * next interval. Without this exception intervals are halved down to the distance of that point. */
static const double VERTEX_OUTSIDE = 0.5;

/* The quantity that has a given value, or an extremum, at an event. */
static po_event_kind quantity_of(po_event_kind of) {
  return of == PO_OF_LOAD || of == PO_AT_STATION_LOAD ? PO_OF_LOAD : PO_OF_APPROACH;
}

/* The value that the quantity has at a station or at the end of the trace; NAN: it is not set. */
static double value_asked(const po_interval *interval, po_event_kind of) {
  if (of == PO_AT_END)
    return interval->end;
  return of == PO_AT_STATION_LOAD ? interval->station_load : interval->station[of - PO_AT_STATION];
}

/* The function whose root is the event; NaN for a station or an end that is not set. */
static double event_value(const po_interval *interval, po_event_kind of, const po_sample *s) {
  if (of <= PO_OF_LOAD)
    return s->rate[of];
  return s->value[quantity_of(of)] - value_asked(interval, of);
}

/* The greatest change of a quantity by the rates at two samples. */
static double change_by_rates(const po_sample *a, const po_sample *b, po_event_kind q) {
  return fmax(fabs(a->rate[q]), fabs(b->rate[q])) * (b->at - a->at);
}

/* Whether two extrema of a quantity are suspected between two samples: the rate of the cubic
 * between them falls far below the end values, or changes its sign twice. If the quantity changes
 * by less than the error of a solution, the cubic shows that error: where a deep neck hardly
 * changes the load, each step would be halved MOST_SPLITS times. */
static bool is_suspect(const po_interval *interval, const po_sample *a, const po_sample *b,
                       po_event_kind q) {
  return a->rate[q] * b->rate[q] > 0.0 &&
         change_by_rates(a, b, q) > interval->precision * (1.0 + fabs(a->value[q])) &&
         po_hermite_least_rate(a->value[q], a->rate[q], b->value[q], b->rate[q], b->at - a->at,
                               VERTEX_OUTSIDE) < SUSPECT;
}

/* Adds an event that is to be located. Status: PO_NOT_CONVERGED if there are too many. */
static po_status add_event(po_event_kind of, const po_sample *low, const po_sample *high,
                           po_events *found) {
  if (found->count == PO_MOST_EVENTS)
    return PO_NOT_CONVERGED;
  found->list[found->count] =
      (po_event){.of = of, .low = *low, .high = *high, .place = found->count};
  ++found->count;
  return PO_OK;
}

static po_status collect_between(const po_interval *interval, const po_sample *a,
                                 const po_sample *b, po_events *found) {
  po_status status = PO_OK;
  for (po_event_kind q = PO_OF_APPROACH; q <= PO_AT_END && !status; ++q) {
    const double low = event_value(interval, q, a), high = event_value(interval, q, b);
    if ((low < 0.0 && high >= 0.0) || (low > 0.0 && high <= 0.0))
      status = add_event(q, a, b, found);
  }
  return status;
}

/* Collects the events between two samples. Halves the interval if extrema are suspected in it. */
static po_status collect(const po_interval *interval, const po_sample *a, const po_sample *b,
                         int splits, po_events *found) {
  const bool split =
      is_suspect(interval, a, b, PO_OF_APPROACH) || is_suspect(interval, a, b, PO_OF_LOAD);
  if (!split || splits == MOST_SPLITS)
    return collect_between(interval, a, b, found);
  po_sample middle;
  po_status status = interval->solve(interval->data, 0.5 * (a->at + b->at), true, &middle);
  if (!status)
    status = collect(interval, a, &middle, splits + 1, found);
  return status ? status : collect(interval, &middle, b, splits + 1, found);
}

typedef struct {
  const po_interval *interval;
  po_event_kind of;
  const po_sample *a, *b;
} cubic_event;

/* The function of the event, evaluated on the cubic between two samples. */
static double event_on_cubic(const cubic_event *c, double at) {
  const po_sample *a = c->a, *b = c->b;
  const po_event_kind q = quantity_of(c->of);
  const double x = at - a->at, h = b->at - a->at;
  po_sample s;
  s.value[q] = po_hermite_value(a->value[q], a->rate[q], b->value[q], b->rate[q], x, h);
  s.rate[q] = po_hermite_rate(a->value[q], a->rate[q], b->value[q], b->rate[q], x, h);
  return event_value(c->interval, c->of, &s);
}

/* Whether the function of the event has the same sign as at the first sample. */
static bool is_before(double at, const void *data) {
  const cubic_event *c = data;
  const bool rises = event_value(c->interval, c->of, c->a) < 0.0;
  return (event_on_cubic(c, at) < 0.0) == rises;
}

/* The root of that function, which has different signs at the two samples. */
static double root_on_cubic(const po_interval *interval, po_event_kind of, const po_sample *a,
                            const po_sample *b) {
  const cubic_event cubic = {interval, of, a, b};
  double low = a->at, high = b->at;
  po_bisect(is_before, &cubic, 0.0, &low, &high);
  return 0.5 * (low + high);
}

bool po_special_point_is_close(const po_sample *sample, po_event_kind of, double distance,
                               double precision) {
  return 0.5 * fabs(sample->rate[of] * distance) <= precision * (1.0 + fabs(sample->value[of]));
}

/* Whether the last sample of an event is as close to it as the precision of solutions allows. */
static bool is_close(const po_interval *interval, const po_event *ev) {
  const double value = fabs(ev->here.value[quantity_of(ev->of)]);
  if (ev->of > PO_OF_LOAD)
    return fabs(event_value(interval, ev->of, &ev->here)) <= interval->precision * (1.0 + value);
  return po_special_point_is_close(&ev->here, ev->of, ev->left, interval->precision);
}

/* Locates an event: repeatedly solves for the equilibrium at the root of the cubic between the ends
 * of the bracket. If rounding prevents a closer location, the precision of the solutions decides.
 */
static po_status locate(const po_interval *interval, po_event *ev) {
  po_sample low = ev->low, high = ev->high, last = {.at = NAN};
  double f_last = NAN;
  for (int k = 0; k < MOST_ROOT_STEPS; ++k) {
    const double at = root_on_cubic(interval, ev->of, &low, &high);
    po_sample s;
    const po_status status = interval->solve(interval->data, at, false, &s);
    if (status)
      return k > 0 && is_close(interval, ev) ? PO_OK : status;
    const double f = event_value(interval, ev->of, &s);
    const bool is_high = (f < 0.0) == (event_value(interval, ev->of, &high) < 0.0);
    ev->root = at;
    ev->here = s;
    interval->keep(interval->data, ev->place);
    /* distance of the root, by the secants through the other end and through the last sample */
    const po_sample *other = is_high ? &low : &high;
    const double f_other = event_value(interval, ev->of, other);
    double left = fabs(f * (at - other->at) / (f - f_other));
    if (k > 0)
      left = fmin(left, fabs(f * (at - last.at) / (f - f_last)));
    const bool nearer = k < LEAST_ROOT_STEPS || left < 0.5 * ev->left;
    ev->left = left;
    if (left < (ev->of <= PO_OF_LOAD ? PO_LOCATED : ARRIVED) || fabs(high.at - low.at) < PO_LOCATED)
      return PO_OK;
    if (!nearer && is_close(interval, ev))
      return PO_OK;
    *(is_high ? &high : &low) = s;
    last = s;
    f_last = f;
  }
  return PO_NOT_CONVERGED;
}

/* Adds the stations that are passed twice between two samples, before and after an extremum of
 * their quantity: both samples are on one side of the station, the extremum is on the other. */
static po_status add_hidden(const po_interval *interval, const po_event *extremum,
                            po_events *found) {
  po_status status = PO_OK;
  for (po_event_kind q = PO_AT_STATION; q <= PO_AT_END && !status; ++q) {
    const double low = event_value(interval, q, &extremum->low),
                 high = event_value(interval, q, &extremum->high),
                 turn = event_value(interval, q, &extremum->here);
    if (quantity_of(q) != extremum->of || !(low * high > 0.0 && low * turn < 0.0))
      continue;
    status = add_event(q, &extremum->low, &extremum->here, found);
    if (!status)
      status = add_event(q, &extremum->here, &extremum->high, found);
  }
  return status;
}

static int by_root(const void *left, const void *right) {
  const double a = ((const po_event *)left)->root, b = ((const po_event *)right)->root;
  return (a > b) - (a < b);
}

po_status po_events_find(const po_interval *interval, const po_sample *from, const po_sample *to,
                         po_events *found) {
  found->count = 0;
  po_status status = collect(interval, from, to, 0, found);
  size_t k = 0;
  for (; k < found->count && !status; ++k)
    status = locate(interval, &found->list[k]);
  for (size_t j = 0, located = k; j < located && !status; ++j)
    if (found->list[j].of <= PO_OF_LOAD)
      status = add_hidden(interval, &found->list[j], found);
  for (; k < found->count && !status; ++k)
    status = locate(interval, &found->list[k]);
  qsort(found->list, found->count, sizeof *found->list, by_root);
  return status;
}
