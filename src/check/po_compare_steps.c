#include <math.h>
#include <stdio.h>

#include "po_compare_parts.h"

static const po_compare_column NUMBERS[] = {{"from_approach", "step_preload"},
                                            {"from_load", "step_preload_load"},
                                            {"force", "step_force"},
                                            {"approach", "step_approach"},
                                            {"energy_lost", "step_energy_lost"}};
enum { NUMBER_COUNT = sizeof NUMBERS / sizeof *NUMBERS };

/* Under load control the first step begins with separated bodies, at no finite approach, and the
 * energy lost is infinite. So the first and the last number are not compared. Neither is the energy
 * lost, the last number, if the table does not have it. */
static size_t first_compared(po_quantity quantity) {
  return quantity == PO_STEPS ? 0 : 1;
}
static size_t count_compared(po_quantity quantity, const po_reference *reference) {
  const bool energies =
      po_csv_find_column(&reference->table, NUMBERS[NUMBER_COUNT - 1].column) >= 0;
  return NUMBER_COUNT - (quantity == PO_STEPS ? !energies : 2);
}

/* Returned: the controlled quantity, approach or load; the column of its value at the begin of a
 * step. */
static double driven(po_quantity quantity, const po_path_state *state) {
  return quantity == PO_STEPS ? state->approach : state->load;
}
static const char *driven_column(po_quantity quantity) {
  return quantity == PO_STEPS ? "from_approach" : "from_load";
}

/* Returned: the greatest approach (or load) up to which the table lists all steps of a scene; NAN:
 * the table has no column complete_to, or no row for the scene. */
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

/* Counts the rows whose steps begin within the range of loading, up to `reach`. */
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

static po_status add_step(const po_compare_target *target, size_t row, const po_step *step,
                          size_t index) {
  const po_quantity quantity = target->check->quantity;
  const size_t first = first_compared(quantity);
  const double obtained[NUMBER_COUNT] = {step->preload.approach, step->preload.load,
                                         -step->pull_off.load, step->pull_off.approach,
                                         step->cycle[0].loss.energy};
  char subject[48];
  snprintf(subject, sizeof subject, "step-%zu", index + 1);
  return po_compare_row_add(target, row, subject, NUMBERS + first, obtained + first,
                            count_compared(quantity, target->reference), step->pull_off);
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
  const po_compare_target target = {kase, point, check, reference, check_results};
  for (size_t k = 0; k < count && !status; ++k)
    status = add_step(&target, po_compare_row(reference, &request, k), &ours->step[k], k);
  return status;
}

po_status po_compare_steps_uncertainty(po_quantity quantity, const po_reference *reference,
                                       const po_request *request, po_reference_number *most) {
  return po_compare_rows_uncertainty(reference, request, NUMBERS + first_compared(quantity),
                                     count_compared(quantity, reference), most);
}
