/* A trace on a mesh that stays. */
#ifndef TRACE_H
#define TRACE_H

#include "po_continuation.h"

static inline po_status trace_fixed(po_equilibrium *e, const po_continuation_options *options) {
  po_continuation *c = NULL;
  po_status status = po_continuation_create(e, (po_allowance){0.0, 0.0}, options, &c);
  if (!status)
    status = po_continuation_run(c);
  po_continuation_destroy(c);
  return status;
}

#endif
