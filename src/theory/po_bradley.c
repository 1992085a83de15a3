#include "po_bradley.h"

#include <math.h>

double po_bradley_load(double approach) {
  if (!(approach < 1.0))
    return NAN;
  const double x = 1.0 / (1.0 - approach), x2 = x * x;
  return -2.0 / 3.0 * x2 * (4.0 - x2 * x2 * x2);
}
