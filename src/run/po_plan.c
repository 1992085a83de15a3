#include "po_plan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_compare.h"
#include "po_environment.h"
#include "po_memory.h"
#include "po_pins.h"
#include "po_plan_words.h"
#include "po_text.h"

po_request po_plan_request(const po_plan *plan, size_t point) {
  po_request request = plan->kase->points[point].request;
  request.want = plan->want;
  return request;
}

const char *po_plan_reference_of(const po_plan *plan, const po_check *check) {
  const po_case_file *file = plan->kase->file;
  for (unsigned i = 0; i < file->measure_count; ++i)
    if (check == &file->measure[i])
      return check->reference;
  return po_reference_shown(&plan->references[check - file->checks]);
}

/* Determines which results the case and its checks need. */
static void decide(po_plan *plan) {
  const po_case *kase = plan->kase;
  plan->want = 0;
  if (kase->want & PO_CASE_CURVE)
    plan->want |= PO_WANT_CURVE;
  if (kase->want & PO_CASE_PROFILE)
    plan->want |= PO_WANT_PROFILE;
  if (kase->want & PO_CASE_HYSTERESIS)
    plan->want |= PO_WANT_HYSTERESIS;
  if (kase->want & PO_CASE_DIAGNOSTICS)
    plan->want |= PO_WANT_DIAGNOSTICS;
  if (kase->want & PO_CASE_PRELOAD)
    plan->want |= PO_WANT_PRELOAD;
  for (unsigned i = 0; i < kase->file->checks_count; ++i) {
    const po_quantity quantity = kase->file->checks[i].quantity;
    if (quantity == PO_CURVE && plan->references[i].type != PO_REFERENCE_ABSENT)
      plan->want |= PO_WANT_CURVE;
    if (po_quantity_is_diagnostic(quantity))
      plan->want |= PO_WANT_DIAGNOSTICS;
    if (po_quantity_is_hysteresis(quantity))
      plan->want |= PO_WANT_HYSTERESIS;
    if (po_quantity_is_preload(quantity))
      plan->want |= PO_WANT_PRELOAD;
  }
  for (unsigned i = 0; i < kase->file->measure_count; ++i)
    if (kase->file->measure[i].quantity == PO_CURVE)
      plan->want |= PO_WANT_CURVE;
}

static po_status open_references(po_plan *plan, const char *data_folder) {
  const po_case_file *file = plan->kase->file;
  plan->references = po_allocate(file->checks_count, sizeof *plan->references);
  plan->measures = po_allocate(file->measure_count, sizeof *plan->measures);
  if (!plan->references || !plan->measures)
    return PO_NO_MEMORY;
  po_status status = PO_OK;
  for (unsigned i = 0; !status && i < file->checks_count; ++i) {
    const po_check *check = &file->checks[i];
    status = po_check_is_pin(check)
                 ? po_pins_open(plan->kase, check->reference, &plan->references[i])
                 : po_reference_open_check(data_folder, check, &plan->references[i]);
    if (!status && plan->references[i].type != PO_REFERENCE_ABSENT)
      status = po_compare_check_tolerance(plan->kase, check, i + 1, &plan->references[i]);
  }
  for (unsigned i = 0; !status && i < file->measure_count; ++i)
    status = po_reference_open(data_folder, file->measure[i].reference, &plan->measures[i]);
  return status;
}

static po_status make_keys(po_plan *plan) {
  const po_case *kase = plan->kase;
  po_text text = {0};
  po_arithmetic_digest(&plan->arithmetic, plan->program);
  po_text_add(&text, "%s|%u|%u|", plan->program, plan->want, kase->repeats);
  if (kase->series_length > 1)
    po_text_add(&text, "%s|%zu|%zu|", kase->file->follow, kase->series_length, kase->checkpoints);
  if (kase->file->traced)
    po_text_add(&text, "%s|%s|", kase->file->traced->seed_text, kase->file->traced->count_text);
  for (size_t i = 0; i < kase->point_count; ++i) {
    char *command = po_input_command(&kase->points[i].request);
    po_text_add(&text, "%s|", command ? command : "");
    text.failed = text.failed || !command;
    free(command);
  }
  po_digest_bytes(po_text_string(&text), text.length, plan->solve_key);
  for (unsigned i = 0; i < kase->file->checks_count; ++i)
    po_text_add(&text, "%s|", plan->references[i].digest);
  for (unsigned i = 0; i < kase->file->measure_count; ++i)
    po_text_add(&text, "%s|", plan->measures[i].digest);
  po_text_add_bytes(&text, kase->source, kase->source_size);
  po_digest_bytes(po_text_string(&text), text.length, plan->key);
  const po_status status = text.failed ? PO_NO_MEMORY : PO_OK;
  po_text_clear(&text);
  return status;
}

po_status po_plan_create(const po_case *kase, const char *data_folder, po_plan **result) {
  po_arithmetic own;
  const po_status status = po_environment_arithmetic(&own);
  *result = NULL;
  return status ? status : po_plan_create_for(kase, data_folder, &own, result);
}

po_status po_plan_create_for(const po_case *kase, const char *data_folder,
                             const po_arithmetic *arithmetic, po_plan **result) {
  *result = NULL;
  po_plan *plan = po_allocate(1, sizeof *plan);
  if (!plan)
    return PO_NO_MEMORY;
  plan->kase = kase;
  plan->arithmetic = *arithmetic;
  po_status status = open_references(plan, data_folder);
  if (!status) {
    decide(plan);
    status = make_keys(plan);
  }
  if (!status)
    status = po_plan_describe(plan);
  if (status)
    po_plan_destroy(plan);
  else
    *result = plan;
  return status;
}

void po_plan_destroy(po_plan *plan) {
  if (!plan)
    return;
  for (unsigned i = 0; plan->references && i < plan->kase->file->checks_count; ++i)
    po_reference_close(&plan->references[i]);
  for (unsigned i = 0; plan->measures && i < plan->kase->file->measure_count; ++i)
    po_reference_close(&plan->measures[i]);
  free(plan->references);
  free(plan->measures);
  for (size_t i = 0; i < plan->line_count; ++i)
    free(plan->lines[i]);
  free(plan->lines);
  free(plan);
}
