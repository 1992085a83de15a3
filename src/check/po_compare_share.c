#include <stdio.h>
#include <stdlib.h>

#include "po_compare.h"
#include "po_memory.h"

po_status po_compare_share(const po_case *kase, const bool *asked, const po_check *check,
                           const po_reference *reference, const po_result *results,
                           po_check_results *check_results) {
  size_t concerned = 0, solved = 0, without_reason = 0, example = 0;
  for (size_t i = 0; i < kase->point_count; ++i) {
    if (!asked[i] || !po_check_concerns(check, &kase->points[i].request))
      continue;
    concerned += 1;
    if (results[i].status == PO_OK)
      solved += 1;
    else {
      without_reason += results[i].reason[0] ? 0 : 1;
      example = concerned == solved + 1 ? i : example;
    }
  }
  if (!concerned)
    return PO_OK;
  const po_reference_number expected = {1, (double)NAN};
  po_check_result *item = po_check_results_add(check_results, kase, example, check,
                                               po_quantity_of(check->quantity)->name, "",
                                               (double)solved / (double)concerned, expected);
  char *id = po_copy_text("solved_share/every_scene");
  if (!item || !id) {
    free(id);
    return PO_NO_MEMORY;
  }
  free(item->id);
  item->id = id;
  item->whole = true;
  item->ledger = reference->ledger;
  if (without_reason) {
    item->verdict = PO_OUTSIDE;
    snprintf(item->note, sizeof item->note, "%zu of %zu failures have no reason", without_reason,
             concerned - solved);
  } else if (solved < concerned)
    snprintf(item->note, sizeof item->note, "%zu of %zu points failed, first point %s: %.100s",
             concerned - solved, concerned, kase->points[example].id, results[example].reason);
  return PO_OK;
}
