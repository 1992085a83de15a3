#include <math.h>
#include <stdio.h>

#include "po_compare_parts.h"

/* What is compared of a step: the column of the table, and the quantity in the results. */
static const struct {
  const char *column, *name;
} NUMBERS[] = {{"from_approach", "step_preload"},
               {"from_load", "step_preload_load"},
               {"force", "step_force"},
               {"approach", "step_approach"},
               {"energy_lost", "step_energy_lost"}};
enum { NUMBER_COUNT = sizeof NUMBERS / sizeof *NUMBERS };

/* In load control the first step begins where the bodies are apart, and the energy lost is
 * boundless. */
static bool is_compared(po_quantity quantity, size_t number) {
  return quantity == PO_STEPS || (number > 0 && number + 1 < NUMBER_COUNT);
}

/* What is driven, and its column. */
static double driven(po_quantity quantity, const po_path_state *state) {
  return quantity == PO_STEPS ? state->approach : state->load;
}
static const char *driven_column(po_quantity quantity) {
  return quantity == PO_STEPS ? "from_approach" : "from_load";
}

static double number_of(const po_step *step, size_t which) {
  const double of[NUMBER_COUNT] = {step->preload.approach, step->preload.load, -step->pull_off.load,
                                   step->pull_off.approach, step->cycle[0].energy_lost};
  return of[which];
}

/* The greatest approach (or load) up to which the table lists the steps of a scene; NAN: it does
 * not say, or lists none. */
static double table_reach(const po_reference *reference, const po_request *request) {
  const size_t row = po_compare_row(reference, request, 0);
  po_reference_number number = {(double)NAN, 0};
  if (row < reference->table.row_count && po_csv_find_column(&reference->table, "complete_to") >= 0)
    (void)po_reference_cell(reference, row, "complete_to", &number);
  return number.value;
}

static size_t count_ours(po_quantity quantity, const po_staircase *ours, double reach) {
  size_t count = 0;
  while (count < ours->count && !(driven(quantity, &ours->step[count].preload) > reach))
    ++count;
  return count;
}

/* The rows that list steps up to where loading came. */
static size_t count_theirs(po_quantity quantity, const po_reference *reference,
                           const po_request *request, double reach, po_status *status) {
  const size_t all = po_compare_row_count(reference, request);
  size_t count = 0;
  for (size_t k = 0; k < all && !*status; ++k) {
    po_reference_number from = {0};
    *status = po_reference_cell(reference, po_compare_row(reference, request, k),
                                driven_column(quantity), &from);
    count += from.value <= reach;
  }
  return count;
}

static po_status add_step(const po_case *kase, size_t point, const po_check *check,
                          const po_reference *reference, size_t row, const po_step *step,
                          size_t index, po_check_results *check_results) {
  po_status status = PO_OK;
  for (size_t n = 0; n < NUMBER_COUNT && !status; ++n) {
    if (!is_compared(check->quantity, n))
      continue;
    char suffix[64];
    po_reference_number expected = {0};
    snprintf(suffix, sizeof suffix, "step-%zu/%s", index + 1, NUMBERS[n].column);
    status = po_reference_cell(reference, row, NUMBERS[n].column, &expected);
    po_check_result *item =
        status ? NULL
               : po_check_results_add(check_results, kase, point, check, NUMBERS[n].name, suffix,
                                      number_of(step, n), expected);
    if (!status && !item)
      status = PO_NO_MEMORY;
    if (item) {
      item->approach = step->pull_off.approach;
      item->load = step->pull_off.load;
    }
  }
  return status;
}

po_status po_compare_steps(const po_case *kase, size_t point, const po_check *check,
                           const po_reference *reference, const po_result *result,
                           po_check_results *check_results) {
  const po_request request = po_check_request(check, &kase->points[point].request);
  const po_staircase *ours = &result->staircase[check->quantity == PO_LOAD_STEPS];
  const bool solved = result->status == PO_OK && result->has_staircases;
  const bool known = po_compare_row_count(reference, &request) > 0;
  po_status status = PO_OK;
  const size_t theirs = solved ? count_theirs(check->quantity, reference, &request,
                                              driven(check->quantity, &ours->reached), &status)
                               : 0;
  const size_t count =
      solved ? count_ours(check->quantity, ours, table_reach(reference, &request)) : 0;
  if (status)
    return status;
  const po_reference_number expected = {known ? (double)theirs : (double)NAN, 0};
  po_check_result *item =
      po_check_results_add(check_results, kase, point, check, "step_count", "count",
                           solved ? (double)count : (double)NAN, expected);
  if (!item)
    return PO_NO_MEMORY;
  if (!solved || !known)
    return PO_OK;
  if (count != theirs) {
    item->verdict = PO_OUTSIDE;
    return PO_OK;
  }
  for (size_t k = 0; k < count && !status; ++k)
    status = add_step(kase, point, check, reference, po_compare_row(reference, &request, k),
                      &ours->step[k], k, check_results);
  return status;
}

po_status po_compare_steps_doubt(po_quantity quantity, const po_reference *reference,
                                 const po_request *request, po_reference_number *most) {
  const char *columns[NUMBER_COUNT];
  size_t count = 0;
  for (size_t n = 0; n < NUMBER_COUNT; ++n)
    if (is_compared(quantity, n))
      columns[count++] = NUMBERS[n].column;
  return po_compare_rows_doubt(reference, request, columns, count, most);
}
