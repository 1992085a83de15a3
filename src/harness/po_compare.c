#include "po_compare.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_curve.h"
#include "po_memory.h"

static const po_reference_number NOTHING = {(double)NAN, (double)NAN};

static bool is_single(po_quantity quantity) {
  return quantity == PO_PULL_OFF_FORCE || quantity == PO_PULL_OFF_APPROACH ||
         quantity == PO_FOLD_COUNT;
}

static double single_obtained(po_quantity quantity, const po_outcome *outcome) {
  if (quantity == PO_FOLD_COUNT)
    return outcome->status == PO_OK ? (double)outcome->fold_count : (double)NAN;
  if (!outcome->has_pull_off || outcome->status != PO_OK)
    return (double)NAN;
  return quantity == PO_PULL_OFF_FORCE ? outcome->pull_off.force : outcome->pull_off.approach;
}

static po_status compare_single(const po_case *kase, size_t point, const po_check *check,
                                const po_reference *reference, const po_outcome *outcome,
                                po_results *results) {
  po_reference_number expected = NOTHING;
  const po_status status =
      po_reference_find(reference, check->quantity, &kase->points[point].request, &expected);
  if (status && status != PO_NOT_FOUND)
    return status;
  if (status)
    expected = NOTHING;
  return po_results_add(results, kase, point, check, po_quantity_name(check->quantity), "",
                        single_obtained(check->quantity, outcome), expected)
             ? PO_OK
             : PO_NO_MEMORY;
}

/* Landmarks ahead of the start of the traced branch and beyond its end were not ours to find (NaN:
 * no such end). In between, along the branch, the approach may well be smaller than at the start.
 */
static size_t keep_in_range(po_reference_point *points, size_t count, const po_outcome *outcome) {
  size_t first = 0;
  while (first < count && points[first].approach < outcome->start)
    first += 1;
  while (count > first && points[count - 1].approach > outcome->end)
    count -= 1;
  memmove(points, points + first, (count - first) * sizeof *points);
  return count - first;
}

/* The two lists correspond when they have the same kinds in the same order. */
static bool lists_correspond(const po_landmark *ours, size_t count,
                             const po_reference_point *theirs, size_t their_count) {
  bool same = count == their_count;
  for (size_t i = 0; same && i < count; ++i)
    same = ours[i].kind == theirs[i].kind;
  return same;
}

/* What distinguishes lists that do not correspond: of the longer one, the landmark that is furthest
 * from all of its kind in the other. */
static void tell_difference(const po_landmark *ours, size_t count, const po_reference_point *theirs,
                            size_t their_count, char *note, size_t size) {
  const bool missing = their_count > count;
  const size_t more = missing ? their_count : count, fewer = missing ? count : their_count;
  double furthest = -1;
  size_t named = 0;
  for (size_t i = 0; i < more; ++i) {
    double nearest = (double)INFINITY;
    for (size_t j = 0; j < fewer; ++j) {
      const po_landmark *a = &ours[missing ? j : i];
      const po_reference_point *b = &theirs[missing ? i : j];
      if (a->kind == b->kind)
        nearest = fmin(nearest, hypot(a->approach - b->approach, a->load - b->load));
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
           po_landmark_kind_name(missing ? theirs[named].kind : ours[named].kind),
           missing ? theirs[named].approach : ours[named].approach,
           missing ? theirs[named].load : ours[named].load, count, their_count);
}

static po_status add_pairs(const po_case *kase, size_t point, const po_check *check,
                           const po_landmark *ours, const po_reference_point *theirs, size_t count,
                           po_results *results) {
  const bool folds = check->quantity == PO_FOLDS;
  for (size_t i = 0; i < count; ++i)
    for (int load = 0; load < 2; ++load) {
      char suffix[64];
      snprintf(suffix, sizeof suffix, "%s-%zu/%s", po_landmark_kind_name(ours[i].kind), i + 1,
               load ? "load" : "approach");
      const char *name = load ? (folds ? "fold_load" : "extremum_load")
                              : (folds ? "fold_approach" : "extremum_approach");
      const po_reference_number expected = {load ? theirs[i].load : theirs[i].approach,
                                            load ? theirs[i].load_uncertainty
                                                 : theirs[i].approach_uncertainty};
      if (!po_results_add(results, kase, point, check, name, suffix,
                          load ? ours[i].load : ours[i].approach, expected))
        return PO_NO_MEMORY;
    }
  return PO_OK;
}

static po_status compare_landmarks(const po_case *kase, size_t point, const po_check *check,
                                   const po_reference *reference, const po_outcome *outcome,
                                   po_results *results) {
  const bool folds = check->quantity == PO_FOLDS;
  const po_landmark *ours = folds ? outcome->folds : outcome->extrema;
  const size_t count = folds ? outcome->fold_count : outcome->extremum_count;
  const char *count_name = folds ? "fold_count" : "extremum_count";
  po_reference_point *theirs = NULL;
  size_t their_count = 0;
  po_status status = po_reference_points(reference, check->quantity, &kase->points[point].request,
                                         outcome, &theirs, &their_count);
  const bool spoken = status == PO_OK, solved = outcome->status == PO_OK;
  if (status == PO_NOT_FOUND)
    status = PO_OK;
  if (!status && spoken && solved)
    their_count = keep_in_range(theirs, their_count, outcome);
  if (!status) {
    const po_reference_number expected = {spoken ? (double)their_count : (double)NAN, 0};
    po_result *item = po_results_add(results, kase, point, check, count_name, "count",
                                     solved ? (double)count : (double)NAN, expected);
    if (!item)
      status = PO_NO_MEMORY;
    else if (spoken && solved && !lists_correspond(ours, count, theirs, their_count)) {
      item->verdict = PO_OUTSIDE;
      tell_difference(ours, count, theirs, their_count, item->note, sizeof item->note);
    } else if (spoken && solved)
      status = add_pairs(kase, point, check, ours, theirs, count, results);
  }
  free(theirs);
  return status;
}

static po_status compare_planes(const po_outcome *outcome, const po_reference_point *theirs,
                                size_t their_count, bool scattered, double tolerance,
                                po_curve_verdict *verdict) {
  po_plane_point *a = po_allocate(outcome->curve_count, sizeof *a);
  po_plane_point *b = po_allocate(their_count, sizeof *b);
  po_status status = a && b ? PO_OK : PO_NO_MEMORY;
  if (!status) {
    for (size_t i = 0; i < outcome->curve_count; ++i)
      a[i] = (po_plane_point){outcome->curve[i].approach, outcome->curve[i].load};
    for (size_t i = 0; i < their_count; ++i)
      b[i] = (po_plane_point){theirs[i].approach, theirs[i].load};
    if (scattered)
      po_curve_scatter(a, outcome->curve_count, b, their_count, verdict);
    else
      status = po_curve_compare(a, outcome->curve_count, b, their_count, tolerance, verdict);
  }
  free(a);
  free(b);
  return status;
}

static po_status compare_curve(const po_case *kase, size_t point, const po_check *check,
                               const po_reference *reference, const po_outcome *outcome,
                               po_results *results) {
  po_reference_point *theirs = NULL;
  size_t count = 0;
  po_curve_verdict found = {0};
  po_status status = po_reference_points(reference, PO_CURVE, &kase->points[point].request, outcome,
                                         &theirs, &count);
  const bool spoken = status == PO_OK;
  double doubt = (double)NAN;
  for (size_t i = 0; spoken && i < count; ++i)
    doubt = fmax(doubt, fmax(theirs[i].approach_uncertainty, theirs[i].load_uncertainty));
  if (spoken)
    /* markers read off a figure do not run along the branch */
    status = compare_planes(outcome, theirs, count, reference->ledger == PO_LEDGER_PUBLISHED,
                            check->tolerance, &found);
  free(theirs);
  if (status && status != PO_NOT_FOUND)
    return status;
  const bool compared = spoken && found.compared > 0 && outcome->status == PO_OK;
  po_result *item = po_results_add(results, kase, point, check, "curve", "",
                                   compared ? found.distance : (double)NAN,
                                   (po_reference_number){spoken ? 0 : (double)NAN, doubt});
  if (!item)
    return PO_NO_MEMORY;
  item->obtained = item->expected = (double)NAN;
  if (!compared)
    return PO_OK;
  if (!found.same_folds)
    item->verdict = PO_OUTSIDE;
  if (found.note[0])
    snprintf(item->note, sizeof item->note, "%s", found.note);
  else
    snprintf(item->note, sizeof item->note,
             "furthest near approach %.4g, load %.4g; %zu points compared, %zu beyond the ends",
             found.where.approach, found.where.load, found.compared, found.left_out);
  return PO_OK;
}

po_status po_compare(const po_case *kase, size_t point, const po_check *check,
                     const po_reference *reference, const po_outcome *outcome,
                     po_results *results) {
  if (reference->is_absent || !po_check_concerns(check, &kase->points[point].request))
    return PO_OK;
  const size_t before = results->count;
  po_status status = PO_OK;
  if (is_single(check->quantity))
    status = compare_single(kase, point, check, reference, outcome, results);
  else if (check->quantity == PO_CURVE)
    status = compare_curve(kase, point, check, reference, outcome, results);
  else
    status = compare_landmarks(kase, point, check, reference, outcome, results);
  for (size_t i = before; i < results->count; ++i) {
    po_result *item = &results->items[i];
    item->ledger = reference->ledger;
    if (item->verdict == PO_NO_RESULT && outcome->status)
      snprintf(item->note, sizeof item->note, "%.190s", outcome->reason);
    else if (item->verdict == PO_NO_RESULT)
      snprintf(item->note, sizeof item->note, "nothing to compare over a common range");
    else if (item->verdict == PO_MISSING_REFERENCE)
      snprintf(item->note, sizeof item->note, "the reference does not speak of this scene");
  }
  return status;
}
