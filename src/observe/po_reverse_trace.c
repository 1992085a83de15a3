#include "po_reverse_trace.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "po_memory.h"

static bool is_fold(po_point_kind kind) {
  return kind == PO_POINT_APPROACH_MAX || kind == PO_POINT_APPROACH_MIN;
}

static bool is_special_point(po_point_kind kind) {
  return kind != PO_POINT_STEP && kind != PO_POINT_STATION;
}

po_status po_passage_note(po_passage *passage, const po_branch_point *p, double approach_error,
                          double load_error, bool back) {
  const int before = passage->modes;
  passage->modes = p->unstable_modes;
  ++passage->points;
  if (!is_special_point(p->kind))
    return PO_OK;
  po_passed *list = po_grow(passage->list, passage->count, &passage->room, sizeof *list);
  if (!list)
    return PO_NO_MEMORY;
  passage->list = list;
  list[passage->count++] = (po_passed){.kind = p->kind,
                                       .approach = p->approach + p->approach_correction,
                                       .load = p->load + p->load_correction,
                                       .approach_error = approach_error,
                                       .load_error = load_error,
                                       .modes = back ? before : p->unstable_modes};
  return PO_OK;
}

void po_passage_clear(po_passage *passage) {
  free(passage->list);
  *passage = (po_passage){0};
}

static void compare_special_point(const po_passed *out, const po_passed *back,
                                  po_reverse_trace *way) {
  const double approach = fabs(out->approach - back->approach), load = fabs(out->load - back->load);
  double *const approaches = is_fold(out->kind) ? &way->fold_approach : &way->extremum_approach;
  double *const loads = is_fold(out->kind) ? &way->fold_load : &way->extremum_load;
  *approaches = fmax(*approaches, approach);
  *loads = fmax(*loads, load);
  if (!is_fold(out->kind))
    return;
  const double parts = fmax(approach / (out->approach_error + back->approach_error),
                            load / (out->load_error + back->load_error));
  if (!(parts <= way->excess)) /* NaN stays */
    way->excess = isnan(way->excess) ? way->excess : parts;
}

po_reverse_trace po_reverse_trace_compare(const po_passage *out, const po_passage *back,
                                          po_status status) {
  po_reverse_trace way = {.made = true, .status = status, .points = back->points};
  if (status)
    snprintf(way.reason, sizeof way.reason, "%s",
             *po_message() ? po_message() : po_status_text(status));
  for (size_t k = 0; k < back->count; ++k)
    ++*(is_fold(back->list[k].kind) ? &way.folds : &way.extrema);
  way.same = !status && out->count == back->count && back->modes == 0;
  for (size_t k = 0; way.same && k < out->count; ++k) {
    const po_passed *a = &out->list[k], *b = &back->list[out->count - 1 - k];
    way.same = a->kind == b->kind && a->modes == b->modes;
    compare_special_point(a, b, &way);
  }
  if (!way.same)
    way.fold_approach = way.fold_load = way.extremum_approach = way.extremum_load = way.excess =
        NAN;
  return way;
}
