#include "po_diagnose.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_deadline.h"
#include "po_diagnosis.h"
#include "po_memory.h"

enum { START, PULL_OFF, END, FIRST_FOLD };

static po_status keep(po_kept_state *state, po_kept_kind kind, const po_branch_point *p) {
  double *node = po_resize(state->node, p->n, sizeof *node);
  if (node)
    state->node = node;
  double *gap = po_resize(state->gap, p->n, sizeof *gap);
  if (gap)
    state->gap = gap;
  if (!node || !gap)
    return PO_NO_MEMORY;
  state->kind = kind;
  state->approach = p->approach;
  state->load = p->load;
  state->n = p->n;
  memcpy(node, p->node, p->n * sizeof *node);
  memcpy(gap, p->gap, p->n * sizeof *gap);
  return PO_OK;
}

po_status po_kept_note(po_kept *kept, const po_branch_point *p, bool deepest) {
  if (!p->gap) /* rigid: nothing was solved */
    return PO_OK;
  po_status status = keep(&kept->states[END], PO_KEPT_END, p);
  if (!status && !kept->states[START].n)
    status = keep(&kept->states[START], PO_KEPT_START, p);
  if (!status && deepest)
    status = keep(&kept->states[PULL_OFF], PO_KEPT_PULL_OFF, p);
  const bool fold = p->kind == PO_POINT_APPROACH_MAX || p->kind == PO_POINT_APPROACH_MIN;
  if (!status && fold && kept->folds < PO_KEPT_FOLDS)
    status = keep(&kept->states[FIRST_FOLD + kept->folds++], PO_KEPT_FOLD, p);
  return status;
}

void po_kept_clear(po_kept *kept) {
  for (size_t k = 0; k < PO_MOST_KEPT; ++k) {
    free(kept->states[k].node);
    free(kept->states[k].gap);
  }
  free(kept->out.list);
  free(kept->back.list);
  *kept = (po_kept){0};
}

/* The complete state of a kept one, on its own mesh. Returned: state, with memory for capacity + 1
 * values. */
static po_status restore(const po_kept_state *kept, po_equilibrium *e, double *state) {
  po_status status = PO_OK;
  if (po_surface_panels(e->surface)) {
    po_panels *const panels = e->surface->draft;
    status = po_surface_panels_of(e->surface, kept->n, kept->node, panels);
    if (!status)
      status = po_surface_mesh(e->surface, panels);
    if (!status)
      po_equilibrium_remesh(e);
  }
  if (status)
    return status;
  memcpy(state, kept->gap, kept->n * sizeof *state);
  state[e->n] = kept->approach;
  return po_diagnosis_complete(e, kept->n, state);
}

static po_status diagnose(const po_kept_state *kept, po_equilibrium *e, double *state,
                          po_diagnostics *d) {
  po_diagnosed_state *made = &d->states[d->state_count];
  po_status status = restore(kept, e, state);
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

po_status po_diagnose_states(const po_request *request, const po_kept *kept, po_equilibrium *e,
                             po_result *result) {
  po_diagnostics *d = &result->diagnostics;
  const double begin = po_clock_wall();
  double *state = po_allocate(e->surface->capacity + 1, sizeof *state);
  d->states = po_allocate(PO_MOST_KEPT, sizeof *d->states);
  po_status status = state && d->states ? PO_OK : PO_NO_MEMORY;
  for (size_t k = 0; !status && k < PO_MOST_KEPT; ++k) {
    if (!kept->states[k].n)
      continue;
    status = po_deadline_check();
    if (status == PO_OUT_OF_TIME)
      status = po_diagnose_out_of_time(request, "not every state is diagnosed");
    if (status)
      break;
    const po_status made = diagnose(&kept->states[k], e, state, d);
    d->undiagnosed += made ? 1 : 0;
    status = made == PO_NO_MEMORY ? made : PO_OK;
  }
  free(state);
  d->seconds += po_clock_wall() - begin;
  return status;
}

/* Comparison of the forward trace with the reverse trace. The reverse trace must find the special
 * points of the forward trace in the opposite order. Its steps and meshes are different, so that a
 * difference shows that one of the traces passed over a fold or changed to another branch. */

static bool is_fold(const po_special_point *point) {
  return point->kind == PO_JUMP_IN || point->kind == PO_JUMP_OUT;
}

po_status po_passage_note(po_passage *passage, const po_special_point *point, int modes,
                          bool back) {
  const int before = passage->modes;
  passage->modes = modes;
  ++passage->points;
  if (!point)
    return PO_OK;
  po_special_point *list = po_grow(passage->list, passage->count, &passage->room, sizeof *list);
  if (!list)
    return PO_NO_MEMORY;
  passage->list = list;
  list[passage->count] = *point;
  list[passage->count++].unstable_modes = back ? before : modes;
  return PO_OK;
}

static void compare_special_point(const po_special_point *out, const po_special_point *back,
                                  po_reverse_trace *way) {
  const double approach = fabs(out->approach - back->approach), load = fabs(out->load - back->load);
  double *const approaches = is_fold(out) ? &way->fold_approach : &way->extremum_approach;
  double *const loads = is_fold(out) ? &way->fold_load : &way->extremum_load;
  *approaches = fmax(*approaches, approach);
  *loads = fmax(*loads, load);
  if (!is_fold(out))
    return;
  const double parts = fmax(approach / (out->approach_error + back->approach_error),
                            load / (out->load_error + back->load_error));
  if (!(parts <= way->excess)) /* NaN stays */
    way->excess = isnan(way->excess) ? way->excess : parts;
}

po_reverse_trace po_reverse_trace_compare(const po_kept *kept, po_status status) {
  const po_passage *out = &kept->out, *back = &kept->back;
  po_reverse_trace way = {.made = true, .status = status, .points = back->points};
  if (status)
    snprintf(way.reason, sizeof way.reason, "%s",
             *po_message() ? po_message() : po_status_text(status));
  for (size_t k = 0; k < back->count; ++k)
    ++*(is_fold(&back->list[k]) ? &way.folds : &way.extrema);
  way.same = !status && out->count == back->count && back->modes == 0;
  for (size_t k = 0; way.same && k < out->count; ++k) {
    const po_special_point *a = &out->list[k], *b = &back->list[out->count - 1 - k];
    way.same = a->kind == b->kind && a->unstable_modes == b->unstable_modes;
    compare_special_point(a, b, &way);
  }
  if (!way.same)
    way.fold_approach = way.fold_load = way.extremum_approach = way.extremum_load = way.excess =
        NAN;
  return way;
}
