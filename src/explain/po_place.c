#include "po_place.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

#include "po_elementary.h"

/* Returned: special point number `index` in the list of all folds followed by all extrema. */
static const po_special_point *special(const po_result *result, size_t index) {
  return index < result->fold_count ? &result->folds[index]
                                    : &result->extrema[index - result->fold_count];
}

static void name(const po_result *result, size_t index, char words[32]) {
  const size_t number = index < result->fold_count ? index : index - result->fold_count;
  snprintf(words, 32, "%s-%zu", po_special_kind_name(special(result, index)->kind), number + 1);
}

/* Returned: the arclength of the nearest point of the curve; NAN without a curve. */
static double position_of(const po_result *result, double approach, double load) {
  double nearest = (double)INFINITY, position = (double)NAN;
  for (size_t i = 0; i < result->curve_count; ++i) {
    const po_curve_point *p = &result->curve[i];
    const double distance = po_hypot(p->approach - approach, p->load - load);
    if (distance < nearest) {
      nearest = distance;
      position = p->position;
    }
  }
  return position;
}

void po_place_describe(const po_result *result, double approach, double load,
                       char words[PO_PLACE_LENGTH]) {
  const size_t count = result->fold_count + result->extremum_count, none = count;
  const double position = position_of(result, approach, load);
  size_t before = none, after = none;
  words[0] = '\0';
  for (size_t i = 0; i < count; ++i) {
    const po_special_point *mark = special(result, i);
    if (mark->approach == approach && mark->load == load) {
      char at[32];
      name(result, i, at);
      snprintf(words, PO_PLACE_LENGTH, "at %s", at);
      return;
    }
    if (mark->position <= position &&
        (before == none || mark->position > special(result, before)->position))
      before = i;
    if (mark->position > position &&
        (after == none || mark->position < special(result, after)->position))
      after = i;
  }
  char first[32] = "", second[32] = "";
  if (before < none)
    name(result, before, first);
  if (after < none)
    name(result, after, second);
  if (*first && *second)
    snprintf(words, PO_PLACE_LENGTH, "between %s and %s", first, second);
  else if (*first || *second)
    snprintf(words, PO_PLACE_LENGTH, "%s %s", *first ? "after" : "before", *first ? first : second);
}
