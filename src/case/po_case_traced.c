/* Series of scenes in parameter continuation: the keys `follow`, `checkpoint_every` and `traced`.
 */
#include <math.h>
#include <string.h>

#include "po_case_parts.h"
#include "po_random.h"
#include "po_series.h"

static const size_t MOST_BETWEEN_CHECKPOINTS = 1000;

static po_status parse_checkpoints(po_case *kase, const po_yaml *yaml) {
  const po_case_file *file = kase->file;
  kase->checkpoints = PO_CHECKPOINT_EVERY;
  if (file->checkpoints_text &&
      (!file->follow || !po_number_parse_count(file->checkpoints_text, &kase->checkpoints) ||
       kase->checkpoints < 1 || kase->checkpoints > MOST_BETWEEN_CHECKPOINTS))
    return po_schema_refuse(yaml, NULL, "checkpoint_every");
  return PO_OK;
}

/* Reports whether a name is that of a continuous parameter of the scene, or of a group. */
static bool can_be_followed(const char *name) {
  return po_key_is_continuous(po_key_of_name(name));
}

static po_status parse_follow(po_case *kase, const po_yaml *yaml) {
  const po_case_file *file = kase->file;
  kase->series_length = 1;
  const po_status status = parse_checkpoints(kase, yaml);
  if (status || !file->follow)
    return status;
  const po_axis *last = file->sweep_count ? &file->sweep[file->sweep_count - 1].axis : NULL;
  if (!last || !last->key || strcmp(last->key, file->follow) != 0 || !can_be_followed(file->follow))
    return po_schema_refuse(yaml, NULL, "follow");
  kase->series_length = last->values_count;
  if (file->leave_out_count)
    return po_schema_refuse(yaml, "no rules, as a series in follow is solved as a whole",
                            "leave_out");
  if (kase->repeats > 1)
    return po_schema_refuse(yaml, "1, as series in follow are not timed", "repeats");
  for (unsigned i = 0; i < file->want_names_count; ++i)
    if (strcmp(file->want_names[i], "pull_off") != 0)
      return po_schema_refuse(yaml, "pull_off alone, as follow continues only the pull-off",
                              "want[%u]", i + 1);
  for (unsigned i = 0; i < file->checks_count; ++i) {
    const po_quantity quantity = file->checks[i].quantity;
    if (!po_quantity_is(quantity, PO_OF_PULL_OFF) && quantity != PO_SOLVED_SHARE)
      return po_schema_refuse(yaml,
                              "pull_off_force, pull_off_approach, contact_radius or solved_share, "
                              "as follow continues only the pull-off",
                              "checks[%u].quantity", i + 1);
  }
  return PO_OK;
}

/* The key `traced`: scenes of a series that are traced in addition, for comparison. */

static bool can_be_traced(const po_case_file *file, const po_check *check) {
  return file->traced && po_quantity_is(check->quantity, PO_OF_PULL_OFF);
}

static po_status parse_traced(const po_case_file *file, const po_yaml *yaml) {
  bool checked = !file->traced;
  for (unsigned i = 0; i < file->checks_count; ++i) {
    const po_check *check = &file->checks[i];
    if (check->type == PO_REFERENCE_TRACED && !can_be_traced(file, check))
      return po_schema_refuse(yaml,
                              "traced only for a pull-off, in a case with `traced: {seed, count}`",
                              "checks[%u].reference", i + 1);
    checked = checked || check->type == PO_REFERENCE_TRACED;
  }
  if (!checked)
    return po_schema_refuse(yaml, "a check against traced", "traced");
  return file->traced && !file->follow ? po_schema_refuse(yaml, NULL, "traced") : PO_OK;
}

po_status po_case_series_parse(po_case *kase, const po_yaml *yaml) {
  const po_status status = parse_follow(kase, yaml);
  return status ? status : parse_traced(kase->file, yaml);
}

/* Reports whether a point lies between two checkpoints. Checkpoints, and the last scene of a
 * series, are always traced. */
static bool is_between(const po_case *kase, size_t point) {
  const size_t place = point % kase->series_length;
  return place % kase->checkpoints != 0 && place + 1 != kase->series_length;
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
