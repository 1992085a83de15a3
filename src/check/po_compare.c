#include "po_compare.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_compare_parts.h"
#include "po_curve.h"
#include "po_elementary.h"
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
                                  const po_request *request, const po_result *result) {
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
  else if (item->verdict == PO_MISSING_REFERENCE) {
    po_text nearest = {0};
    const bool found =
        reference->type == PO_REFERENCE_TABLE && po_reference_nearest(reference, request, &nearest);
    snprintf(item->note, size, "the reference does not contain this scene%s%.150s",
             found ? "; " : "", po_text_string(&nearest));
    po_text_clear(&nearest);
  }
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

/* The folds or the extrema of a result and of the reference, over the common range. */
typedef struct {
  const po_special_point *ours;
  size_t count;
  po_reference_point *theirs; /* to be freed */
  size_t their_count;
  bool known, solved; /* the reference contains the scene; the scene was solved */
} special_point_lists;

/* Removes the special points before the start of the traced branch (NAN: the branch has no limited
 * start), which are those that the traced branch lacks. Only the first ones of the list are
 * removed: later on the branch the approach can again be smaller than at the start. */
static size_t drop_before_start(po_reference_point *points, size_t count, size_t traced,
                                double start) {
  size_t first = 0;
  while (count - first > traced && points[first].approach < start)
    first += 1;
  memmove(points, points + first, (count - first) * sizeof *points);
  return count - first;
}

/* Counts the special points up to the end of the shorter of two branches. On a wavy sphere the
 * number of folds is unlimited, and later folds may have a smaller approach than the end of the
 * shorter branch. If that branch ends while its approach increases, the next fold of the longer
 * branch is a jump_in at a larger approach than the end; this fold and all later ones have no
 * counterpart.
 * Given: `found`, the number of special points of the shorter branch, which all have a counterpart;
 * `end`, the approach of its end. */
static size_t count_ours_up_to(const po_special_point *ours, size_t count, size_t found,
                               double end) {
  for (size_t i = found; i < count; ++i)
    if (ours[i].approach > end)
      return i;
  return count;
}

static size_t count_theirs_up_to(const po_reference_point *theirs, size_t count, size_t found,
                                 double end) {
  for (size_t i = found; i < count; ++i)
    if (theirs[i].approach > end)
      return i;
  return count;
}

/* Finds both lists over the common range. */
static po_status find_lists(const po_request *request, bool folds, const po_reference *reference,
                            const po_result *result, special_point_lists *l) {
  *l = (special_point_lists){.ours = folds ? result->folds : result->extrema,
                             .count = folds ? result->fold_count : result->extremum_count,
                             .solved = result->status == PO_OK};
  po_status status = po_reference_points(reference, folds ? PO_FOLDS : PO_EXTREMA, request, result,
                                         &l->theirs, &l->their_count);
  if (status == PO_NOT_FOUND)
    return PO_OK;
  double complete_to = (double)INFINITY;
  if (!status)
    status = po_reference_complete_to(reference, request, &complete_to);
  if (status)
    return status;
  l->known = true;
  if (!l->solved)
    return PO_OK;
  l->their_count = drop_before_start(l->theirs, l->their_count, l->count, result->start);
  const size_t ours = l->count, theirs = l->their_count;
  l->count = count_ours_up_to(l->ours, ours, theirs, complete_to);
  l->their_count = count_theirs_up_to(l->theirs, theirs, ours, result->ended.approach);
  return PO_OK;
}

/* Reports whether the two lists have the same kinds of special points in the same order. */
static bool lists_correspond(const po_special_point *ours, size_t count,
                             const po_reference_point *theirs, size_t their_count) {
  bool same = count == their_count;
  for (size_t i = 0; same && i < count; ++i)
    same = ours[i].kind == theirs[i].kind;
  return same;
}

/* Describes the difference of two lists: names the special point of the longer list that is
 * furthest from all points of its kind in the other list. */
static void describe_difference(const po_special_point *ours, size_t count,
                                const po_reference_point *theirs, size_t their_count, char *note,
                                size_t size) {
  const bool missing = their_count > count;
  const size_t more = missing ? their_count : count, fewer = missing ? count : their_count;
  double furthest = -1;
  size_t named = 0;
  for (size_t i = 0; i < more; ++i) {
    double nearest = (double)INFINITY;
    for (size_t j = 0; j < fewer; ++j) {
      const po_special_point *a = &ours[missing ? j : i];
      const po_reference_point *b = &theirs[missing ? i : j];
      if (a->kind == b->kind)
        nearest = fmin(nearest, po_hypot(a->approach - b->approach, a->load - b->load));
    }
    if (nearest > furthest) {
      furthest = nearest;
      named = i;
    }
  }
  if (more == 0)
    return;
  snprintf(note, size, "%s %s near approach %.4g, load %.4g (%zu found, reference %zu)",
           missing ? "missing" : "spurious",
           po_special_kind_name(missing ? theirs[named].kind : ours[named].kind),
           missing ? theirs[named].approach : ours[named].approach,
           missing ? theirs[named].load : ours[named].load, count, their_count);
}

static po_status add_pairs(const po_case *kase, size_t point, const po_check *check,
                           const po_special_point *ours, const po_reference_point *theirs,
                           size_t count, po_check_results *check_results) {
  const bool folds = check->quantity == PO_FOLDS;
  for (size_t i = 0; i < count; ++i)
    for (int load = 0; load < 2; ++load) {
      char suffix[64];
      snprintf(suffix, sizeof suffix, "%s-%zu/%s", po_special_kind_name(ours[i].kind), i + 1,
               load ? "load" : "approach");
      const char *name = load ? (folds ? "fold_load" : "extremum_load")
                              : (folds ? "fold_approach" : "extremum_approach");
      const po_reference_number expected = {load ? theirs[i].load : theirs[i].approach,
                                            load ? theirs[i].load_uncertainty
                                                 : theirs[i].approach_uncertainty};
      po_check_result *item =
          po_check_results_add(check_results, kase, point, check, name, suffix,
                               load ? ours[i].load : ours[i].approach, expected);
      if (!item)
        return PO_NO_MEMORY;
      item->approach = ours[i].approach;
      item->load = ours[i].load;
    }
  return PO_OK;
}

/* Compares folds or extrema: their number and kinds, and, if these agree, approach and load of
 * each. Status: as po_compare. */
static po_status compare_special_points(const po_case *kase, size_t point, const po_check *check,
                                        const po_reference *reference, const po_result *result,
                                        po_check_results *check_results) {
  const po_request request = po_check_request(check, &kase->points[point].request);
  const bool count_only = check->quantity == PO_FOLD_COUNT;
  const bool folds = check->quantity != PO_EXTREMA;
  special_point_lists l;
  po_status status = find_lists(&request, folds, reference, result, &l);
  if (!status) {
    const po_reference_number expected = {l.known ? (double)l.their_count : (double)NAN, 0};
    po_check_result *item = po_check_results_add(
        check_results, kase, point, check, folds ? "fold_count" : "extremum_count",
        count_only ? "" : "count", l.solved ? (double)l.count : (double)NAN, expected);
    if (!item)
      status = PO_NO_MEMORY;
    else if (!l.known || !l.solved || (count_only && l.count == l.their_count))
      status = PO_OK;
    else if (!lists_correspond(l.ours, l.count, l.theirs, l.their_count)) {
      if (!count_only)
        item->verdict = PO_OUTSIDE;
      describe_difference(l.ours, l.count, l.theirs, l.their_count, item->note, sizeof item->note);
    } else
      status = add_pairs(kase, point, check, l.ours, l.theirs, l.count, check_results);
  }
  free(l.theirs);
  return status;
}

po_status po_compare(const po_case *kase, size_t point, const po_check *check,
                     const po_reference *reference, const po_result *result,
                     po_check_results *check_results) {
  if (reference->type == PO_REFERENCE_ABSENT ||
      !po_check_concerns(check, &kase->points[point].request))
    return PO_OK;
  const size_t before = check_results->count;
  const po_request request = po_check_request(check, &kase->points[point].request);
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
    status = compare_special_points(kase, point, check, reference, result, check_results);
  for (size_t i = before; i < check_results->count; ++i) {
    check_results->items[i].ledger = reference->ledger;
    explain_no_comparison(&check_results->items[i], reference, &request, result);
  }
  return status;
}
