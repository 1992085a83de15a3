/* Comparison with tables that have several rows for a scene. */
#include <math.h>
#include <stdio.h>

#include "po_compare_parts.h"

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

po_status po_compare_row_add(const po_compare_target *target, size_t row, const char *subject,
                             const po_compare_column *columns, const double *obtained, size_t count,
                             po_path_state where) {
  for (size_t n = 0; n < count; ++n) {
    char suffix[64];
    po_reference_number expected = {0};
    snprintf(suffix, sizeof suffix, "%s/%s", subject, columns[n].column);
    const po_status status =
        po_reference_cell(target->reference, row, columns[n].column, &expected);
    if (status)
      return status;
    po_check_result *item =
        po_check_results_add(target->check_results, target->kase, target->point, target->check,
                             columns[n].name, suffix, obtained[n], expected);
    if (!item)
      return PO_NO_MEMORY;
    item->approach = where.approach;
    item->load = where.load;
  }
  return PO_OK;
}

po_status po_compare_rows_uncertainty(const po_reference *reference, const po_request *request,
                                      const po_compare_column *columns, size_t count,
                                      po_reference_number *most) {
  po_status status = PO_OK;
  *most = (po_reference_number){(double)NAN, 0};
  for (size_t row = 0; row < reference->table.row_count; ++row)
    for (size_t n = 0; n < count && !status; ++n) {
      po_reference_number number = {0};
      if (po_reference_row_is_of(reference, row, request))
        status = po_reference_cell(reference, row, columns[n].column, &number);
      if (number.uncertainty > most->uncertainty)
        *most = number;
    }
  return status;
}
