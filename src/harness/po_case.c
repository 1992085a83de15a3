#include "po_case.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_case_parse.h"
#include "po_file.h"
#include "po_memory.h"
#include "po_schema.h"
#include "po_text.h"

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

const char *const PO_SUITE_NAMES = "smoke, paper, extreme, precision or random";

unsigned po_suite_of_name(const char *name) {
  static const char *const NAMES[] = {"smoke", "paper", "extreme", "precision", "random"};
  for (unsigned i = 0; i < sizeof NAMES / sizeof *NAMES; ++i)
    if (strcmp(name, NAMES[i]) == 0)
      return 1u << i;
  return 0;
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

bool po_check_is_pin(const po_check *check) {
  return strcmp(check->reference, "pin") == 0;
}

bool po_check_is_traced(const po_check *check) {
  return strcmp(check->reference, PO_TRACED) == 0;
}

const char *po_case_argument(const po_case *kase) {
  return kase->is_own ? kase->shown : kase->file->name;
}

const char *po_case_word(const po_case *kase) {
  return kase->word ? kase->word : kase->file->name;
}

po_status po_case_set_own(po_case *kase) {
  po_text word = {0};
  if (kase->shown[0] == '-') /* which would be an option */
    po_text_add(&word, "./");
  po_text_add_word(&word, kase->shown);
  kase->is_own = true;
  kase->word = word.data;
  return word.failed ? PO_NO_MEMORY : PO_OK;
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

po_status po_case_read(const char *path, const char *shown, po_case **check_result) {
  *check_result = NULL;
  po_yaml *yaml = NULL;
  po_case *kase = po_allocate(1, sizeof *kase);
  po_status status = kase ? PO_OK : PO_NO_MEMORY;
  if (!status && (!(kase->path = po_copy_text(path)) || !(kase->shown = po_copy_text(shown))))
    status = PO_NO_MEMORY;
  if (!status)
    status = po_file_read(path, &kase->source, &kase->source_size);
  if (!status)
    status = po_yaml_create(shown, kase->source, kase->source_size, &yaml);
  if (!status)
    status = po_schema_load(yaml, kase->source, kase->source_size, &kase->file);
  if (!status)
    status = po_case_parse(kase, yaml);
  po_yaml_destroy(yaml);
  if (status)
    po_case_destroy(kase);
  else
    *check_result = kase;
  return status;
}

void po_case_destroy(po_case *kase) {
  if (!kase)
    return;
  for (size_t i = 0; kase->points && i < kase->point_count; ++i)
    free(kase->points[i].label);
  free(kase->points);
  po_case_axes_clear(kase->file);
  po_schema_free(kase->file);
  free(kase->source);
  free(kase->word);
  free(kase->shown);
  free(kase->path);
  free(kase);
}
