#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_compare_parts.h"

static const po_compare_column NUMBERS[] = {{"approach", "jump_approach"},
                                            {"load_before", "jump_load_before"},
                                            {"load_after", "jump_load_after"},
                                            {"energy_lost", "jump_energy_lost"}};
enum { NUMBER_COUNT = sizeof NUMBERS / sizeof *NUMBERS };

static const char *phase_of(const po_jump *jump) {
  return jump->loading ? "loading" : "unloading";
}

static bool phases_agree(const po_reference *reference, const po_request *request,
                         const po_loop *loop, size_t column) {
  for (size_t k = 0; k < loop->jump_count; ++k)
    if (strcmp(po_csv_cell(&reference->table, po_compare_row(reference, request, k), column),
               phase_of(&loop->jumps[k])) != 0)
      return false;
  return true;
}

static po_status add_jump(const po_compare_target *target, size_t row, const po_loop *loop,
                          size_t index) {
  const po_jump *jump = &loop->jumps[index];
  const double obtained[NUMBER_COUNT] = {jump->before.approach, jump->before.load, jump->after.load,
                                         jump->energy_lost};
  char subject[48];
  snprintf(subject, sizeof subject, "%s-%zu", phase_of(jump),
           jump->loading ? index + 1 : index + 1 - loop->loading_jumps);
  return po_compare_row_add(target, row, subject, NUMBERS, obtained, NUMBER_COUNT, jump->before);
}

po_status po_compare_jumps(const po_case *kase, size_t point, const po_check *check,
                           const po_reference *reference, const po_result *result,
                           po_check_results *check_results) {
  const po_request request = po_check_request(check, &kase->points[point].request);
  const po_loop *loop = &result->hysteresis.displacement;
  const bool solved = result->status == PO_OK && result->has_hysteresis;
  const size_t rows = po_compare_row_count(reference, &request);
  const int column = po_csv_find_column(&reference->table, "phase");
  if (column < 0)
    return po_fail(PO_CANNOT_READ, "%s:%zu: the column phase is missing", reference->table.path,
                   reference->table.column_line);
  const po_reference_number expected = {rows ? (double)rows : (double)NAN, 0};
  po_check_result *item =
      po_check_results_add(check_results, kase, point, check, "jump_count", "count",
                           solved ? (double)loop->jump_count : (double)NAN, expected);
  if (!item)
    return PO_NO_MEMORY;
  if (!solved || !rows)
    return PO_OK;
  if (loop->jump_count != rows || !phases_agree(reference, &request, loop, (size_t)column)) {
    item->verdict = PO_OUTSIDE;
    snprintf(item->note, sizeof item->note, "jumps in loading: %zu, in unloading: %zu",
             loop->loading_jumps, loop->jump_count - loop->loading_jumps);
    return PO_OK;
  }
  const po_compare_target target = {kase, point, check, reference, check_results};
  po_status status = PO_OK;
  for (size_t k = 0; k < rows && !status; ++k)
    status = add_jump(&target, po_compare_row(reference, &request, k), loop, k);
  return status;
}

po_status po_compare_jumps_uncertainty(const po_reference *reference, const po_request *request,
                                       po_reference_number *most) {
  return po_compare_rows_uncertainty(reference, request, NUMBERS, NUMBER_COUNT, most);
}
