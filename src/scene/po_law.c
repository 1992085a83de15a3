#include "po_law.h"

#include <math.h>

const double PO_LAW_PEAK_GAP = 0.20093695517600277; /* 3^(1/6) - 1 */

po_law po_law_at(double gap) {
  const double x = 1.0 / (1.0 + gap), x3 = x * x * x, x9 = x3 * x3 * x3;
  return (po_law){.traction = -8.0 / 3.0 * (x3 - x9), .slope = 8.0 * x * (x3 - 3.0 * x9)};
}

/* The highest Legendre polynomial that the slope of the averaged law contains: P_9. */
enum { DEGREE = 9 };

/* The Legendre polynomials P_0 to P_9 at z >= 1, where the upward recurrence is stable. */
static void fill_legendre(double z, double legendre[DEGREE + 1]) {
  legendre[0] = 1.0;
  legendre[1] = z;
  for (int n = 1; n < DEGREE; ++n)
    legendre[n + 1] = ((2 * n + 1) * z * legendre[n] - n * legendre[n - 1]) / (n + 1);
}

po_law po_law_averaged(double gap, double amplitude) {
  const double a = 1.0 + gap, y = 1.0 / sqrt((a - amplitude) * (a + amplitude));
  double legendre[DEGREE + 1];
  fill_legendre(a * y, legendre);
  const double y3 = y * y * y, y9 = y3 * y3 * y3;
  return (po_law){.traction = -8.0 / 3.0 * (y3 * legendre[2] - y9 * legendre[8]),
                  .slope = 8.0 * y * (y3 * legendre[3] - 3.0 * y9 * legendre[9])};
}

double po_law_energy(double gap) {
  const double x = 1.0 / (1.0 + gap), x2 = x * x;
  return -4.0 / 3.0 * x2 + x2 * x2 * x2 * x2 / 3.0;
}

double po_law_energy_averaged(double gap, double amplitude) {
  const double a = 1.0 + gap, y = 1.0 / sqrt((a - amplitude) * (a + amplitude)), y2 = y * y;
  double legendre[DEGREE + 1];
  fill_legendre(a * y, legendre);
  return -4.0 / 3.0 * y2 * legendre[1] + y2 * y2 * y2 * y2 * legendre[7] / 3.0;
}
