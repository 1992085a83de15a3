/* The profile of a table (po_profile_table.h). */
#include <math.h>
#include <string.h>

#include "po_dd.h"
#include "po_elementary.h"
#include "po_hermite.h"
#include "po_order.h"
#include "po_profile_kind.h"
#include "po_profile_table.h"
#include "po_root.h"

/* The interval of a radius; the last one beyond the end. Most rows are at equal distances: there it
 * is where they would put it. */
static size_t interval_of(const po_profile_table *t, double r) {
  const size_t last = t->rows - 1;
  const double place = r / t->r[last] * (double)last;
  const size_t k = place < (double)last ? (size_t)place : last - 1;
  return t->r[k] <= r && r < t->r[k + 1] ? k : po_order_last_up_to(t->r, last, r);
}

static double gap(const po_profile *profile, double r) {
  const po_profile_table *t = profile->table;
  const size_t last = t->rows - 1;
  if (r > t->r[last])
    return t->gap[last] * po_pow(r / t->r[last], t->growth);
  const size_t k = interval_of(t, r);
  return po_hermite_value(t->gap[k], t->slope[k], t->gap[k + 1], t->slope[k + 1], r - t->r[k],
                          t->r[k + 1] - t->r[k]);
}

static double slope(const po_profile *profile, double r) {
  const po_profile_table *t = profile->table;
  if (r > t->r[t->rows - 1])
    return t->growth * gap(profile, r) / r;
  const size_t k = interval_of(t, r);
  return po_hermite_rate(t->gap[k], t->slope[k], t->gap[k + 1], t->slope[k + 1], r - t->r[k],
                         t->r[k + 1] - t->r[k]);
}

/* y^2 (gap + x (2 gap + rise)) */
static po_dd part_of(double gap, po_dd rise, po_dd x, po_dd y) {
  const po_dd sum = po_dd_multiply(x, po_dd_add(po_dd_of(2.0 * gap), rise));
  return po_dd_multiply(po_dd_multiply(y, y), po_dd_add(po_dd_of(gap), sum));
}

/* The rows are doubles; their spline is evaluated in twice the precision. With x + y = 1
 *
 *   gap = y^2 (g0 + x (2 g0 + h s0)) + x^2 (g1 + y (2 g1 - h s1)) */
static po_dd gap_exact(const po_profile *profile, double r) {
  const po_profile_table *t = profile->table;
  const size_t last = t->rows - 1;
  if (r > t->r[last])
    return po_dd_times(
        po_dd_pow(po_dd_divide(po_dd_of(r), po_dd_of(t->r[last])), po_dd_of(t->growth)),
        t->gap[last]);
  const size_t k = interval_of(t, r);
  const po_dd h = po_dd_sum(t->r[k + 1], -t->r[k]), x = po_dd_divide(po_dd_sum(r, -t->r[k]), h),
              y = po_dd_subtract(po_dd_of(1.0), x);
  const po_dd left = part_of(t->gap[k], po_dd_times(h, t->slope[k]), x, y),
              right = part_of(t->gap[k + 1], po_dd_times(h, -t->slope[k + 1]), y, x);
  return po_dd_add(left, right);
}

static double gap_beyond(const po_profile *profile, double r) {
  const po_profile_table *t = profile->table;
  const size_t last = t->rows - 1;
  if (r >= t->r[last])
    return gap(profile, r);
  const size_t k = interval_of(t, r);
  return isinf(t->detail) ? gap(profile, r) : fmin(t->beyond[k], t->beyond[k + 1]);
}

typedef struct {
  const po_profile *profile;
  double gap;
} level;

static double above(double r, const void *data) {
  const level *l = data;
  return gap(l->profile, r) - l->gap;
}

/* A table need not rise everywhere: the interval sought begins at the last row that is not above
 * the gap. */
static double radius_of_gap(const po_profile *profile, double sought) {
  const po_profile_table *t = profile->table;
  const size_t last = t->rows - 1;
  if (t->gap[last] <= sought)
    return t->r[last] * po_pow(sought / t->gap[last], 1.0 / t->growth);
  if (t->least[0] > sought)
    return 0.0;
  const size_t k = po_order_last_up_to(t->least, t->rows, sought);
  const level l = {profile, sought};
  return po_root(above, &l, t->r[k], t->r[k + 1]);
}

static double next_joint(const po_profile *profile, double r) {
  const po_profile_table *t = profile->table;
  return r < t->r[t->rows - 1] ? t->r[interval_of(t, r) + 1] : INFINITY;
}

static void shape(const po_profile *profile, po_shape *of) {
  const po_profile_table *t = profile->table;
  of->growth = t->growth;
  of->end = t->r[t->rows - 1];
  of->detail = t->detail;
  of->is_convex = t->is_convex;
}

static po_status check(const po_profile *profile) {
  return po_profile_require_positive(profile, PO_TABLE_SCALE);
}

po_status po_profile_table_noise(const po_profile_table *t, size_t count,
                                 const po_gap_weight *weights, double *deviation, double *change) {
  double *const by_gap = change, *const by_slope = change + t->rows;
  const size_t last = t->rows - 1;
  memset(change, 0, 2 * t->rows * sizeof *change);
  for (size_t i = 0; i < count; ++i) {
    const double r = weights[i].r, weight = weights[i].weight, ratio = r / t->r[last];
    if (ratio >= 1.0) { /* gap (r/end)^(end slope/gap) */
      const double power = weight * po_pow(ratio, t->growth), log = po_log(ratio);
      by_gap[last] += power * (1.0 - t->growth * log);
      by_gap[0] -= power * (1.0 - t->growth * log);
      by_slope[last] += power * t->r[last] * log;
      continue;
    }
    const size_t k = interval_of(t, r);
    const po_hermite w = po_hermite_at(r - t->r[k], t->r[k + 1] - t->r[k]);
    by_gap[k] += weight * w.f0;
    by_gap[k + 1] += weight * w.f1;
    by_slope[k] += weight * w.d0;
    by_slope[k + 1] += weight * w.d1;
    by_gap[0] -= weight;
  }
  return po_smoothing_deviation(&t->smoothing, by_gap, by_slope, deviation);
}

const po_profile_kind PO_TABLE = {.name = "table",
                                  .parameters = 2,
                                  .first = PO_TABLE_SCALE,
                                  .check = check,
                                  .gap = gap,
                                  .slope = slope,
                                  .gap_exact = gap_exact,
                                  .gap_beyond = gap_beyond,
                                  .radius_of_gap = radius_of_gap,
                                  .shape = shape,
                                  .next_joint = next_joint};
