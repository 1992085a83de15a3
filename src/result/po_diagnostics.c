#include "po_diagnostics.h"

#include <float.h>
#include <math.h>

#include "po_elementary.h"

double po_digits_left(double change) {
  return isnan(change) ? change : -po_log10(fmax(fabs(change), 0.5 * DBL_EPSILON));
}
