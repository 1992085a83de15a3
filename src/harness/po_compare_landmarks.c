#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_compare_parts.h"

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
      po_result *item = po_results_add(results, kase, point, check, name, suffix,
                                       load ? ours[i].load : ours[i].approach, expected);
      if (!item)
        return PO_NO_MEMORY;
      item->approach = ours[i].approach;
      item->load = ours[i].load;
    }
  return PO_OK;
}

po_status po_compare_landmarks(const po_case *kase, size_t point, const po_check *check,
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
