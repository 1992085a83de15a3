/* The Abel transform of a table: piecewise over the cubics of its spline. With r = x cos(theta) the
 * integrands f', (r f')' and r^2 f' are trigonometric polynomials in each piece, which a Gauss rule
 * integrates to rounding. */
#include <math.h>

#include "po_abel_parts.h"
#include "po_elementary.h"
#include "po_quadrature.h"
#include "po_special.h"

/* Points of the Gauss rules and the greatest angles of a piece: the remainders for the third
 * harmonic are 7e-16 of 1 rad with 8 points and 2e-16 of 0.05 rad with 4. */
enum { POINTS = 8, FEW_POINTS = 4 };
static const double GREATEST_ANGLE = 1.0, SMALL_ANGLE = 0.05;

typedef struct {
  double node[POINTS], weight[POINTS], few_node[FEW_POINTS], few_weight[FEW_POINTS];
} rules;

typedef struct {
  double slope, curvature; /* f', f'' */
} derivatives;

/* The derivatives of the cubic of interval k at a distance from its row. */
static derivatives derivatives_at(const po_profile_table *t, size_t k, double distance) {
  const double h = t->r[k + 1] - t->r[k], z = distance / h, s0 = t->slope[k], s1 = t->slope[k + 1];
  const double chord = (t->gap[k + 1] - t->gap[k]) / h;
  return (derivatives){
      s0 * (1.0 - z) * (1.0 - 3.0 * z) + s1 * z * (3.0 * z - 2.0) + 6.0 * chord * z * (1.0 - z),
      (s0 * (6.0 * z - 4.0) + s1 * (6.0 * z - 2.0) + 6.0 * chord * (1.0 - 2.0 * z)) / h};
}

/* Adds the integrals over the angles from `inner` to `outer` of interval k; press over x^2. */
static void add_piece(const po_profile_table *t, const rules *rule, double x, size_t k,
                      double inner, double outer, po_abel *sum) {
  const double whole = outer - inner;
  const int pieces = (int)ceil(whole / GREATEST_ANGLE);
  const bool few = whole < SMALL_ANGLE;
  const int count = few ? FEW_POINTS : POINTS;
  const double *node = few ? rule->few_node : rule->node,
               *weight = few ? rule->few_weight : rule->weight;
  const double angle = whole / pieces;
  for (int i = 0; i < pieces * count; ++i) {
    const double theta = inner + angle * (i / count + node[i % count]), half = po_sin(0.5 * theta);
    const double cosine = 1.0 - 2.0 * half * half;
    const derivatives f = derivatives_at(t, k, (x - t->r[k]) - 2.0 * x * half * half);
    const double part = angle * weight[i % count];
    sum->g += part * f.slope;
    sum->rate += part * (f.slope + x * cosine * f.curvature);
    sum->press += part * cosine * cosine * f.slope;
  }
}

/* acos(r/x) */
static double angle_of(double r, double x) {
  return po_atan2(sqrt((x - r) * (x + r)), r);
}

/* The incomplete integral of sin^(n - 1) over the angles from the last row outwards. */
static double part_beyond(double n, double end, double x) {
  return 0.5 * po_beta_incomplete(0.5, 0.5 * n, (x - end) / x * ((x + end) / x));
}

po_abel po_abel_of_table(const po_profile_table *t, double x) {
  rules rule;
  po_abel sum = {0.0, 0.0, 0.0};
  if (po_gauss_rule(POINTS, rule.node, rule.weight) ||
      po_gauss_rule(FEW_POINTS, rule.few_node, rule.few_weight))
    return (po_abel){NAN, NAN, NAN};
  if (!(x > 0.0))
    return (po_abel){0.0, M_PI_2 * t->slope[0], 0.0};
  const size_t last = t->rows - 1;
  double outer = M_PI_2;
  for (size_t k = 0; k < last && t->r[k] < x; ++k) {
    const double inner = t->r[k + 1] < x ? angle_of(t->r[k + 1], x) : 0.0;
    add_piece(t, &rule, x, k, inner, outer, &sum);
    outer = inner;
  }
  const double end = t->r[last], n = t->growth;
  if (x > end) {
    const double slope = n * t->gap[last] / x * po_pow(x / end, n), part = part_beyond(n, end, x);
    sum.g += slope * part;
    sum.rate += n * slope * part;
    sum.press += slope * part_beyond(n + 2.0, end, x);
  }
  return (po_abel){x * sum.g, sum.rate, x * x * sum.press};
}

/* The extrema of (r f')' in interval k, where it is a parabola: at the ends and between. */
static void widen(const po_profile_table *t, size_t k, double *least, double *most) {
  const double h = t->r[k + 1] - t->r[k];
  double value[3];
  for (int i = 0; i < 3; ++i) {
    const double distance = 0.5 * i * h;
    const derivatives f = derivatives_at(t, k, distance);
    value[i] = f.slope + (t->r[k] + distance) * f.curvature;
    *least = fmin(*least, value[i]);
    *most = fmax(*most, value[i]);
  }
  const double bend = value[0] - 2.0 * value[1] + value[2], tilt = 0.5 * (value[2] - value[0]);
  if (fabs(tilt) < fabs(bend)) {
    const double extremum = value[1] - 0.5 * tilt * tilt / bend;
    *least = fmin(*least, extremum);
    *most = fmax(*most, extremum);
  }
}

double po_abel_table_least_rate(const po_profile_table *t) {
  double least = 0.0, most = 0.0;
  for (size_t k = 0; k + 1 < t->rows; ++k)
    widen(t, k, &least, &most);
  return M_PI_2 * least;
}

double po_abel_table_greatest_rate(const po_profile_table *t, double x) {
  const size_t last = t->rows - 1;
  double least = 0.0, most = 0.0;
  for (size_t k = 0; k < last && t->r[k] < x; ++k)
    widen(t, k, &least, &most);
  if (x > t->r[last]) /* (r f')' = n f' beyond the end */
    most =
        fmax(most, t->growth * t->slope[last] * fmax(1.0, po_pow(x / t->r[last], t->growth - 1.0)));
  return M_PI_2 * most;
}

/* Radii are collected in bins that are longer than the reach: what is less than it apart is in one
 * bin or in two neighbours. */
double po_abel_table_greatest_drop(const po_profile_table *t, double end, double reach) {
  const size_t last = t->rows - 1;
  double before = -INFINITY, here = -INFINITY, begin = 0.0, drop = 0.0;
  for (size_t k = 0; k < last && t->r[k] < end; ++k) {
    double least = INFINITY, most = -INFINITY;
    widen(t, k, &least, &most);
    if (t->r[k] > begin + reach) {
      before = here;
      here = -INFINITY;
      begin = t->r[k];
    }
    here = fmax(here, most);
    drop = fmax(drop, fmax(before, here) - least);
  }
  if (end > t->r[last]) /* n f' beyond the last row */
    drop = t->growth < 1.0 ? INFINITY : fmax(drop, fmax(before, here) - t->growth * t->slope[last]);
  return M_PI_2 * drop;
}

size_t po_abel_table_next(const po_profile_table *t, double x) {
  size_t low = 0, high = t->rows;
  while (low < high) {
    const size_t middle = (low + high) / 2;
    if (t->r[middle] > x)
      high = middle;
    else
      low = middle + 1;
  }
  return low;
}
