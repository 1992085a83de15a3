#include "po_result.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const KINDS[] = {[PO_JUMP_IN] = "jump_in",
                                    [PO_JUMP_OUT] = "jump_out",
                                    [PO_MINIMUM] = "minimum",
                                    [PO_MAXIMUM] = "maximum"};

const char *po_special_kind_name(po_special_kind kind) {
  return KINDS[kind];
}

po_result po_result_none(void) {
  const po_pressed unknown = {(double)NAN, (double)NAN};
  return (po_result){.status = PO_OK,
                     .start = NAN,
                     .ended = {.approach = NAN, .load = NAN},
                     .profile_approach = NAN,
                     .pull_off = {.pressed = unknown, .until = unknown},
                     .pull_off_any = {.pressed = unknown, .searched = unknown},
                     .diagnostics = {.residual = NAN,
                                     .rounding = NAN,
                                     .energy_defect = NAN,
                                     .energy_defect_at = NAN,
                                     .reverse_trace = {.excess = NAN},
                                     .moved = {.change = NAN, .excess = NAN, .predicted = NAN}}};
}

static const char *const CAUSES[] = {
    [PO_END_NONE] = "none",         [PO_END_COMPRESSED] = "compressed",
    [PO_END_PRELOAD] = "preload",   [PO_END_COMPLETE] = "complete",
    [PO_END_SEARCHED] = "searched", [PO_END_ASKED] = "approach_end"};

const char *po_end_cause_name(po_end_cause cause) {
  return CAUSES[cause];
}

bool po_end_cause_find(const char *name, po_end_cause *cause) {
  for (size_t k = 0; name && k < sizeof CAUSES / sizeof *CAUSES; ++k)
    if (strcmp(name, CAUSES[k]) == 0) {
      *cause = (po_end_cause)k;
      return true;
    }
  return false;
}

void po_contact_annuli_clear(po_contact_annuli *a) {
  free(a->compressed);
  free(a->held);
  *a = (po_contact_annuli){NULL, NULL, 0, 0};
}

void po_result_clear(po_result *result) {
  free(result->folds);
  free(result->extrema);
  free(result->curve);
  free(result->profile);
  po_contact_annuli_clear(&result->annuli);
  po_hysteresis_clear(&result->hysteresis);
  po_staircase_clear(&result->staircase[0]);
  po_staircase_clear(&result->staircase[1]);
  po_hysteresis_clear(&result->theory.hysteresis);
  po_staircase_clear(&result->theory.staircase[0]);
  po_staircase_clear(&result->theory.staircase[1]);
  free(result->diagnostics.states);
  *result = po_result_none();
}
