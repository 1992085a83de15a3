#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_compare_parts.h"

/* What is compared of a jump: the column of the table, and the quantity in the results. */
static const struct {
  const char *column, *name;
} NUMBERS[] = {{"approach", "jump_approach"},
               {"load_before", "jump_load_before"},
               {"load_after", "jump_load_after"},
               {"energy_lost", "jump_energy_lost"}};
enum { NUMBER_COUNT = sizeof NUMBERS / sizeof *NUMBERS };

static double number_of(const po_jump *jump, size_t which) {
  const double of[NUMBER_COUNT] = {jump->before.approach, jump->before.load, jump->after.load,
                                   jump->energy_lost};
  return of[which];
}

size_t po_compare_row(const po_reference *reference, const po_request *request, size_t index) {
  size_t row = 0;
  for (; row < reference->table.row_count; ++row)
    if (po_reference_row_is_of(reference, row, request) && index-- == 0)
      break;
  return row;
}

size_t po_compare_row_count(const po_reference *reference, const po_request *request) {
  size_t count = 0;
  for (size_t row = 0; row < reference->table.row_count; ++row)
    count += po_reference_row_is_of(reference, row, request);
  return count;
}

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

static po_status add_jump(const po_case *kase, size_t point, const po_check *check,
                          const po_reference *reference, size_t row, const po_loop *loop,
                          size_t index, po_check_results *check_results) {
  const po_jump *jump = &loop->jumps[index];
  po_status status = PO_OK;
  for (size_t n = 0; n < NUMBER_COUNT && !status; ++n) {
    char suffix[64];
    po_reference_number expected = {0};
    snprintf(suffix, sizeof suffix, "%s-%zu/%s", phase_of(jump),
             jump->loading ? index + 1 : index + 1 - loop->loading_jumps, NUMBERS[n].column);
    status = po_reference_cell(reference, row, NUMBERS[n].column, &expected);
    po_check_result *item =
        status ? NULL
               : po_check_results_add(check_results, kase, point, check, NUMBERS[n].name, suffix,
                                      number_of(jump, n), expected);
    if (!status && !item)
      status = PO_NO_MEMORY;
    if (item) {
      item->approach = jump->before.approach;
      item->load = jump->before.load;
    }
  }
  return status;
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
    snprintf(item->note, sizeof item->note, "%zu in loading, %zu in unloading", loop->loading_jumps,
             loop->jump_count - loop->loading_jumps);
    return PO_OK;
  }
  po_status status = PO_OK;
  for (size_t k = 0; k < rows && !status; ++k)
    status = add_jump(kase, point, check, reference, po_compare_row(reference, &request, k), loop,
                      k, check_results);
  return status;
}

po_status po_compare_rows_doubt(const po_reference *reference, const po_request *request,
                                const char *const *columns, size_t count,
                                po_reference_number *most) {
  po_status status = PO_OK;
  *most = (po_reference_number){(double)NAN, 0};
  for (size_t row = 0; row < reference->table.row_count; ++row)
    for (size_t n = 0; n < count && !status; ++n) {
      po_reference_number number = {0};
      if (po_reference_row_is_of(reference, row, request))
        status = po_reference_cell(reference, row, columns[n], &number);
      if (number.uncertainty > most->uncertainty)
        *most = number;
    }
  return status;
}

po_status po_compare_jumps_doubt(const po_reference *reference, const po_request *request,
                                 po_reference_number *most) {
  const char *columns[NUMBER_COUNT];
  for (size_t n = 0; n < NUMBER_COUNT; ++n)
    columns[n] = NUMBERS[n].column;
  return po_compare_rows_doubt(reference, request, columns, NUMBER_COUNT, most);
}
