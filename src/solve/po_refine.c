#include "po_refine.h"

#include <math.h>

#include "po_hermite.h"

enum { MOST_SOLVES = 5 };

/* Panels whose error is below this part of the largest are left as they are. */
static const double CONTRIBUTES = 0.01;

/* A panel of more waves of the waviness is too coarse for its coefficients to tell what it misses.
 */
static const double TELLING_WAVES = 2.5;

/* The rate whose root is the landmark is found to this part of its slope. */
static const double LOCATED = 1e-9;
/* Or the secant has no more to say: its next step is this part of the last. */
static const double SMALL_STEP = 1e-3;
/* Along the gauge, when the slope is to be found: narrow minima of the load are a hundred times as
 * wide. */
static const double TRIAL_STEP = 1e-5;
/* Errors of landmarks: times the change on a finer mesh; and times the precision of Newton. */
static const double SAFETY = 3.0, FLOOR = 10.0;

/* Splits leaves until all are of few waves. Where there is no room for that they are left as they
 * were. */
static void split_waves(const po_resolution *r, po_leaves *leaves) {
  const po_scene *scene = r->e->scene;
  const po_leaves before = *leaves;
  bool any = po_scene_is_wavy(scene);
  while (any) {
    bool split[PO_MOST_LEAVES];
    any = false;
    for (size_t k = 0; k < leaves->count; ++k) {
      const double length = r->root * po_leaf_size(leaves->leaf[k]);
      split[k] = length > TELLING_WAVES * scene->wavelength;
      any = any || split[k];
    }
    if (any && !po_leaves_split(leaves, split)) {
      *leaves = before;
      return;
    }
  }
}

/* The leaves of p, those halved that contribute to its error, and those split that may hide one. */
static bool finer_leaves(const po_resolution *r, const po_track_point *p, po_leaves *leaves) {
  double excess[PO_MOST_LEAVES], largest = 0.0;
  bool split[PO_MOST_LEAVES];
  po_resolution_excesses(r, &p->leaves, p->state, excess);
  for (size_t k = 0; k < p->leaves.count; ++k)
    largest = fmax(largest, excess[k]);
  for (size_t k = 0; k < p->leaves.count; ++k)
    split[k] = excess[k] > CONTRIBUTES * largest;
  *leaves = p->leaves;
  if (!po_leaves_split(leaves, split))
    return false;
  split_waves(r, leaves);
  return true;
}

/* d rate / d distance at the event, on the cubic of its interval, per distance along its own gauge.
 */
static double slope_at(const po_event *ev, double cosine) {
  const po_sample *a = &ev->low, *b = &ev->high;
  const double h = b->at - a->at, x = ev->root - a->at, by = 0.01 * h;
  double rate[2];
  for (int k = 0; k < 2; ++k)
    rate[k] = po_hermite_rate(a->value[ev->of], a->rate[ev->of], b->value[ev->of], b->rate[ev->of],
                              x + (k ? by : -by), h);
  return (rate[1] - rate[0]) / (2.0 * by) * cosine * cosine;
}

/* The value of the landmark's quantities where the rate between two samples vanishes. */
static void values_at_root(const po_sample *a, const po_sample *b, po_event_kind of,
                           double value[2]) {
  const double h = b->at - a->at, x = -a->rate[of] * h / (b->rate[of] - a->rate[of]);
  for (int q = 0; q < 2; ++q)
    value[q] = po_hermite_value(a->value[q], a->rate[q], b->value[q], b->rate[q], x, h);
}

po_status po_refine_locate(po_corrector *c, const po_track_point *from, po_event_kind of,
                           double *slope, po_track_point *out, double value[2]) {
  double at = 0.0;
  po_sample last = {.at = NAN}, s;
  for (int k = 0; k < MOST_SOLVES; ++k) {
    const po_status status = po_corrector_solve(c, from, at, k > 0, c->e->precision, out);
    if (status)
      return status;
    s = po_track_sample(from, out);
    for (int q = 0; q < 2; ++q)
      value[q] = s.value[q];
    if (k > 0) {
      *slope = (s.rate[of] - last.rate[of]) / (s.at - last.at);
      values_at_root(&last, &s, of, value);
    }
    const double step = isnan(*slope) ? TRIAL_STEP : -s.rate[of] / *slope;
    if (!isfinite(step))
      return PO_NOT_CONVERGED;
    if (fabs(step) < LOCATED || (k > 0 && fabs(step) < SMALL_STEP * fabs(s.at - last.at)))
      return PO_OK;
    at = s.at + step;
    last = s;
    for (size_t j = 0; j <= out->n; ++j)
      c->guess[j] = out->state[j] + step / po_gauge_along(from->rate, out->rate) * out->tangent[j];
  }
  return PO_NOT_CONVERGED;
}

po_status po_refine_finer(po_corrector *c, const po_resolution *resolution, const po_track_point *p,
                          po_event_kind of, double slope, po_track_point *spare, double change[2]) {
  po_leaves leaves;
  if (!finer_leaves(resolution, p, &leaves))
    return po_fail(PO_OUT_OF_NODES, "no room for a finer mesh");
  po_status status = po_corrector_mesh(c, &leaves);
  if (status)
    return status;
  po_corrector_guess(c, p);
  double value[2];
  status = po_refine_locate(c, p, of, &slope, spare, value);
  if (status)
    return status;
  change[0] = value[0] - p->state[p->n];
  change[1] = value[1] - p->load;
  return PO_OK;
}

po_status po_refine(po_corrector *c, const po_resolution *resolution, const po_track_point *p,
                    const po_event *event, double cosine, po_track_point *spare, double change[2]) {
  return po_refine_finer(c, resolution, p, event->of, slope_at(event, cosine), spare, change);
}

double po_refine_error(const po_corrector *c, double change, double value) {
  return SAFETY * fabs(change) + FLOOR * c->e->precision * (1.0 + fabs(value));
}
