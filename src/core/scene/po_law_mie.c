/* The Mie law (m, n), n > m > 1: p = -k (x^m - x^n), x = 1/(1 + H), k = (m - 1)(n - 1)/(n - m),
 * which makes the work of adhesion 1. Its powers need not be whole numbers. */
#include <math.h>

#include "po_dd.h"
#include "po_elementary.h"
#include "po_law_kind.h"

/* Powers beyond are refused: x^n of the closest gaps would overflow. */
static const double LARGEST_POWER = 60.0;

static double small(const po_law *law) {
  return law->parameter[PO_MIE_M];
}
static double large(const po_law *law) {
  return law->parameter[PO_MIE_N];
}
static double factor(const po_law *law) {
  return law->constant;
}

static po_status check(const po_law *law) {
  const double m = small(law), n = large(law);
  if (isnan(m))
    return po_law_require(law, PO_MIE_M);
  if (!(isfinite(m) && m > 1.0))
    return po_fail(PO_BAD_INPUT, "mie_m is %g: expected a finite number > 1", m);
  if (isnan(n))
    return po_law_require(law, PO_MIE_N);
  if (!(isfinite(n) && n > m && n <= LARGEST_POWER))
    return po_fail(PO_BAD_INPUT, "mie_n is %g: expected a number > mie_m, %g, and at most %g", n, m,
                   LARGEST_POWER);
  return PO_OK;
}

static void derive(po_law *law) {
  const double m = small(law), n = large(law);
  law->constant = (m - 1.0) * (n - 1.0) / (n - m);
  law->numbers.peak_gap = po_pow(n / m, 1.0 / (n - m)) - 1.0; /* m x^m = n x^n */
  law->numbers.factor = law->constant;
  law->numbers.exponent = m;
}

static po_law_value at(const po_law *law, double gap) {
  const double x = 1.0 / (1.0 + gap), m = small(law), n = large(law);
  const po_base base = po_base_of(x);
  const double xm = po_power(base, m), xn = po_power(base, n);
  return (po_law_value){.traction = -factor(law) * (xm - xn),
                        .slope = factor(law) * x * (m * xm - n * xn)};
}

static po_dd traction(const po_law *law, double gap) {
  const double m = small(law), n = large(law);
  const po_dd log_x = po_dd_negative(po_dd_log(po_dd_sum(1.0, gap)));
  const po_dd k =
      po_dd_divide(po_dd_multiply(po_dd_sum(m, -1.0), po_dd_sum(n, -1.0)), po_dd_sum(n, -m));
  return po_dd_multiply(
      k, po_dd_subtract(po_dd_exp(po_dd_times(log_x, n)), po_dd_exp(po_dd_times(log_x, m))));
}

static double energy(const po_law *law, double gap) {
  const double x = 1.0 / (1.0 + gap), m = small(law), n = large(law);
  const po_base base = po_base_of(x);
  return -factor(law) * (po_power(base, m - 1.0) / (m - 1.0) - po_power(base, n - 1.0) / (n - 1.0));
}

/* The means over phi of x^p, x^q, x^(p+1) and x^(q+1), x = 1/(a - A cos phi), by the trapezoidal
 * rule, which converges geometrically for a periodic function: points are doubled until nothing
 * changes. */
enum { FIRST_POINTS = 16, MOST_POINTS = 1 << 14 };
static const double SETTLED = 1e-14;
typedef struct {
  double p, q, p1, q1;
} means;

static void add_powers(double a, double weight, double p, double q, means *sum) {
  const double x = 1.0 / a;
  const po_base base = po_base_of(x);
  const double xp = weight * po_power(base, p), xq = weight * po_power(base, q);
  *sum = (means){sum->p + xp, sum->q + xq, sum->p1 + x * xp, sum->q1 + x * xq};
}

static bool is_settled(double mean, double before) {
  return fabs(mean - before) <= SETTLED * mean;
}

static means mean_of_powers(double a, double amplitude, double p, double q) {
  means sum = {0}, before = {NAN, NAN, NAN, NAN};
  for (int points = FIRST_POINTS, step = 1; points <= MOST_POINTS; points *= 2, step = 2) {
    /* half a period holds all values; the first pass takes every point, later ones those between */
    const int half = points / 2;
    for (int k = step == 1 ? 0 : 1; k <= half; k += step)
      add_powers(a - amplitude * po_cospi((double)k / half), k == 0 || k == half ? 1.0 : 2.0, p, q,
                 &sum);
    const means mean = {sum.p / points, sum.q / points, sum.p1 / points, sum.q1 / points};
    const bool settled = is_settled(mean.p, before.p) && is_settled(mean.q, before.q) &&
                         is_settled(mean.p1, before.p1) && is_settled(mean.q1, before.q1);
    before = mean;
    if (settled)
      break;
  }
  return before;
}

static po_law_value averaged(const po_law *law, double gap, double amplitude) {
  const double m = small(law), n = large(law);
  const means of = mean_of_powers(1.0 + gap, amplitude, m, n);
  return (po_law_value){.traction = -factor(law) * (of.p - of.q),
                        .slope = factor(law) * (m * of.p1 - n * of.q1)};
}

static double energy_averaged(const po_law *law, double gap, double amplitude) {
  const double m = small(law), n = large(law);
  const means of = mean_of_powers(1.0 + gap, amplitude, m - 1.0, n - 1.0);
  return -factor(law) * (of.p / (m - 1.0) - of.q / (n - 1.0));
}

static po_law_closeness closeness(const po_law *law, double gap) {
  const double x = 1.0 / (1.0 + gap), m = small(law), n = large(law), g = (m + 1.0) / (m - 1.0);
  const po_base base = po_base_of(x);
  const double xm = po_power(base, m), xn = po_power(base, n);
  const double size = factor(law) * (xm / (m - 1.0) - xn / (n - 1.0)) / x; /* |phi| */
  if (!(size > 0.0))                                                       /* underflow */
    return (po_law_closeness){0.0, 0.0};
  const double value = po_pow(size, g);
  return (po_law_closeness){value, -g * value / size * factor(law) * (xm - xn)};
}

const po_law_kind PO_MIE = {.name = "mie",
                            .parameters = 2,
                            .first = PO_MIE_M,
                            .check = check,
                            .numbers = {PO_GAPS_OF_POWERS},
                            .derive = derive,
                            .at = at,
                            .traction = traction,
                            .energy = energy,
                            .averaged = averaged,
                            .energy_averaged = energy_averaged,
                            .closeness = closeness};
