/* The Mie law (m, n), n > m > 1: p = -k (x^m - x^n), x = 1/(1 + H), k = (m - 1)(n - 1)/(n - m),
 * which makes the work of adhesion 1. Its powers need not be whole numbers. */
#include <math.h>

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
  return law->constant[0];
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
  law->constant[0] = (m - 1.0) * (n - 1.0) / (n - m);
}

static po_law_value at(const po_law *law, double gap) {
  const double x = 1.0 / (1.0 + gap), m = small(law), n = large(law);
  const double xm = pow(x, m), xn = pow(x, n);
  return (po_law_value){.traction = -factor(law) * (xm - xn),
                        .slope = factor(law) * x * (m * xm - n * xn)};
}

static long double traction(const po_law *law, long double gap) {
  const long double x = 1.0L / (1.0L + gap), m = small(law), n = large(law);
  const long double k = (m - 1.0L) * (n - 1.0L) / (n - m);
  return -k * (powl(x, m) - powl(x, n));
}

static double energy(const po_law *law, double gap) {
  const double x = 1.0 / (1.0 + gap), m = small(law), n = large(law);
  return -factor(law) * (pow(x, m - 1.0) / (m - 1.0) - pow(x, n - 1.0) / (n - 1.0));
}

/* The mean over phi of (a - A cos phi)^-power by the trapezoidal rule, which converges
 * geometrically for a periodic function: points are doubled until nothing changes. */
enum { FIRST_POINTS = 16, MOST_POINTS = 1 << 14 };
static const double SETTLED = 1e-14;

static double mean_of_power(double a, double amplitude, double power) {
  double sum = 0.0, before = NAN;
  for (int points = FIRST_POINTS, step = 1; points <= MOST_POINTS; points *= 2, step = 2) {
    /* half a period holds all values; the first pass takes every point, later ones those between */
    const int half = points / 2;
    for (int k = step == 1 ? 0 : 1; k <= half; k += step) {
      const double weight = k == 0 || k == half ? 1.0 : 2.0;
      sum += weight * pow(a - amplitude * cos(M_PI * k / half), -power);
    }
    const double mean = sum / points;
    if (fabs(mean - before) <= SETTLED * mean)
      return mean;
    before = mean;
  }
  return before;
}

static po_law_value averaged(const po_law *law, double gap, double amplitude) {
  const double a = 1.0 + gap, m = small(law), n = large(law);
  return (po_law_value){
      .traction = -factor(law) * (mean_of_power(a, amplitude, m) - mean_of_power(a, amplitude, n)),
      .slope = factor(law) * (m * mean_of_power(a, amplitude, m + 1.0) -
                              n * mean_of_power(a, amplitude, n + 1.0))};
}

static double energy_averaged(const po_law *law, double gap, double amplitude) {
  const double a = 1.0 + gap, m = small(law), n = large(law);
  return -factor(law) * (mean_of_power(a, amplitude, m - 1.0) / (m - 1.0) -
                         mean_of_power(a, amplitude, n - 1.0) / (n - 1.0));
}

static po_law_closeness closeness(const po_law *law, double gap) {
  const double x = 1.0 / (1.0 + gap), m = small(law), n = large(law), g = (m + 1.0) / (m - 1.0);
  const double xm = pow(x, m), xn = pow(x, n);
  const double size = factor(law) * (xm / (m - 1.0) - xn / (n - 1.0)) / x; /* |phi| */
  const double value = pow(size, g);
  return (po_law_closeness){value, -g * value / size * factor(law) * (xm - xn)};
}

/* m x^m = n x^n */
static double peak_gap(const po_law *law) {
  return pow(large(law) / small(law), 1.0 / (large(law) - small(law))) - 1.0;
}

static po_law_far far_field(const po_law *law) {
  return (po_law_far){factor(law), small(law)};
}

/* The repulsive part of the load of a rigid paraboloid is 2k/(n - 1) x^(n-1). */
static double approach_of_push(const po_law *law, double share, double load) {
  const double n = large(law);
  return po_law_approach_of_distance(
      pow(2.0 * factor(law) * share / ((n - 1.0) * load), 1.0 / (n - 1.0)));
}

const po_law_kind PO_MIE = {.name = "mie",
                            .parameters = 2,
                            .first = PO_MIE_M,
                            .check = check,
                            .derive = derive,
                            .at = at,
                            .traction = traction,
                            .energy = energy,
                            .averaged = averaged,
                            .energy_averaged = energy_averaged,
                            .scale = po_law_scale_of_powers,
                            .closeness = closeness,
                            .peak_gap = peak_gap,
                            .closest = po_law_closest_of_powers,
                            .least_gap = po_law_least_gap_of_powers,
                            .reach = po_law_reach_of_powers,
                            .far_field = far_field,
                            .approach_of_push = approach_of_push};
