#include "po_check.h"

#include <math.h>
#include <string.h>

#include "po_input.h"

static const char *const QUANTITIES[PO_QUANTITY_COUNT] = {
    [PO_PULL_OFF_FORCE] = "pull_off_force",
    [PO_PULL_OFF_APPROACH] = "pull_off_approach",
    [PO_CONTACT_RADIUS] = "contact_radius",
    [PO_HYSTERESIS_FORCE] = "hysteresis_force",
    [PO_HYSTERESIS_APPROACH] = "hysteresis_approach",
    [PO_HYSTERESIS_LOSS] = "hysteresis_loss",
    [PO_JUMPS] = "jumps",
    [PO_PULL_OFF_ANY] = "pull_off_any",
    [PO_STEPS] = "steps",
    [PO_LOAD_STEPS] = "load_steps",
    [PO_FOLD_COUNT] = "fold_count",
    [PO_FOLDS] = "folds",
    [PO_EXTREMA] = "extrema",
    [PO_CURVE] = "curve",
    [PO_RESIDUAL] = "residual",
    [PO_MOVED_FORCE] = "moved_force",
    [PO_ENERGY_DEFECT] = "energy_defect",
    [PO_REVERSE_TRACE] = "reverse_trace",
    [PO_WORK] = "work",
    [PO_SOLVED_SHARE] = "solved_share",
};

static const char *const KINDS[] = {"abs", "rel", "ulp"};

const char *po_quantity_name(po_quantity quantity) {
  return QUANTITIES[quantity];
}

int po_quantity_of_name(const char *name) {
  int quantity = 0;
  while (quantity < PO_QUANTITY_COUNT && strcmp(name, QUANTITIES[quantity]) != 0)
    ++quantity;
  return quantity;
}

bool po_quantity_is_pull_off(po_quantity quantity) {
  return quantity == PO_PULL_OFF_FORCE || quantity == PO_PULL_OFF_APPROACH ||
         quantity == PO_CONTACT_RADIUS;
}

bool po_quantity_is_diagnostic(po_quantity quantity) {
  return quantity == PO_RESIDUAL || quantity == PO_MOVED_FORCE || quantity == PO_ENERGY_DEFECT ||
         quantity == PO_REVERSE_TRACE;
}

bool po_quantity_is_hysteresis(po_quantity quantity) {
  return quantity == PO_HYSTERESIS_FORCE || quantity == PO_HYSTERESIS_APPROACH ||
         quantity == PO_HYSTERESIS_LOSS || quantity == PO_JUMPS;
}

bool po_quantity_is_preload(po_quantity quantity) {
  return quantity == PO_PULL_OFF_ANY || po_quantity_is_steps(quantity);
}

bool po_quantity_is_steps(po_quantity quantity) {
  return quantity == PO_STEPS || quantity == PO_LOAD_STEPS;
}

const char *po_tolerance_kind_name(po_tolerance_kind kind) {
  return KINDS[kind];
}

bool po_check_concerns(const po_check *check, const po_request *request) {
  return po_axes_hold(check->when, check->when_count, request);
}

po_request po_check_request(const po_check *check, const po_request *request) {
  po_request changed = *request;
  for (unsigned i = 0; i < check->as_if_count; ++i)
    po_key_set(&changed, (po_key)po_key_of_name(check->as_if[i].key), check->as_if[i].values[0]);
  return changed;
}

po_reference_type po_reference_type_of(const char *reference) {
  static const struct {
    const char *word;
    po_reference_type type;
  } WORDS[] = {{"bradley", PO_REFERENCE_BRADLEY},
               {"pin", PO_REFERENCE_PINS},
               {"zero", PO_REFERENCE_ZERO},
               {"every_scene", PO_REFERENCE_EVERY_SCENE},
               {"traced", PO_REFERENCE_TRACED}};
  for (size_t i = 0; i < sizeof WORDS / sizeof *WORDS; ++i)
    if (strcmp(reference, WORDS[i].word) == 0)
      return WORDS[i].type;
  return PO_REFERENCE_TABLE;
}

bool po_check_is_pin(const po_check *check) {
  return po_reference_type_of(check->reference) == PO_REFERENCE_PINS;
}

bool po_check_is_traced(const po_check *check) {
  return po_reference_type_of(check->reference) == PO_REFERENCE_TRACED;
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
