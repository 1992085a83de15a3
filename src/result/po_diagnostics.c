#include "po_diagnostics.h"

#include <float.h>
#include <math.h>

#include "po_elementary.h"

const char *po_kept_name(po_kept_kind kind) {
  static const char *const NAMES[] = {[PO_KEPT_START] = "start",
                                      [PO_KEPT_FOLD] = "fold",
                                      [PO_KEPT_PULL_OFF] = "pull_off",
                                      [PO_KEPT_END] = "end"};
  return NAMES[kind];
}

double po_digits_left(double change) {
  return isnan(change) ? change : -po_log10(fmax(fabs(change), 0.5 * DBL_EPSILON));
}
