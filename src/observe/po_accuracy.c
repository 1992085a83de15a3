#include <math.h>

#include "po_observe_parts.h"

/* Allowed error of the gap, eps, divided by the square root of the relative tolerance of the
 * pull-off force, and its greatest value at any tolerance. The square root, because the error of
 * the load goes as the square of the last Legendre coefficients. Chosen for the smooth sphere
 * (tests/unit/test_panels.c). Where the curve is steeper or the contact edge sharper, the panel
 * itself asks for less (RIPPLE in po_resolution.c). */
static const double ERROR_OF_TOLERANCE = 0.3, COARSEST_ERROR = 3e-4;
/* Allowed error of the load of a panel, divided by the tolerance. The estimate of this error is
 * usually too large. */
static const double LOAD_OF_TOLERANCE = 30.0;

/* Precision of Newton's method, relative to 1 + H, divided by the tolerance; and its greatest
 * value, which the location of folds requires. */
static const double PRECISION_OF_TOLERANCE = 1e-4, COARSEST_PRECISION = 1e-9;

po_allowance po_observe_allowance(double tolerance) {
  return (po_allowance){fmin(COARSEST_ERROR, ERROR_OF_TOLERANCE * sqrt(tolerance)),
                        fmin(COARSEST_ERROR, LOAD_OF_TOLERANCE * tolerance)};
}

double po_observe_precision(double tolerance) {
  return fmax(PO_FINEST_PRECISION, fmin(COARSEST_PRECISION, PRECISION_OF_TOLERANCE * tolerance));
}
