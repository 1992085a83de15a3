#include "po_plan.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_compare.h"
#include "po_environment.h"
#include "po_file.h"
#include "po_memory.h"
#include "po_text.h"

po_request po_plan_request(const po_plan *plan, size_t point) {
  po_request request = plan->kase->points[point].request;
  request.want = plan->want;
  return request;
}

/* The quantities of loading and unloading. */
static const unsigned HYSTERESIS = 1U << PO_HYSTERESIS_FORCE | 1U << PO_HYSTERESIS_APPROACH |
                                   1U << PO_HYSTERESIS_LOSS | 1U << PO_JUMPS;

void po_plan_add_options(const po_plan *plan, po_text *text) {
  const po_solver *solver = plan->solver;
  if (solver) {
    po_text_add(text, " --solver ");
    po_text_add_word(text, solver->path.text);
  }
  if (solver && solver->knob && strchr(solver->name, '@')) {
    po_text_add(text, " --knob ");
    po_text_add_word(text, solver->knob);
  }
  if (plan->kase->time_limit > 0.0)
    po_text_add(text, " --time-limit %.15g", plan->kase->time_limit);
}

void po_plan_add_rerun(const po_plan *plan, size_t point, po_text *text) {
  po_text_add(text, "pulloff verify %s --points %s", po_case_word(plan->kase),
              plan->kase->points[point].id);
  po_plan_add_options(plan, text);
  po_text_add(text, " --fresh --verbose");
}

bool po_plan_covers(const po_plan *plan, const po_check *check) {
  if (!plan->solver)
    return true;
  if (check->quantity != PO_SOLVED_SHARE && !(plan->solver->quantities & 1U << check->quantity))
    return false; /* the share is known of every solver */
  return check->type != PO_REFERENCE_TRACED;
}

unsigned po_plan_asked(const po_plan *plan) {
  const po_case *kase = plan->kase;
  unsigned asked = 0;
  if (kase->want & PO_CASE_PULL_OFF)
    asked |= 1U << PO_PULL_OFF_FORCE | 1U << PO_PULL_OFF_APPROACH;
  if (kase->want & PO_CASE_FOLDS)
    asked |= 1U << PO_FOLDS;
  if (kase->want & PO_CASE_EXTREMA)
    asked |= 1U << PO_EXTREMA;
  if (kase->want & PO_WANT_CURVE)
    asked |= 1U << PO_CURVE;
  if (kase->want & PO_WANT_HYSTERESIS)
    asked |= HYSTERESIS;
  const po_check *check;
  for (unsigned i = 0; (check = po_case_check(kase->file, i)) != NULL; ++i)
    asked |= 1U << check->quantity;
  return asked & plan->solver->quantities;
}

/* What the quantities of a family need. */
static const unsigned WANTS[] = {[PO_OF_LOOP] = PO_WANT_HYSTERESIS,
                                 [PO_OF_STAIRCASE] = PO_WANT_PRELOAD,
                                 [PO_OF_DIAGNOSTICS] = PO_WANT_DIAGNOSTICS,
                                 [PO_OF_INPUTS] = 0,
                                 [PO_OF_SOLVE] = 0};

/* Determines which results the case and its checks need. */
static void decide(po_plan *plan) {
  const po_case *kase = plan->kase;
  plan->want = kase->want & ((1U << PO_WANT_COUNT) - 1);
  const po_check *check;
  for (unsigned i = 0; (check = po_case_check(kase->file, i)) != NULL; ++i) {
    if (check->quantity == PO_CURVE && plan->references[i].type != PO_REFERENCE_ABSENT)
      plan->want |= PO_WANT_CURVE;
    plan->want |= WANTS[PO_QUANTITIES[check->quantity].family];
  }
  if (plan->solver) {
    const unsigned asked = po_plan_asked(plan);
    plan->want &= (asked & (1U << PO_CURVE) ? PO_WANT_CURVE : 0U) |
                  (asked & HYSTERESIS ? PO_WANT_HYSTERESIS : 0U);
  }
}

/* Returned: the folder from which a reference of a case is taken. For a case file outside the
 * folder of cases it is that of the file, unless only the data folder has the table. */
static po_file_path folder_for(const po_case *kase, const char *data_folder, const char *name) {
  const po_file_path shared = po_path_join("", data_folder);
  if (!kase->is_own || po_reference_type_of(name) != PO_REFERENCE_TABLE)
    return shared;
  po_file_path own = po_path_join("", kase->path);
  const char *slash = strrchr(own.text, '/');
  own.text[slash ? slash - own.text + 1 : 0] = '\0';
  const po_file_path file = po_reference_file(name);
  return !po_path_exists(po_path_join(own.text, file.text).text) &&
                 po_path_exists(po_path_join(data_folder, file.text).text)
             ? shared
             : own;
}

/* Opens the reference of a check like po_reference_open. If the check names a stand-in, the table
 * need not exist (the type is then PO_REFERENCE_ABSENT); if it exists, its kind must be published.
 */
static po_status reference_open_check(const char *data_folder, const po_check *check,
                                      po_reference *reference) {
  *reference = (po_reference){.name = check->reference};
  if (check->stand_in &&
      !po_path_exists(po_path_join(data_folder, po_reference_file(check->reference).text).text)) {
    reference->type = PO_REFERENCE_ABSENT;
    po_digest_bytes("absent", strlen("absent"), reference->digest);
    return PO_OK;
  }
  const po_status status = po_reference_open(data_folder, check->reference, reference);
  if (!status && reference->row && !*PO_QUANTITIES[check->quantity].path) {
    po_reference_close(reference);
    return po_fail(PO_BAD_INPUT, "%s has one number: expected a quantity that is one, not %s",
                   check->reference, check->quantity_text);
  }
  if (status || !check->stand_in || reference->ledger == PO_LEDGER_PUBLISHED)
    return status;
  const po_csv_header *kind = po_csv_find_header(&reference->table, "kind");
  const po_status refused =
      po_fail(PO_CANNOT_READ, "%s:%zu: kind is %s: expected published, as the table has a stand-in",
              reference->table.path, kind->line, kind->value);
  po_reference_close(reference);
  return refused;
}

static po_status open_check(const po_plan *plan, const char *data_folder, const po_check *check,
                            po_reference *reference) {
  const po_file_path folder = folder_for(plan->kase, data_folder, check->reference);
  po_status status = reference_open_check(folder.text, check, reference);
  if (!status && plan->kase->is_physical && reference->type == PO_REFERENCE_TABLE)
    status = plan->kase->varies_units && po_reference_has_units(reference)
                 ? po_fail(PO_BAD_INPUT,
                           "%s: reference %s is in SI units: expected a dimensionless one, as the "
                           "sweep varies the units",
                           plan->kase->shown, check->reference)
                 : po_reference_use_units(reference, &plan->kase->units);
  return status;
}

static po_status open_references(po_plan *plan, const char *data_folder) {
  const po_case_file *file = plan->kase->file;
  const po_check *check;
  plan->references =
      po_allocate(file->checks_count + file->measure_count, sizeof *plan->references);
  po_status status = plan->references ? PO_OK : PO_NO_MEMORY;
  for (unsigned i = 0; !status && (check = po_case_check(file, i)) != NULL; ++i) {
    po_reference *reference = &plan->references[i];
    status = open_check(plan, data_folder, check, reference);
    if (!status && i < file->checks_count && reference->type != PO_REFERENCE_ABSENT)
      status = po_compare_check_tolerance(plan->kase, check, i + 1, reference);
  }
  return status;
}

static po_status make_keys(po_plan *plan) {
  const po_case *kase = plan->kase;
  po_text text = {0};
  po_text_add(&text, "%s|%u|%u|", plan->program, plan->want, kase->repeats);
  if (kase->series_length > 1)
    po_text_add(&text, "%s|%zu|%zu|", kase->file->follow, kase->series_length, kase->checkpoints);
  if (kase->file->traced)
    po_text_add(&text, "%s|%s|", kase->file->traced->seed_text, kase->file->traced->count_text);
  for (size_t i = 0; i < kase->point_count; ++i) {
    po_input_add_identity(&kase->points[i].request, &text);
    po_text_add(&text, "|");
  }
  po_digest_bytes(po_text_string(&text), text.length, plan->solve_key);
  for (unsigned i = 0; po_case_check(kase->file, i); ++i)
    po_text_add(&text, "%s|", plan->references[i].digest);
  po_text_add_bytes(&text, kase->source, kase->source_size);
  po_digest_bytes(po_text_string(&text), text.length, plan->key);
  const po_status status = text.failed ? PO_NO_MEMORY : PO_OK;
  po_text_clear(&text);
  return status;
}

static po_status name_plan(po_plan *plan) {
  po_text name = {0};
  if (plan->solver)
    po_text_add(&name, "%s:", plan->solver->name);
  po_text_add(&name, "%s", plan->kase->file->name);
  plan->name = name.data;
  return name.failed ? PO_NO_MEMORY : PO_OK;
}

po_status po_plan_create(const po_case *kase, const char *data_folder, const po_solver *solver,
                         po_plan **result) {
  *result = NULL;
  po_plan *plan = po_allocate(1, sizeof *plan);
  if (!plan)
    return PO_NO_MEMORY;
  plan->kase = kase;
  plan->solver = solver;
  po_status status = PO_OK;
  if (solver)
    snprintf(plan->program, sizeof plan->program, "%s", solver->digest);
  else
    status = po_environment_program(plan->program);
  if (!status)
    status = name_plan(plan);
  if (!status)
    status = po_pins_open(kase, &plan->pins);
  if (!status)
    status = open_references(plan, data_folder);
  if (!status) {
    decide(plan);
    status = make_keys(plan);
  }
  if (status)
    po_plan_destroy(plan);
  else
    *result = plan;
  return status;
}

void po_plan_destroy(po_plan *plan) {
  if (!plan)
    return;
  for (unsigned i = 0; plan->references && po_case_check(plan->kase->file, i); ++i)
    po_reference_close(&plan->references[i]);
  free(plan->references);
  po_pins_close(&plan->pins);
  free(plan->name);
  free(plan);
}
