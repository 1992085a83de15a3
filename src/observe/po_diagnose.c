#include "po_diagnose.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_clock.h"
#include "po_diagnosis.h"
#include "po_elementary.h"
#include "po_memory.h"

/* The complete state of a kept one, on its own mesh. Returned: state, with memory for capacity + 1
 * values. */
static po_status restore(const po_kept_state *kept, po_equilibrium *e, po_adaptive *adaptive,
                         double *state) {
  po_status status = PO_OK;
  if (adaptive) {
    po_panels *const panels = po_adaptive_draft(adaptive);
    status = po_adaptive_panels_of(adaptive, kept->n, kept->node, panels);
    if (!status)
      status = po_adaptive_mesh(adaptive, panels);
    if (!status)
      po_equilibrium_remesh(e);
  }
  if (status)
    return status;
  memcpy(state, kept->gap, kept->n * sizeof *state);
  state[e->n] = kept->approach;
  return po_diagnosis_complete(e, kept->n, state);
}

static po_status diagnose(const po_kept_state *kept, po_equilibrium *e, po_adaptive *adaptive,
                          double *state, po_diagnostics *d) {
  po_diagnosed_state *made = &d->states[d->state_count];
  po_status status = restore(kept, e, adaptive, state);
  if (!status)
    status = po_diagnosis_make(e, state, &made->found);
  if (!status && kept->kind == PO_KEPT_PULL_OFF)
    status = po_sensitivity_make(e, state, &d->force);
  if (status)
    return status;
  if (kept->kind == PO_KEPT_PULL_OFF) {
    double *const parts[] = {&d->force.tabor,  &d->force.amplitude, &d->force.wavelength,
                             &d->force.radius, &d->force.residual,  &d->force.rounding};
    for (size_t k = 0; k < sizeof parts / sizeof *parts; ++k)
      *parts[k] /= kept->load;
    d->force.rounding = fabs(d->force.rounding);
    d->has_sensitivity = true;
  }
  made->at = kept->kind;
  made->approach = kept->approach;
  made->load = kept->load;
  made->nodes = e->n;
  d->residual = fmax(d->residual, made->found.residual); /* the first is NaN */
  d->rounding = fmax(d->rounding, made->found.rounding);
  ++d->state_count;
  return PO_OK;
}

po_status po_diagnose_out_of_time(const po_request *request, const char *what) {
  return po_fail(PO_OUT_OF_TIME, "after %g s of processor time the branch is traced, but %s",
                 request->time_limit, what);
}

po_status po_diagnose_states(const po_request *request, double deadline, const po_kept *kept,
                             po_equilibrium *e, po_adaptive *adaptive, po_result *result) {
  po_diagnostics *d = &result->diagnostics;
  const double begin = po_clock_wall();
  const size_t capacity = adaptive ? po_adaptive_capacity(adaptive) : e->n;
  double *state = po_allocate(capacity + 1, sizeof *state);
  d->states = po_allocate(PO_MOST_KEPT, sizeof *d->states);
  po_status status = state && d->states ? PO_OK : PO_NO_MEMORY;
  for (size_t k = 0; !status && k < PO_MOST_KEPT; ++k) {
    if (!kept->states[k].n)
      continue;
    if (po_clock_thread() > deadline) {
      status = po_diagnose_out_of_time(request, "not every state is diagnosed");
      break;
    }
    const po_status made = diagnose(&kept->states[k], e, adaptive, state, d);
    d->undiagnosed += made ? 1 : 0;
    status = made == PO_NO_MEMORY ? made : PO_OK;
  }
  free(state);
  d->seconds += po_clock_wall() - begin;
  return status;
}
