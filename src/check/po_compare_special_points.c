#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_compare_parts.h"
#include "po_elementary.h"

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

po_status po_compare_special_points(const po_case *kase, size_t point, const po_check *check,
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
