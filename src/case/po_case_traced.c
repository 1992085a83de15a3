/* The key `traced` of a case: scenes of a series that are traced in addition, for comparison. */
#include <math.h>

#include "po_case_parts.h"
#include "po_random.h"
#include "po_schema.h"

/* Reports whether a point lies between two checkpoints. Checkpoints, and the last scene of a
 * series, are always traced. */
static bool is_between(const po_case *kase, size_t point) {
  const size_t place = point % kase->series_length;
  return place % kase->checkpoints != 0 && place + 1 != kase->series_length;
}

static bool can_be_traced(const po_case_file *file, const po_check *check) {
  return file->traced && po_quantity_is_pull_off(check->quantity);
}

po_status po_case_traced_parse(const po_case *kase, const po_yaml *yaml) {
  const po_case_file *file = kase->file;
  bool checked = !file->traced;
  for (unsigned i = 0; i < file->checks_count; ++i) {
    const po_check *check = &file->checks[i];
    if (po_check_is_traced(check) && !can_be_traced(file, check))
      return po_schema_refuse(yaml,
                              "traced only for a pull-off, in a case with `traced: {seed, count}`",
                              "checks[%u].reference", i + 1);
    checked = checked || po_check_is_traced(check);
  }
  if (!checked)
    return po_schema_refuse(yaml, "a check against traced", "traced");
  return file->traced && !file->follow ? po_schema_refuse(yaml, NULL, "traced") : PO_OK;
}

po_status po_case_traced_draw(po_case *kase, const po_yaml *yaml) {
  const po_traced_words *words = kase->file->traced;
  size_t seed = 0, count = 0, between = 0;
  if (!words)
    return PO_OK;
  for (size_t i = 0; i < kase->point_count; ++i)
    between += is_between(kase, i);
  if (!po_number_parse_count(words->seed_text, &seed))
    return po_schema_refuse(yaml, NULL, "traced.seed");
  if (!po_number_parse_count(words->count_text, &count) || count < 1 || count > between)
    return po_schema_refuse(yaml, NULL, "traced.count");
  for (uint64_t draw = 0; count > 0; ++draw) { /* skips checkpoints and repeated scenes */
    const double part = po_random_uniform(seed, draw, "traced");
    const size_t i = (size_t)floor(part * (double)kase->point_count);
    if (!is_between(kase, i) || kase->points[i].traced)
      continue;
    kase->points[i].traced = true;
    count -= 1;
  }
  return PO_OK;
}
