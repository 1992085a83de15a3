#include "po_law.h"

#include <math.h>

const double PO_LAW_PEAK_GAP = 0.20093695517600277; /* 3^(1/6) - 1 */

po_law po_law_at(double gap) {
  const double x = 1.0 / (1.0 + gap), x3 = x * x * x, x9 = x3 * x3 * x3;
  return (po_law){.traction = -8.0 / 3.0 * (x3 - x9), .slope = 8.0 * x * (x3 - 3.0 * x9)};
}

po_law po_law_averaged(double gap, double amplitude) {
  enum { DEGREE = 9 };
  const double a = 1.0 + gap, root = sqrt((a - amplitude) * (a + amplitude)), z = a / root;
  double legendre[DEGREE + 1] = {1.0, z};
  for (int n = 1; n < DEGREE; ++n) /* stable upwards for z >= 1 */
    legendre[n + 1] = ((2 * n + 1) * z * legendre[n] - n * legendre[n - 1]) / (n + 1);
  const double y = 1.0 / root, y3 = y * y * y, y9 = y3 * y3 * y3;
  return (po_law){.traction = -8.0 / 3.0 * (y3 * legendre[2] - y9 * legendre[8]),
                  .slope = 8.0 * y * (y3 * legendre[3] - 3.0 * y9 * legendre[9])};
}

double po_law_energy(double gap) {
  const double x = 1.0 / (1.0 + gap), x2 = x * x;
  return -4.0 / 3.0 * x2 + x2 * x2 * x2 * x2 / 3.0;
}
