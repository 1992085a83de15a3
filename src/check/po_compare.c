#include "po_compare.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_compare_parts.h"
#include "po_curve.h"
#include "po_memory.h"
#include "po_pins.h"
#include "po_result_rows.h"

static const po_reference_number UNKNOWN = {(double)NAN, (double)NAN};

/* Reports whether a quantity is a single number in the reference. Pins contain the number of folds;
 * for other references it is the number of listed folds over the common range. */
static bool is_single(po_quantity quantity, const po_reference *reference) {
  return *po_quantity_of(quantity)->path &&
         (quantity != PO_FOLD_COUNT || reference->type == PO_REFERENCE_PINS);
}

double po_compare_obtained(po_quantity quantity, const po_result *result) {
  if (result->status != PO_OK || (quantity != PO_FOLD_COUNT && !result->has_pull_off))
    return (double)NAN;
  return po_block_number(&PO_ALL_ROWS, result, po_quantity_of(quantity)->path);
}

static po_status compare_single(const po_case *kase, size_t point, const po_check *check,
                                const po_reference *reference, const po_result *result,
                                po_check_results *check_results) {
  po_reference_number expected = UNKNOWN;
  const po_request request = po_check_request(check, &kase->points[point].request);
  const po_status status = po_reference_find(reference, check->quantity, &request, &expected);
  if (status && status != PO_NOT_FOUND)
    return status;
  if (status)
    expected = UNKNOWN;
  po_check_result *item =
      po_check_results_add(check_results, kase, point, check, po_quantity_name(check->quantity), "",
                           po_compare_obtained(check->quantity, result), expected);
  if (!item)
    return PO_NO_MEMORY;
  if (check->quantity != PO_FOLD_COUNT && result->has_pull_off) {
    item->approach = result->pull_off.approach;
    item->load = -result->pull_off.force;
  }
  return PO_OK;
}

/* Returned: in *curve, points, rates and positions of the computed curve; the caller frees them. */
static po_status plane_of(const po_result *result, po_plane_curve *curve) {
  const size_t count = result->curve_count;
  po_plane_point *plane = po_allocate(2 * count, sizeof *plane);
  double *positions = po_allocate(count, sizeof *positions);
  *curve = (po_plane_curve){plane, plane ? plane + count : NULL, positions, count};
  if (!plane || !positions)
    return PO_NO_MEMORY;
  if (count > 0 && isnan(result->curve[0].approach_rate)) { /* of an external solver */
    free(positions);
    curve->positions = positions = NULL;
    curve->rates = NULL;
  }
  for (size_t i = 0; i < count; ++i) {
    const po_curve_point *p = &result->curve[i];
    plane[i] = (po_plane_point){p->approach, p->load};
    plane[count + i] = (po_plane_point){p->approach_rate, p->load_rate};
    if (positions)
      positions[i] = p->position;
  }
  return PO_OK;
}

static po_status compare_planes(const po_result *result, const po_reference_point *theirs,
                                size_t their_count, bool scattered, double tolerance,
                                po_curve_verdict *verdict) {
  po_plane_curve ours;
  po_status status = plane_of(result, &ours);
  po_plane_point *points = po_allocate(their_count, sizeof *points);
  if (!points)
    status = PO_NO_MEMORY;
  for (size_t i = 0; !status && i < their_count; ++i)
    points[i] = (po_plane_point){theirs[i].approach, theirs[i].load};
  if (!status && scattered)
    po_curve_scatter(&ours, points, their_count, verdict);
  else if (!status)
    status = po_curve_compare(&ours, &(po_plane_curve){.points = points, .count = their_count},
                              tolerance, verdict);
  free(points);
  free((void *)ours.points);
  free((void *)ours.positions);
  return status;
}

static po_status compare_curve(const po_case *kase, size_t point, const po_check *check,
                               const po_reference *reference, const po_result *result,
                               po_check_results *check_results) {
  po_reference_point *theirs = NULL;
  size_t count = 0;
  po_curve_verdict found = {0};
  const po_request request = po_check_request(check, &kase->points[point].request);
  po_status status = po_reference_points(reference, PO_CURVE, &request, result, &theirs, &count);
  const bool known = status == PO_OK;
  double uncertainty = (double)NAN;
  for (size_t i = 0; known && i < count; ++i)
    uncertainty =
        fmax(uncertainty, fmax(theirs[i].approach_uncertainty, theirs[i].load_uncertainty));
  if (known)
    /* published points are markers read off a figure, which are not in the order of the branch */
    status = compare_planes(result, theirs, count, reference->ledger == PO_LEDGER_PUBLISHED,
                            check->tolerance, &found);
  free(theirs);
  if (status && status != PO_NOT_FOUND)
    return status;
  const bool compared = known && found.compared > 0 && result->status == PO_OK;
  po_check_result *item = po_check_results_add(
      check_results, kase, point, check, "curve", "", compared ? found.distance : (double)NAN,
      (po_reference_number){known ? 0 : (double)NAN, uncertainty});
  if (!item)
    return PO_NO_MEMORY;
  item->obtained = item->expected = (double)NAN;
  if (!compared)
    return PO_OK;
  item->approach = found.where.approach;
  item->load = found.where.load;
  if (!found.same_folds)
    item->verdict = PO_OUTSIDE;
  if (found.note[0])
    snprintf(item->note, sizeof item->note, "%s", found.note);
  else
    snprintf(item->note, sizeof item->note,
             "largest distance near approach %.4g, load %.4g; %zu points compared, %zu beyond the "
             "ends",
             found.where.approach, found.where.load, found.compared, found.left_out);
  return PO_OK;
}

/* Writes the reason why the reverse trace has no result. */
static void explain_no_reverse_trace(po_check_result *item, const po_result *result) {
  const po_reverse_trace *w = &result->diagnostics.reverse_trace;
  const size_t size = sizeof item->note;
  if (!w->made)
    snprintf(item->note, size, "only elastic scenes on panels have a reverse trace");
  else if (w->status)
    snprintf(item->note, size, "on the reverse trace: %.170s", w->reason);
  else
    snprintf(item->note, size,
             "%zu folds on the trace, %zu on the reverse trace; extrema %zu and %zu",
             result->fold_count, w->folds, result->extremum_count, w->extrema);
}

/* Writes the reason into the note if nothing was compared. */
static void explain_no_comparison(po_check_result *item, const po_reference *reference,
                                  const po_result *result) {
  const size_t size = sizeof item->note;
  if (item->verdict == PO_NO_RESULT && result->status)
    snprintf(item->note, size, "%.190s", result->reason);
  else if (item->verdict == PO_NO_RESULT && strcmp(item->quantity, "reverse_trace") == 0)
    explain_no_reverse_trace(item, result);
  else if (item->verdict == PO_NO_RESULT)
    snprintf(item->note, size, "result and reference have no common range");
  else if (item->verdict == PO_MISSING_REFERENCE && reference->type == PO_REFERENCE_PINS)
    snprintf(item->note, size, "%s %.150s",
             po_pins_exist(reference) ? "not pinned in" : "there is no file", reference->shown);
  else if (item->verdict == PO_MISSING_REFERENCE)
    snprintf(item->note, size, "the reference does not contain this scene");
}

/* Compares each counter of work with its pin. */
static po_status compare_work(const po_case *kase, size_t point, const po_check *check,
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

po_status po_compare(const po_case *kase, size_t point, const po_check *check,
                     const po_reference *reference, const po_result *result,
                     po_check_results *check_results) {
  if (reference->type == PO_REFERENCE_ABSENT ||
      !po_check_concerns(check, &kase->points[point].request))
    return PO_OK;
  const size_t before = check_results->count;
  po_status status = PO_OK;
  if (is_single(check->quantity, reference))
    status = compare_single(kase, point, check, reference, result, check_results);
  else if (check->quantity == PO_CURVE)
    status = compare_curve(kase, point, check, reference, result, check_results);
  else if (check->quantity == PO_JUMPS)
    status = po_compare_jumps(kase, point, check, reference, result, check_results);
  else if (po_quantity_is_steps(check->quantity))
    status = po_compare_steps(kase, point, check, reference, result, check_results);
  else if (check->quantity == PO_WORK)
    status = compare_work(kase, point, check, reference, result, check_results);
  else
    status = po_compare_special_points(kase, point, check, reference, result, check_results);
  for (size_t i = before; i < check_results->count; ++i) {
    check_results->items[i].ledger = reference->ledger;
    explain_no_comparison(&check_results->items[i], reference, result);
  }
  return status;
}
