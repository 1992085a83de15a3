/* Numbers at the true range from those at greater ones. */
#include <math.h>
#include <stdlib.h>

#include "po_elementary.h"
#include "po_load_unit.h"
#include "po_memory.h"
#include "po_reduced_internal.h"

enum { TERMS = PO_RANGE_TERMS, SOLVES = PO_RANGES_OF_LIMIT };

/* Beyond these errors the limit of a special point or a preload is not stated: of the load,
 * relative to the tolerance times the pull-off force; of the approach, to a^2/R at pull-off. */
static const double MOST_OF_POINT = 10.0, CLOSE = 1e-3;

/* -- Extrapolation -- */

/* A crest of radius R jumps into contact from the gap D at which the attraction w eps^2/D^3 on the
 * area R D deflects the surface by about D: D^(7/2) = w eps^2 sqrt(R)/E*, so that D, and with it
 * approach and load, change with the power 4/7 of the range. (Smooth spheres of Tabor parameters
 * 100 to 10,000 have the power 0.56, a second crest on gelatin 0.54.) */
static const double POWER = 4.0 / 7.0;

/* The terms of an expansion at a range in units of the last one. */
static void terms_at(po_range_terms terms, double x, double term[TERMS]) {
  const double l = po_log(x);
  const double of_edges[TERMS] = {1.0, x * x, x * x * l, x * x * x, x * x * x * l};
  for (int t = 0; t < TERMS; ++t)
    term[t] = terms == PO_BY_EDGES ? of_edges[t] : po_pow(x, t * POWER);
}

/* The weights of values at the ranges, of which the sum is F(1). Given: the number of terms, and
 * the first of as many values. The unknowns are eliminated without pivots, of which none is small:
 * ranges differ by sqrt(2) or more. */
static void weights_of(po_range_terms kind, const double range[SOLVES], int first, int terms,
                       double weight[SOLVES]) {
  double a[TERMS][TERMS + 1];
  const double unit = range[first + terms - 1];
  for (int k = 0; k <= terms; ++k) {
    double term[TERMS];
    terms_at(kind, (k < terms ? range[first + k] : 1.0) / unit, term);
    for (int t = 0; t < terms; ++t)
      a[t][k] = term[t];
  }
  for (int k = 0; k < terms; ++k)
    for (int t = 0; t < terms; ++t) {
      if (t == k)
        continue;
      const double factor = a[t][k] / a[k][k];
      for (int j = k; j <= terms; ++j)
        a[t][j] -= factor * a[k][j];
    }
  for (int k = 0; k < SOLVES; ++k)
    weight[k] = 0.0;
  for (int k = 0; k < terms; ++k)
    weight[first + k] = a[k][terms] / a[k][k];
}

po_range_limit po_range_limit_of(po_range_terms kind, const double range[SOLVES]) {
  po_range_limit l = {.terms = kind};
  weights_of(kind, range, SOLVES - TERMS, TERMS, l.weight);
  weights_of(kind, range, SOLVES - TERMS - 1, TERMS, l.before);
  weights_of(kind, range, SOLVES - TERMS + 1, TERMS - 1, l.fewer);
  return l;
}

double po_range_limit_at(const po_range_limit *l, const double value[SOLVES],
                         const double error[SOLVES], double *bound) {
  double sum = 0.0, before = 0.0, fewer = 0.0, noise = 0.0;
  for (int k = 0; k < SOLVES; ++k) {
    sum += l->weight[k] * value[k];
    before += l->before[k] * value[k];
    fewer += l->fewer[k] * value[k];
    noise += fabs(l->weight[k]) * error[k];
  }
  const double change = fmax(fabs(sum - before), fabs(sum - fewer));
  *bound = PO_CHANGES_ON * change + noise;
  return sum;
}

double po_range_limit_of_number(const po_range_group *g, const po_range_limit *limit, size_t offset,
                                size_t error_offset, double *bound) {
  double value[SOLVES], error[SOLVES];
  bool finite = true;
  for (int k = 0; k < SOLVES; ++k) {
    value[k] = *(const double *)(const void *)(g->at[k] + offset);
    error[k] = error_offset ? *(const double *)(const void *)(g->at[k] + error_offset)
                            : po_reduced_tolerance(g->request) * fabs(value[k]);
    finite &= isfinite(value[k]);
  }
  *bound = 0.0;
  return finite ? po_range_limit_at(limit, value, error, bound) : value[SOLVES - 1];
}

/* Raises the bound of a limit to its change from the last range if that is more than the limit. */
static void raise_if_halved(double last, double limit, double *bound) {
  const double change = fabs(limit - last);
  if (change > fabs(limit))
    *bound = fmax(*bound, change);
}

po_path_state po_range_limit_of_state(const po_range_group *g, const po_range_limit *limit,
                                      size_t offset, po_path_error *error, double *energy) {
  const po_path_state last = *(const po_path_state *)(const void *)(g->at[SOLVES - 1] + offset);
  double ignored;
#define LIMIT(name, bound)                                                                         \
  po_range_limit_of_number(g, limit, offset + offsetof(po_path_state, name), PO_RANGE_NO_ERROR,    \
                           bound)
  const po_path_state state = {.approach = LIMIT(approach, &error->approach),
                               .load = LIMIT(load, &error->load),
                               .energy = LIMIT(energy, energy),
                               .contact_radius = LIMIT(contact_radius, &ignored),
                               .position = last.position};
#undef LIMIT
  if (limit->terms == PO_BY_CRESTS && isfinite(last.approach)) {
    raise_if_halved(last.approach, state.approach, &error->approach);
    raise_if_halved(last.load, state.load, &error->load);
  }
  return state;
}

/* -- Where loading jumps -- */

/* The number of halvings of the width of the edges from whose change is found what the power
 * leaves. */
enum { SPAN = 4 };

int po_range_side_of(const po_ranges *ranges, int first, int last, const double value[],
                     double bound) {
  const int from = last - first > SPAN ? last - SPAN : first;
  const double ratio = ranges->range[from] / ranges->range[last];
  const double to_true = 1.0 - po_pow(ranges->range[last], -POWER); /* of what it is to range 0 */
  const double left = to_true * (value[last] - value[from]) / (po_pow(ratio, POWER) - 1.0);
  const double end = value[last] + PO_CHANGES_ON * left;
  if (fmax(value[last], end) < bound)
    return -1;
  return fmin(value[last], end) >= bound ? 1 : 0;
}

/* -- Results at the true range -- */

typedef struct {
  const po_ranges *ranges;
  const double *range; /* the ranges of the limit */
  int first;           /* index of the first of them */
  po_range_limit limit;
  double load, approach; /* the greatest errors of loads and approaches of which the limit is called
                            known, pi w R and eps */
} taker;

/* Sets a number and its error to the limit of a member of the estimates of a track; `unit` is the
 * range for a length, 1.0 for a load. */
#define TO_LIMIT(t, track, member, error_member, unit, to, to_error)                               \
  do {                                                                                             \
    double values_[SOLVES], errors_[SOLVES];                                                       \
    for (int k = 0; k < SOLVES; ++k) {                                                             \
      const po_special_point *p_ = &(track)->at[(t)->first + k].point;                             \
      const double range = (t)->range[k];                                                          \
      (void)range;                                                                                 \
      values_[k] = p_->member * (unit);                                                            \
      errors_[k] = p_->error_member * (unit);                                                      \
    }                                                                                              \
    (to) = po_range_limit_at(&(t)->limit, values_, errors_, &(to_error));                          \
  } while (false)

/* The limit of a special point. */
static po_special_point point_of(const taker *t, const po_range_track *track) {
  po_special_point p = track->at[t->first + SOLVES - 1].point;
  TO_LIMIT(t, track, load, load_error, 1.0, p.load, p.load_error);
  TO_LIMIT(t, track, approach, approach_error, range, p.approach, p.approach_error);
  TO_LIMIT(t, track, contact_radius, contact_radius_error, range, p.contact_radius,
           p.contact_radius_error);
  TO_LIMIT(t, track, energy, energy_error, range, p.energy, p.energy_error);
  p.contact_radius_other *= t->range[SOLVES - 1];
  return p;
}

static void take_sensitivity(const taker *t, const po_range_track *track, po_result *o) {
  static const double none[SOLVES] = {0.0};
  double tabor[SOLVES], radius[SOLVES], amplitude[SOLVES], wavelength[SOLVES], ignored;
  o->pull_off.has_sensitivity = true;
  for (int k = 0; k < SOLVES; ++k) {
    const po_sensitivity *s = &track->sensitivity[t->first + k];
    o->pull_off.has_sensitivity &= track->has_sensitivity[t->first + k];
    tabor[k] = s->tabor;
    radius[k] = s->radius;
    amplitude[k] = s->amplitude;
    wavelength[k] = s->wavelength;
  }
  po_sensitivity *to = &o->pull_off.sensitivity;
  *to = track->sensitivity[t->first];
  to->tabor = po_range_limit_at(&t->limit, tabor, none, &ignored);
  to->radius = po_range_limit_at(&t->limit, radius, none, &ignored);
  to->amplitude = po_range_limit_at(&t->limit, amplitude, none, &ignored);
  to->wavelength = po_range_limit_at(&t->limit, wavelength, none, &ignored);
}

static void take_pull_off(const taker *t, const po_range_track *track, po_result *o) {
  const po_special_point p = point_of(t, track);
  const po_estimate last = track->at[t->first + SOLVES - 1];
  po_estimate_pull_off(&(po_estimate){.point = p, .far_load_error = last.far_load_error}, o);
  take_sensitivity(t, track, o);
  o->range.change = o->pull_off.force - fabs(last.point.load);
}

/* The greatest pull-off of all preloads, if it is known, is the pull-off or another minimum. */
static void take_any(const taker *t, const po_range_points *points, po_result *o) {
  if (!o->pull_off_any.is_known)
    return;
  const po_range_track *track = points->any ? points->any : points->pull_off;
  const po_special_point p = point_of(t, track);
  o->pull_off_any.force = fabs(p.load);
  o->pull_off_any.force_error = p.load_error;
  o->pull_off_any.approach = p.approach;
  o->pull_off_any.approach_error = p.approach_error;
}

/* Adds the limit of a special point to a list if it is known. */
static void add_point(const taker *t, const po_range_track *track, po_special_point *list,
                      size_t *count) {
  if (!track)
    return;
  const po_special_point p = point_of(t, track);
  if (p.load_error <= t->load && p.approach_error <= t->approach)
    list[(*count)++] = p;
}

static po_status take_points(const taker *t, const po_range_points *points, po_result *o) {
  const bool begins_first =
      points->begin && points->jump &&
      points->begin->at[t->first].point.position < points->jump->at[t->first].point.position;
  free(o->folds);
  free(o->extrema);
  o->fold_count = o->extremum_count = 0;
  o->folds = po_allocate(2, sizeof *o->folds);
  o->extrema = po_allocate(1, sizeof *o->extrema);
  if (!o->folds || !o->extrema)
    return PO_NO_MEMORY;
  add_point(t, begins_first ? points->begin : points->jump, o->folds, &o->fold_count);
  add_point(t, begins_first ? points->jump : points->begin, o->folds, &o->fold_count);
  add_point(t, points->pull_off, o->extrema, &o->extremum_count);
  return PO_OK;
}

/* The least preload with the pull-off is that at the jump, if its limit is known. */
static void take_preloads(const taker *t, const po_range_points *points, po_result *o) {
  const po_preload unknown = {NAN, NAN};
  o->pull_off.pressed = o->pull_off.until = unknown;
  if (points->any || !o->pull_off_any.is_known)
    o->pull_off_any.pressed = unknown;
  if (!points->jump)
    return;
  const po_special_point p = point_of(t, points->jump);
  if (p.approach_error <= t->approach)
    o->pull_off.pressed = (po_preload){p.approach, p.load};
  if (!points->any && o->pull_off_any.is_known)
    o->pull_off_any.pressed = o->pull_off.pressed;
}

po_status po_range_limit_take(const po_ranges *ranges, const po_range_points *points, int last,
                              po_result *o) {
  const po_request *request = ranges->request;
  taker t = {.ranges = ranges, .first = last - SOLVES + 1};
  t.range = &ranges->range[t.first];
  t.limit = po_range_limit_of(PO_BY_EDGES, t.range);
  o->range.is_reduced = true;
  o->range.greatest = t.range[0];
  o->range.least = t.range[SOLVES - 1];
  take_pull_off(&t, points->pull_off, o);
  take_any(&t, points, o);
  const double radius = o->pull_off.contact_radius;
  t.load = MOST_OF_POINT * request->mesh.tolerance * o->pull_off.force;
  t.approach = CLOSE * radius * radius / request->scene.radius;
  take_preloads(&t, points, o);
  return take_points(&t, points, o);
}
