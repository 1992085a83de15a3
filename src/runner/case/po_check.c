#include "po_check.h"

#include <math.h>
#include <string.h>

#include "po_input.h"

// clang-format off
#define LOOP "hysteresis.displacement_control."
const po_quantity_row PO_QUANTITIES[PO_QUANTITY_COUNT] = {
  [PO_PULL_OFF_FORCE] = {"pull_off_force", "pull_off.force", "force", PO_OF_PULL_OFF},
  [PO_PULL_OFF_APPROACH] = {"pull_off_approach", "pull_off.approach", "approach", PO_OF_PULL_OFF},
  [PO_CONTACT_RADIUS] = {"contact_radius", "pull_off.contact_radius", "contact_radius", PO_OF_PULL_OFF},
  [PO_PULL_OFF_UNCERTAINTY] = {"pull_off_uncertainty", "uncertainty.force", "standard_uncertainty", PO_OF_INPUTS},
  [PO_HYSTERESIS_FORCE] = {"hysteresis_force", LOOP "pull_off.force", "force", PO_OF_LOOP},
  [PO_HYSTERESIS_APPROACH] = {"hysteresis_approach", LOOP "pull_off.approach", "approach", PO_OF_LOOP},
  [PO_HYSTERESIS_LOSS] = {"hysteresis_loss", LOOP "energy_lost", "energy_lost", PO_OF_LOOP},
  [PO_JUMPS] = {"jumps", "", "approach", PO_OF_LOOP},
  [PO_PULL_OFF_ANY] = {"pull_off_any", "pull_off_any.force", "force", PO_OF_STAIRCASE},
  [PO_STEPS] = {"steps", "", "approach", PO_OF_STAIRCASE},
  [PO_LOAD_STEPS] = {"load_steps", "", "approach", PO_OF_STAIRCASE},
  [PO_FOLD_COUNT] = {"fold_count", "folds", "approach", PO_OF_BRANCH},
  [PO_FOLDS] = {"folds", "", "approach", PO_OF_BRANCH},
  [PO_EXTREMA] = {"extrema", "", "approach", PO_OF_BRANCH},
  [PO_CURVE] = {"curve", "", "approach", PO_OF_BRANCH},
  [PO_RESIDUAL] = {"residual", "diagnostics.residual", "approach", PO_OF_DIAGNOSTICS},
  [PO_MOVED_FORCE] = {"moved_force", "diagnostics.moved.force_excess", "approach", PO_OF_DIAGNOSTICS},
  [PO_ENERGY_DEFECT] = {"energy_defect", "diagnostics.energy_defect", "approach", PO_OF_DIAGNOSTICS},
  [PO_REVERSE_TRACE] = {"reverse_trace", "diagnostics.reverse_trace.excess", "approach", PO_OF_DIAGNOSTICS},
  [PO_SOLVED_SHARE] = {"solved_share", "", "approach", PO_OF_SOLVE},
};
// clang-format on

int po_quantity_of_name(const char *name) {
  int quantity = 0;
  while (quantity < PO_QUANTITY_COUNT && strcmp(name, PO_QUANTITIES[quantity].name) != 0)
    ++quantity;
  return quantity;
}

bool po_quantity_is(po_quantity quantity, po_quantity_family family) {
  return PO_QUANTITIES[quantity].family == family;
}

bool po_quantity_is_steps(po_quantity quantity) {
  return quantity == PO_JUMPS || quantity == PO_STEPS || quantity == PO_LOAD_STEPS;
}

bool po_check_concerns(const po_check *check, const po_request *request) {
  return po_axes_hold(check->when, check->when_count, request);
}

po_request po_check_request(const po_check *check, const po_request *request) {
  po_request changed = *request;
  for (unsigned i = 0; i < check->as_if_count; ++i)
    po_key_set(&changed, po_key_of_name(check->as_if[i].key), check->as_if[i].values[0]);
  return changed;
}

po_reference_type po_reference_type_of(const char *reference) {
  static const char *const WORDS[] = {[PO_REFERENCE_BRADLEY] = "bradley",
                                      [PO_REFERENCE_ZERO] = "zero",
                                      [PO_REFERENCE_EVERY_SCENE] = "every_scene",
                                      [PO_REFERENCE_TRACED] = "traced"};
  for (int type = PO_REFERENCE_BRADLEY; type <= PO_REFERENCE_TRACED; ++type)
    if (strcmp(reference, WORDS[type]) == 0)
      return (po_reference_type)type;
  return PO_REFERENCE_TABLE;
}

double po_check_allowance(const po_check *check, double expected) {
  switch (check->kind) {
  case PO_TOLERANCE_REL:
    return check->tolerance * fabs(expected);
  case PO_TOLERANCE_ULP:
    return check->tolerance * (nextafter(fabs(expected), (double)INFINITY) - fabs(expected));
  default:
    return check->tolerance;
  }
}
