#include "po_place.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

/* Landmark number `index` of the folds, then of the extrema. */
static const po_landmark *landmark(const po_outcome *outcome, size_t index) {
  return index < outcome->fold_count ? &outcome->folds[index]
                                     : &outcome->extrema[index - outcome->fold_count];
}

static void name(const po_outcome *outcome, size_t index, char words[32]) {
  const size_t number = index < outcome->fold_count ? index : index - outcome->fold_count;
  snprintf(words, 32, "%s-%zu", po_landmark_kind_name(landmark(outcome, index)->kind), number + 1);
}

/* The arclength at which the curve passes nearest; NAN without a curve. */
static double position_of(const po_outcome *outcome, double approach, double load) {
  double nearest = (double)INFINITY, position = (double)NAN;
  for (size_t i = 0; i < outcome->curve_count; ++i) {
    const po_curve_point *p = &outcome->curve[i];
    const double distance = hypot(p->approach - approach, p->load - load);
    if (distance < nearest) {
      nearest = distance;
      position = p->position;
    }
  }
  return position;
}

void po_place_tell(const po_outcome *outcome, double approach, double load,
                   char words[PO_PLACE_LENGTH]) {
  const size_t count = outcome->fold_count + outcome->extremum_count, none = count;
  const double position = position_of(outcome, approach, load);
  size_t before = none, after = none;
  words[0] = '\0';
  for (size_t i = 0; i < count; ++i) {
    const po_landmark *mark = landmark(outcome, i);
    if (mark->approach == approach && mark->load == load) {
      char at[32];
      name(outcome, i, at);
      snprintf(words, PO_PLACE_LENGTH, "at %s", at);
      return;
    }
    if (mark->position <= position &&
        (before == none || mark->position > landmark(outcome, before)->position))
      before = i;
    if (mark->position > position &&
        (after == none || mark->position < landmark(outcome, after)->position))
      after = i;
  }
  char first[32] = "", second[32] = "";
  if (before < none)
    name(outcome, before, first);
  if (after < none)
    name(outcome, after, second);
  if (*first && *second)
    snprintf(words, PO_PLACE_LENGTH, "between %s and %s", first, second);
  else if (*first || *second)
    snprintf(words, PO_PLACE_LENGTH, "%s %s", *first ? "after" : "before", *first ? first : second);
}
