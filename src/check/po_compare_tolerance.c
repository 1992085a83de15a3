#include <math.h>
#include <stdlib.h>

#include "po_compare.h"
#include "po_compare_parts.h"

static po_status refuse(const po_case *kase, const po_check *check, unsigned number,
                        const po_reference *reference, double uncertainty) {
  char text[PO_NUMBER_LENGTH];
  po_number_print(uncertainty, text);
  return po_fail(PO_BAD_INPUT,
                 "%s:%zu: checks[%u].tolerance is %s: expected at least %s, the uncertainty of %s",
                 kase->shown, check->tolerance_line, number, check->tolerance_text, text,
                 reference->name);
}

static bool too_tight(const po_check *check, double expected, double uncertainty) {
  return !isnan(uncertainty) && po_check_allowance(check, expected) < uncertainty;
}

static po_status check_points(const po_case *kase, const po_check *check, unsigned number,
                              const po_reference *reference, const po_request *request) {
  /* The range of the trace is not known yet; this one extends from large separation to contact. */
  po_curve_point ends[] = {{.approach = -10}, {.approach = 0.2}};
  const po_result everywhere = {
      .start = -10, .ended.approach = 0.2, .curve = ends, .curve_count = 2};
  po_reference_point *points = NULL;
  size_t count = 0;
  po_status status =
      po_reference_points(reference, check->quantity, request, &everywhere, &points, &count);
  for (size_t i = 0; !status && i < count; ++i) {
    if (too_tight(check, points[i].approach, points[i].approach_uncertainty))
      status = refuse(kase, check, number, reference, points[i].approach_uncertainty);
    else if (too_tight(check, points[i].load, points[i].load_uncertainty))
      status = refuse(kase, check, number, reference, points[i].load_uncertainty);
  }
  free(points);
  return status;
}

po_status po_compare_check_tolerance(const po_case *kase, const po_check *check, unsigned number,
                                     const po_reference *reference) {
  if (check->quantity == PO_SOLVED_SHARE ||
      reference->type == PO_REFERENCE_TRACED) /* has no value before the run */
    return PO_OK;
  for (size_t i = 0; i < kase->point_count; ++i) {
    const po_request asked = po_check_request(check, &kase->points[i].request);
    const po_request *request = &asked;
    if (check->quantity == PO_FOLD_COUNT || !po_check_concerns(check, &kase->points[i].request))
      continue; /* a number of folds has no uncertainty */
    po_status status = PO_OK;
    if (check->quantity == PO_FOLDS || check->quantity == PO_EXTREMA || check->quantity == PO_CURVE)
      status = check_points(kase, check, number, reference, request);
    else {
      po_reference_number expected = {0};
      status = po_quantity_is_steps(check->quantity)
                   ? po_compare_steps_uncertainty(check->quantity, reference, request, &expected)
               : check->quantity == PO_JUMPS
                   ? po_compare_jumps_uncertainty(reference, request, &expected)
                   : po_reference_find(reference, check->quantity, request, &expected);
      if (!status && too_tight(check, expected.value, expected.uncertainty))
        status = refuse(kase, check, number, reference, expected.uncertainty);
    }
    if (status && status != PO_NOT_FOUND)
      return status;
  }
  return PO_OK;
}
