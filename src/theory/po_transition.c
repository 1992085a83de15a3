#include "po_transition.h"

#include <math.h>

#include "po_elementary.h"

double po_maugis_parameter(double tabor, double tension) {
  return tension * po_cbrt(4.5 / M_PI) * tabor;
}

double po_transition_alpha(double lambda) {
  return -po_expm1(-lambda / 0.924) / 1.02;
}

double po_carpick_force(double lambda) {
  return 2.0 - 0.5 / (1.0 + 1.0 / (4.04 * po_pow(lambda, 1.4))); /* the same, also at infinity */
}

double po_pietrement_force(double lambda) {
  const double alpha = po_transition_alpha(lambda);
  return (0.267 * alpha - 0.767) * alpha + 2.0;
}

double po_schwarz_force(double lambda) {
  const double alpha = po_transition_alpha(lambda);
  return 6.0 / (3.0 + alpha * alpha);
}
