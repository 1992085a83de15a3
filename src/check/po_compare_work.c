#include <math.h>
#include <stdio.h>

#include "po_compare_parts.h"
#include "po_pins.h"

po_status po_compare_work(const po_case *kase, size_t point, const po_check *check,
                          const po_reference *reference, const po_result *result,
                          po_check_results *check_results) {
  for (int counter = 0; counter < PO_WORK_COUNTERS; ++counter) {
    char pin[PO_PIN_NAME_LENGTH], name[PO_PIN_NAME_LENGTH];
    po_reference_number expected = {(double)NAN, 0};
    snprintf(pin, sizeof pin, "work/%s", po_work_name(counter));
    snprintf(name, sizeof name, "work_%s", po_work_name(counter));
    const po_status status =
        po_pins_value(reference, pin, &kase->points[point].request, &expected.value);
    if (status && status != PO_NOT_FOUND)
      return status;
    const double done =
        result->status == PO_OK ? po_work_count(&result->work, counter) : (double)NAN;
    if (!po_check_results_add(check_results, kase, point, check, name, po_work_name(counter), done,
                              expected))
      return PO_NO_MEMORY;
  }
  return PO_OK;
}
