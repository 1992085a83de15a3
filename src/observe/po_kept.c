#include "po_kept.h"

#include <stdlib.h>
#include <string.h>

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
  *kept = (po_kept){0};
}
