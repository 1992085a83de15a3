#include "po_special_list.h"

#include <math.h>

#include "po_memory.h"

static po_special_kind kind_of(po_point_kind kind) {
  switch (kind) {
  case PO_POINT_APPROACH_MAX:
    return PO_JUMP_IN;
  case PO_POINT_APPROACH_MIN:
    return PO_JUMP_OUT;
  case PO_POINT_LOAD_MAX:
    return PO_MAXIMUM;
  default:
    return PO_MINIMUM;
  }
}

po_special_list po_special_list_begin(void) {
  return (po_special_list){.greatest = {.traced_approach_error = NAN,
                                        .traced_load_error = NAN,
                                        .traced_energy_error = NAN}};
}

/* fmax ignores NAN. */
static void note_errors(po_estimate *greatest, const po_estimate *e) {
  greatest->traced_approach_error = fmax(greatest->traced_approach_error, e->traced_approach_error);
  greatest->traced_load_error = fmax(greatest->traced_load_error, e->traced_load_error);
  greatest->traced_energy_error = fmax(greatest->traced_energy_error, e->traced_energy_error);
}

po_status po_special_list_add(po_special_list *l, const po_branch_point *p, const po_estimate *e,
                              po_result *o) {
  const po_special_kind kind = kind_of(p->kind);
  const bool fold = kind == PO_JUMP_IN || kind == PO_JUMP_OUT;
  po_special_point **list = fold ? &o->folds : &o->extrema;
  size_t *count = fold ? &o->fold_count : &o->extremum_count;
  l->unmet_folds += fold && p->unmet;
  note_errors(&l->greatest, e);
  po_special_point *grown =
      po_grow(*list, *count, fold ? &l->fold_room : &l->extremum_room, sizeof *grown);
  if (!grown)
    return PO_NO_MEMORY;
  *list = grown;
  grown[(*count)++] = (po_special_point){.kind = kind,
                                         .approach = e->approach,
                                         .load = e->load,
                                         .energy = e->energy,
                                         .energy_error = e->energy_error,
                                         .approach_error = e->approach_error,
                                         .load_error = e->load_error,
                                         .contact_radius = e->edge.radius,
                                         .contact_radius_error = e->edge.error,
                                         .contact_radius_other = e->edge.other,
                                         .position = p->position,
                                         .unstable_modes = p->unstable_modes};
  return PO_OK;
}

void po_special_list_pull_off(const po_estimate *e, po_result *o) {
  o->has_pull_off = true;
  o->pull_off.force = fabs(e->load);
  o->pull_off.approach = e->approach;
  o->pull_off.contact_radius = e->edge.radius;
  o->pull_off.force_error = e->load_error;
  o->pull_off.far_force_error = e->far_load_error;
  o->pull_off.approach_error = e->approach_error;
  o->pull_off.contact_radius_error = e->edge.error;
  o->pull_off.contact_radius_other = e->edge.other;
}
