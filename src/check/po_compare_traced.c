#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_compare.h"
#include "po_compare_parts.h"
#include "po_result_rows.h"

/* Returned: the value of a quantity of the pull-off in the trace, with its estimated error as the
 * uncertainty. */
static po_reference_number number_of(const po_check *check, const po_result *trace) {
  const char *path = strchr(po_quantity_of(check->quantity)->path, '.') + 1;
  const po_row *row = po_block_find(&PO_PULL_OFF_ROWS, NULL, path).row;
  return (po_reference_number){po_compare_obtained(check->quantity, trace),
                               po_block_number(&PO_PULL_OFF_ROWS, trace, row->error)};
}

po_status po_compare_traced(const po_case *kase, const bool *asked, const po_check *check,
                            const po_reference *reference, const po_result *results,
                            const po_result *traces, po_check_results *check_results) {
  for (size_t i = 0; i < kase->point_count; ++i) {
    const po_result *result = &results[i], *trace = &traces[i];
    if (!asked[i] || !kase->points[i].traced || !po_check_concerns(check, &kase->points[i].request))
      continue;
    po_check_result *item =
        po_check_results_add(check_results, kase, i, check, po_quantity_name(check->quantity), "",
                             po_compare_obtained(check->quantity, result), number_of(check, trace));
    if (!item)
      return PO_NO_MEMORY;
    item->ledger = reference->ledger;
    if (result->has_pull_off) {
      item->approach = result->pull_off.approach;
      item->load = -result->pull_off.force;
    }
    if (trace->status)
      snprintf(item->note, sizeof item->note, "the trace failed: %.160s", trace->reason);
    else if (result->status)
      snprintf(item->note, sizeof item->note, "%.190s", result->reason);
    else if (!result->followed)
      snprintf(item->note, sizeof item->note, "not computed by continuation: the scene was traced");
  }
  return PO_OK;
}
