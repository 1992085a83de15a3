#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_case_internal.h"
#include "po_file.h"
#include "po_memory.h"
#include "po_series.h"

bool po_case_is_name(const char *text) {
  for (const char *c = text; *c; ++c)
    if (!isalnum((unsigned char)*c) && *c != '_' && *c != '-')
      return false;
  return *text != '\0' && *text != '-';
}

const char *po_case_word(const po_case *kase) {
  return kase->word ? kase->word : kase->file->name;
}

/* Returned: the bit of a wanted result; 0 if a name is unknown. */
static unsigned want_of(const char *name) {
  static const char *const OF_BRANCH[] = {"pull_off", "folds", "extrema"};
  const unsigned count = PO_WANT_COUNT + sizeof OF_BRANCH / sizeof *OF_BRANCH;
  for (unsigned k = 0; k < count; ++k)
    if (strcmp(name, k < PO_WANT_COUNT ? PO_WANTS[k] : OF_BRANCH[k - PO_WANT_COUNT]) == 0)
      return 1U << k;
  return 0;
}

static po_status parse_names(po_case *kase, const po_yaml *yaml) {
  const po_case_file *file = kase->file;
  if (!po_case_is_name(file->name) || strlen(file->name) > 64)
    return po_fields_refuse(yaml, NULL, "name");
  if (strcmp(file->name, PO_CASE_FOLDER_OF_SOLVERS) == 0)
    return po_fields_refuse(yaml, "another name: records of external solvers are in this folder",
                            "name");
  if (file->figure_script && !po_case_is_name(file->figure_script))
    return po_fields_refuse(yaml, NULL, "figure_script");
  for (unsigned i = 0; i < file->suite_names_count; ++i)
    if (!po_case_is_name(file->suite_names[i]))
      return po_fields_refuse(yaml, "letters, digits, _ and -", "suites[%u]", i + 1);
  for (unsigned i = 0; i < file->want_names_count; ++i) {
    const unsigned want = want_of(file->want_names[i]);
    if (!want)
      return po_fields_refuse(yaml,
                              "pull_off, folds, extrema, curve, profile, hysteresis, diagnostics, "
                              "preload, theories, loop or history",
                              "want[%u]", i + 1);
    kase->want |= want | (want == PO_WANT_LOOP ? PO_WANT_HYSTERESIS : 0U);
  }
  return PO_OK;
}

static po_status parse_repeats(po_case *kase, const po_yaml *yaml) {
  size_t repeats = 1;
  if (kase->file->repeats_text &&
      (!po_number_parse_count(kase->file->repeats_text, &repeats) || repeats < 1 || repeats > 1000))
    return po_fields_refuse(yaml, NULL, "repeats");
  kase->repeats = (unsigned)repeats;
  return PO_OK;
}

static po_status check_complete(const po_check *check, unsigned number, const po_yaml *yaml) {
  const char *missing = !check->tolerance_text ? "tolerance"
                        : !check->kind_text    ? "kind"
                        : !check->because      ? "because"
                                               : NULL;
  return missing ? po_fields_refuse(yaml, NULL, "checks[%u].%s", number, missing) : PO_OK;
}

static bool is_blank(const char *text) {
  return text[strspn(text, " \t\n")] == '\0';
}

/* Refuses the first rule that a check breaks. */
static po_status check_rules(const po_check *check, unsigned number, const po_yaml *yaml) {
  static const char OF_VALUES[] = "bradley or the path of a CSV file";
  const bool table = check->type == PO_REFERENCE_TABLE, curve = check->quantity == PO_CURVE,
             share = check->quantity == PO_SOLVED_SHARE,
             diagnostic = po_quantity_is(check->quantity, PO_OF_DIAGNOSTICS),
             relative = check->kind != PO_TOLERANCE_ABS;
  const struct {
    bool broken;
    const char *member, *expected; /* NULL: as the schema says */
  } rules[] = {
      {!(check->tolerance > 0), "tolerance", NULL},
      {check->kind > PO_TOLERANCE_ULP, "kind", NULL},
      {curve && relative, "kind", "abs, as the distance between curves is absolute"},
      {diagnostic && check->type != PO_REFERENCE_ZERO, "reference",
       "zero, as the quantity vanishes for an exact solution"},
      {!diagnostic && check->type == PO_REFERENCE_ZERO, "reference", OF_VALUES},
      {diagnostic && relative, "kind", "abs, as the reference is zero"},
      {po_quantity_is(check->quantity, PO_OF_LOOP) && !table, "reference",
       "the path of a CSV file, as only tables contain hysteresis"},
      {po_quantity_is_steps(check->quantity) && !table, "reference",
       "the path of a CSV file, as only tables contain steps"},
      {share && check->type != PO_REFERENCE_EVERY_SCENE, "reference",
       "every_scene, as the share refers to all scenes of the case"},
      {!share && check->type == PO_REFERENCE_EVERY_SCENE, "reference", OF_VALUES},
      {share && relative, "kind", "abs, as a share is absolute"},
      {share && check->tolerance >= 1, "tolerance", "the share that may fail, below 1"},
      {is_blank(check->because), "because", NULL},
      {check->as_if_count && check->type == PO_REFERENCE_TRACED, "reference",
       "a reference other than traced, as as_if selects another scene"},
  };
  for (size_t i = 0; i < sizeof rules / sizeof *rules; ++i)
    if (rules[i].broken)
      return po_fields_refuse(yaml, rules[i].expected, "checks[%u].%s", number, rules[i].member);
  for (unsigned i = 0; i < check->as_if_count; ++i)
    if (check->as_if[i].values_count > 1)
      return po_fields_refuse(yaml, "one value", "checks[%u].as_if[%u].values", number, i + 1);
  return PO_OK;
}

static po_status parse_check(po_check *check, unsigned number, const po_yaml *yaml) {
  static const char *const KINDS[] = {"abs", "rel", "ulp"};
  const int quantity = po_quantity_of_name(check->quantity_text);
  int kind = 0;
  if (quantity == PO_QUANTITY_COUNT)
    return po_fields_refuse(yaml, NULL, "checks[%u].quantity", number);
  check->quantity = (po_quantity)quantity;
  check->type = po_reference_type_of(check->reference);
  const po_status complete = check_complete(check, number, yaml);
  if (complete)
    return complete;
  if (!po_number_parse(check->tolerance_text, &check->tolerance))
    check->tolerance = (double)NAN;
  char path[PO_CASE_WHERE_LENGTH];
  snprintf(path, sizeof path, "checks[%u].tolerance", number);
  check->tolerance_line = po_yaml_line(yaml, path);
  while (kind <= PO_TOLERANCE_ULP && strcmp(check->kind_text, KINDS[kind]) != 0)
    ++kind;
  check->kind = (po_tolerance_kind)kind;
  return check_rules(check, number, yaml);
}

/* A measurement compares with an independent value, and has no tolerance. */
static po_status parse_measure(po_check *measure, unsigned number, const po_yaml *yaml) {
  const int quantity = po_quantity_of_name(measure->quantity_text);
  if (quantity == PO_QUANTITY_COUNT || (!po_quantity_is((po_quantity)quantity, PO_OF_PULL_OFF) &&
                                        !po_quantity_is((po_quantity)quantity, PO_OF_BRANCH)))
    return po_fields_refuse(yaml, NULL, "measure[%u].quantity", number);
  measure->type = po_reference_type_of(measure->reference);
  if (measure->type != PO_REFERENCE_BRADLEY && measure->type != PO_REFERENCE_TABLE)
    return po_fields_refuse(yaml, NULL, "measure[%u].reference", number);
  measure->quantity = (po_quantity)quantity;
  measure->tolerance = (double)INFINITY;
  measure->kind = PO_TOLERANCE_ABS;
  return PO_OK;
}

/* A stand-in must be the reference of a check without stand-in. Otherwise nothing would be compared
 * when the table is absent. */
static po_status check_stand_ins(po_case *kase, const po_yaml *yaml) {
  const po_case_file *file = kase->file;
  for (unsigned i = 0; i < file->checks_count; ++i) {
    bool found = !file->checks[i].stand_in;
    for (unsigned k = 0; k < file->checks_count && !found; ++k)
      found = !file->checks[k].stand_in &&
              strcmp(file->checks[k].reference, file->checks[i].stand_in) == 0;
    if (!found)
      return po_fields_refuse(yaml, NULL, "checks[%u].stand_in", i + 1);
    if (file->checks[i].stand_in && file->checks[i].type != PO_REFERENCE_TABLE)
      return po_fields_refuse(yaml, "the path of a CSV file, as it has a stand-in",
                              "checks[%u].reference", i + 1);
  }
  return PO_OK;
}

const po_check *po_case_check(const po_case_file *file, unsigned index) {
  if (index < file->checks_count)
    return &file->checks[index];
  index -= file->checks_count;
  return index < file->measure_count ? &file->measure[index] : NULL;
}

static bool concerns_none(const po_case *kase, const po_check *check) {
  for (size_t k = 0; k < kase->point_count; ++k)
    if (po_check_concerns(check, &kase->points[k].request) &&
        (kase->points[k].traced || check->type != PO_REFERENCE_TRACED))
      return false;
  return true;
}

/* A check that applies to no point would never fail, and nobody would notice. */
static po_status check_concerned(po_case *kase, const po_yaml *yaml) {
  const po_case_file *file = kase->file;
  static const char EXPECTED[] = "a condition that holds for at least one point";
  for (unsigned i = 0; i < file->checks_count; ++i)
    if (concerns_none(kase, &file->checks[i]))
      return po_fields_refuse(yaml, EXPECTED, "checks[%u].when", i + 1);
  for (unsigned i = 0; i < file->measure_count; ++i)
    if (concerns_none(kase, &file->measure[i]))
      return po_fields_refuse(yaml, EXPECTED, "measure[%u].when", i + 1);
  for (unsigned i = 0; i < file->leave_out_count; ++i)
    if (!file->leave_out[i].points)
      return po_fields_refuse(yaml, EXPECTED, "leave_out[%u].when", i + 1);
  return PO_OK;
}

static po_status parse_checks(po_case *kase, const po_yaml *yaml) {
  const po_case_file *file = kase->file;
  po_status status = PO_OK;
  for (unsigned i = 0; !status && i < file->checks_count; ++i)
    status = parse_check(&file->checks[i], i + 1, yaml);
  for (unsigned i = 0; !status && i < file->measure_count; ++i)
    status = parse_measure(&file->measure[i], i + 1, yaml);
  for (unsigned i = 0; !status && i < file->leave_out_count; ++i)
    if (is_blank(file->leave_out[i].because))
      status = po_fields_refuse(yaml, NULL, "leave_out[%u].because", i + 1);
  return status ? status : po_case_each_axis(kase, yaml, po_case_axis_check);
}

/* Series of scenes in parameter continuation: the keys `follow`, `checkpoint_every` and `traced`.
 */

static const size_t MOST_BETWEEN_CHECKPOINTS = 1000;

static po_status parse_checkpoints(po_case *kase, const po_yaml *yaml) {
  const po_case_file *file = kase->file;
  kase->checkpoints = PO_CHECKPOINT_EVERY;
  if (file->checkpoints_text &&
      (!file->follow || !po_number_parse_count(file->checkpoints_text, &kase->checkpoints) ||
       kase->checkpoints < 1 || kase->checkpoints > MOST_BETWEEN_CHECKPOINTS))
    return po_fields_refuse(yaml, NULL, "checkpoint_every");
  return PO_OK;
}

static po_status parse_follow(po_case *kase, const po_yaml *yaml) {
  const po_case_file *file = kase->file;
  kase->series_length = 1;
  const po_status status = parse_checkpoints(kase, yaml);
  if (status || !file->follow)
    return status;
  const po_axis *last = file->sweep_count ? &file->sweep[file->sweep_count - 1].axis : NULL;
  if (!last || !last->key || strcmp(last->key, file->follow) != 0 ||
      !po_key_is_continuous(po_texts_key(file->follow)))
    return po_fields_refuse(yaml, NULL, "follow");
  if (kase->uncertain_count)
    return po_fields_refuse(
        yaml, "it to be left out, as scenes with uncertain numbers (+-) are traced", "follow");
  kase->series_length = last->values_count;
  if (file->leave_out_count)
    return po_fields_refuse(yaml, "no rules, as a series in follow is solved as a whole",
                            "leave_out");
  if (kase->repeats > 1)
    return po_fields_refuse(yaml, "1, as series in follow are not timed", "repeats");
  for (unsigned i = 0; i < file->want_names_count; ++i)
    if (strcmp(file->want_names[i], "pull_off") != 0)
      return po_fields_refuse(yaml, "pull_off alone, as follow continues only the pull-off",
                              "want[%u]", i + 1);
  for (unsigned i = 0; i < file->checks_count; ++i) {
    const po_quantity quantity = file->checks[i].quantity;
    if (!po_quantity_is(quantity, PO_OF_PULL_OFF) && quantity != PO_SOLVED_SHARE)
      return po_fields_refuse(yaml,
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
      return po_fields_refuse(yaml,
                              "traced only for a pull-off, in a case with `traced: {seed, count}`",
                              "checks[%u].reference", i + 1);
    checked = checked || check->type == PO_REFERENCE_TRACED;
  }
  if (!checked)
    return po_fields_refuse(yaml, "a check against traced", "traced");
  return file->traced && !file->follow ? po_fields_refuse(yaml, NULL, "traced") : PO_OK;
}

static po_status parse_series(po_case *kase, const po_yaml *yaml) {
  const po_status status = parse_follow(kase, yaml);
  return status ? status : parse_traced(kase->file, yaml);
}

/* Checks every value of kase->file and fills want, repeats, checks and points. Status:
 * PO_BAD_INPUT; the message states file, line, path, value and what was expected. */
static po_status parse_file(po_case *kase, const po_yaml *yaml) {
  static po_status (*const STEPS[])(po_case *, const po_yaml *) = {po_case_uncertain_scene,
                                                                   parse_names,
                                                                   parse_repeats,
                                                                   po_case_files_resolve,
                                                                   po_case_sweep_parse,
                                                                   po_case_scene_parse,
                                                                   parse_checks,
                                                                   po_case_lines_parse,
                                                                   parse_series,
                                                                   check_stand_ins,
                                                                   po_case_expand,
                                                                   po_case_scene_check,
                                                                   check_concerned};
  po_status status = PO_OK;
  for (size_t i = 0; !status && i < sizeof STEPS / sizeof *STEPS; ++i)
    status = STEPS[i](kase, yaml);
  return status;
}

po_status po_case_read(const char *path, const char *shown, po_case **result) {
  *result = NULL;
  po_yaml *yaml = NULL;
  po_case *kase = po_allocate(1, sizeof *kase);
  po_status status = kase ? PO_OK : PO_NO_MEMORY;
  if (!status && (!(kase->path = po_copy_text(path)) || !(kase->shown = po_copy_text(shown))))
    status = PO_NO_MEMORY;
  if (!status)
    status = po_file_read(path, &kase->source, &kase->source_size);
  if (!status && !(kase->file = po_allocate(1, sizeof *kase->file)))
    status = PO_NO_MEMORY;
  if (!status)
    status =
        po_fields_read(shown, kase->source, kase->source_size, PO_CASE_FIELDS, kase->file, &yaml);
  if (!status)
    status = parse_file(kase, yaml);
  po_yaml_destroy(yaml);
  if (status)
    po_case_destroy(kase);
  else
    *result = kase;
  return status;
}

/* Frees what po_case_axis_check allocated. */
static po_status clear_axis(const po_case *kase, po_axis *axis, const char *where,
                            const po_yaml *yaml) {
  (void)kase, (void)where, (void)yaml;
  free(axis->ascending);
  return PO_OK;
}

void po_case_destroy(po_case *kase) {
  if (!kase)
    return;
  for (size_t i = 0; kase->points && i < kase->point_count; ++i) {
    free(kase->points[i].label);
    po_case_uncertain_clear(&kase->points[i]);
  }
  free(kase->points);
  free(kase->uncertain);
  if (kase->file) {
    po_case_each_axis(kase, NULL, clear_axis);
    po_fields_clear(PO_CASE_FIELDS, kase->file);
  }
  free(kase->file);
  free(kase->source);
  free(kase->word);
  free(kase->shown);
  free(kase->path);
  free(kase);
}
