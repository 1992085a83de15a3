/* Lennard-Jones between half-spaces, Eq 9, in the variables of Eqs 14 and 16. */
#include <math.h>

#include "po_law_kind.h"

/* p = -(8/3) [x^3 - x^9], x = 1/(1 + H): Eq 16; dp/dH = 8 [x^4 - 3 x^10] */
static po_law_value at(const po_law *law, double gap) {
  (void)law;
  const double x = 1.0 / (1.0 + gap), x3 = x * x * x, x9 = x3 * x3 * x3;
  return (po_law_value){.traction = -8.0 / 3.0 * (x3 - x9), .slope = 8.0 * x * (x3 - 3.0 * x9)};
}

static po_dd traction(const po_law *law, double gap) {
  (void)law;
  const po_dd x = po_dd_divide(po_dd_of(1.0), po_dd_sum(1.0, gap)),
              x3 = po_dd_multiply(x, po_dd_multiply(x, x)),
              x9 = po_dd_multiply(x3, po_dd_multiply(x3, x3));
  return po_dd_divide(po_dd_times(po_dd_subtract(x9, x3), 8.0), po_dd_of(3.0));
}

/* phi / w = -(4/3) x^2 + (1/3) x^8 with phi' = -sigma (Eq 9). */
static double energy(const po_law *law, double gap) {
  (void)law;
  const double x = 1.0 / (1.0 + gap), x2 = x * x;
  return -4.0 / 3.0 * x2 + x2 * x2 * x2 * x2 / 3.0;
}

enum { DEGREE = 9 };

/* Legendre polynomials at z >= 1, where their recurrence is stable upwards. */
static void fill_legendre(double z, double legendre[DEGREE + 1]) {
  legendre[0] = 1.0;
  legendre[1] = z;
  for (int n = 1; n < DEGREE; ++n)
    legendre[n + 1] = ((2 * n + 1) * z * legendre[n] - n * legendre[n - 1]) / (n + 1);
}

/* In closed form, since the mean of (a - A cos phi)^-n is (a^2 - A^2)^(-n/2)
 * P_{n-1}(a / sqrt(a^2 - A^2)) (Laplace's integral for Legendre polynomials). */
static po_law_value averaged(const po_law *law, double gap, double amplitude) {
  (void)law;
  const double a = 1.0 + gap, y = 1.0 / sqrt((a - amplitude) * (a + amplitude));
  double legendre[DEGREE + 1];
  fill_legendre(a * y, legendre);
  const double y3 = y * y * y, y9 = y3 * y3 * y3;
  return (po_law_value){.traction = -8.0 / 3.0 * (y3 * legendre[2] - y9 * legendre[8]),
                        .slope = 8.0 * y * (y3 * legendre[3] - 3.0 * y9 * legendre[9])};
}

static double energy_averaged(const po_law *law, double gap, double amplitude) {
  (void)law;
  const double a = 1.0 + gap, y = 1.0 / sqrt((a - amplitude) * (a + amplitude)), y2 = y * y;
  double legendre[DEGREE + 1];
  fill_legendre(a * y, legendre);
  return -4.0 / 3.0 * y2 * legendre[1] + y2 * y2 * y2 * y2 * legendre[7] / 3.0;
}

/* phi^2 */
static po_law_closeness closeness(const po_law *law, double gap) {
  (void)law;
  const double x = 1.0 / (1.0 + gap), x2 = x * x, x6 = x2 * x2 * x2;
  const double energy = x2 * (4.0 - x6) / 3.0, traction = -8.0 / 3.0 * x * x2 * (1.0 - x6);
  return (po_law_closeness){energy * energy, 2.0 * energy * traction};
}

/* The repulsive term of Eq 23, 2/(3 x^8). */
static double approach_of_push(double share, double load) {
  return 1.0 - sqrt(sqrt(sqrt(2.0 * share / (3.0 * load))));
}

const po_law_kind PO_LENNARD_JONES = {.name = "lennard-jones",
                                      .numbers = {PO_GAPS_OF_POWERS,
                                                  .peak_gap = 0.20093695517600277, /* 3^(1/6) - 1 */
                                                  .factor = 8.0 / 3.0, .exponent = 3.0},
                                      .at = at,
                                      .traction = traction,
                                      .energy = energy,
                                      .averaged = averaged,
                                      .energy_averaged = energy_averaged,
                                      .closeness = closeness,
                                      .approach_of_push = approach_of_push};
