#include "po_minima.h"

#include <math.h>
#include <stdbool.h>

#include "po_watch.h"

/* The most intervals that are searched. Of 2,000 random spheres with one wave, and up to 1.4e6
 * waves in the contact, none needs so many; of 200 random scenes with three waves 9 do, after 0.4
 * s, with couplings above 10. */
enum { MOST_INTERVALS = 1 << 18 };
/* A bound that exceeds the wanted value by less than this part of it excludes nothing. */
static const double ROUNDING = 1e-12;

typedef struct {
  const po_minima_function *f;
  bool last;       /* the last minimum is sought, from the last interval on; otherwise the lowest */
  double most;     /* minima above it are not wanted */
  double x, value; /* of the minimum found */
  bool found;
  size_t intervals;
  po_status stopped;
} search;

static bool is_done(const search *s) {
  return s->stopped || s->intervals >= MOST_INTERVALS || (s->last && s->found);
}

static void take(search *s, double x) {
  const double value = s->f->value(x, s->f->data);
  if (value > s->most + ROUNDING * fabs(s->most))
    return;
  if (s->found && !(value < s->value))
    return;
  s->x = x;
  s->value = value;
  s->found = true;
  s->most = fmin(s->most, value);
}

static bool may_have(const search *s, double low, double high) {
  return !(s->f->below(low, high, s->f->data) > s->most + ROUNDING * fabs(s->most));
}

static void search_leaf(search *s, double low, double high) {
  const double from = nextafter(low, high); /* the derivative on the right of a corner */
  const po_minima_function *f = s->f;
  if (f->rate(from, f->data) < 0.0 && f->rate(high, f->data) >= 0.0)
    take(s, po_root(f->rate, f->data, from, high));
}

static void search_in(search *s, double low, double high) {
  if (is_done(s) || !may_have(s, low, high))
    return;
  s->intervals += 1;
  s->stopped = po_watch_look();
  if (s->f->slowest(low, high, s->f->data) > 0.0) /* it rises: no minimum */
    return;
  const po_minima_function *f = s->f;
  if (high - low <= f->detail(low, f->data)) {
    search_leaf(s, low, high);
    return;
  }
  const double middle = high > 2.0 * low ? sqrt(low) * sqrt(high) : 0.5 * (low + high);
  if (!s->last)
    s->most = fmin(s->most, f->value(middle, f->data));
  const bool outer_first =
      s->last || f->below(middle, high, f->data) < f->below(low, middle, f->data);
  search_in(s, outer_first ? middle : low, outer_first ? high : middle);
  search_in(s, outer_first ? low : middle, outer_first ? middle : high);
}

/* A corner is the end of two intervals. */
static void search_corner(search *s, size_t k) {
  const po_minima_function *f = s->f;
  const double x = f->edge[k];
  if (k == 0 || k + 1 == f->edges || is_done(s))
    return;
  if (f->rate(x, f->data) < 0.0 && f->rate(nextafter(x, INFINITY), f->data) > 0.0)
    take(s, x);
}

static po_status run(search *s, double *x) {
  const size_t pieces = s->f->edges - 1;
  for (size_t i = 0; i < pieces; ++i) {
    const size_t k = s->last ? pieces - 1 - i : i;
    search_in(s, s->f->edge[k], s->f->edge[k + 1]);
    search_corner(s, s->last ? k : k + 1);
  }
  if (s->stopped)
    return s->stopped;
  if (s->intervals >= MOST_INTERVALS)
    return po_fail(
        PO_TOO_MANY_POINTS,
        "more than %d intervals of the contact radius may have a minimum: expected fewer "
        "waves in the contact",
        MOST_INTERVALS);
  if (!s->found)
    return po_fail(PO_NOT_FOUND, "the curve has no minimum");
  *x = s->x;
  return PO_OK;
}

po_status po_minima_least(const po_minima_function *function, double *x) {
  search s = {.f = function, .most = INFINITY};
  return run(&s, x);
}

po_status po_minima_last(const po_minima_function *function, double most, double *x) {
  search s = {.f = function, .last = true, .most = most};
  return run(&s, x);
}
