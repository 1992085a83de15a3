#include "po_case_parse.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "po_lines.h"
#include "po_schema.h"

enum { WHERE_LENGTH = 64 };

bool po_case_is_name(const char *text) {
  for (const char *c = text; *c; ++c)
    if (!isalnum((unsigned char)*c) && *c != '_' && *c != '-')
      return false;
  return *text != '\0' && *text != '-';
}

static po_status parse_names(po_case *kase, const po_yaml *yaml) {
  static const char *const WANTS[] = {"pull_off", "folds",   "extrema",
                                      "curve",    "profile", "hysteresis"};
  const po_case_file *file = kase->file;
  if (!po_case_is_name(file->name) || strlen(file->name) > 64)
    return po_schema_refuse(yaml, NULL, "name");
  if (file->figure_script && !po_case_is_name(file->figure_script))
    return po_schema_refuse(yaml, NULL, "figure_script");
  for (unsigned i = 0; i < file->suite_names_count; ++i) {
    const unsigned suite = po_suite_of_name(file->suite_names[i]);
    if (!suite)
      return po_schema_refuse(yaml, PO_SUITE_NAMES, "suites[%u]", i + 1);
    kase->suites |= suite;
  }
  for (unsigned i = 0; i < file->want_names_count; ++i) {
    unsigned want = 0;
    for (unsigned k = 0; k < sizeof WANTS / sizeof *WANTS; ++k)
      if (strcmp(file->want_names[i], WANTS[k]) == 0)
        want = 1u << k;
    if (!want)
      return po_schema_refuse(yaml, "pull_off, folds, extrema, curve, profile or hysteresis",
                              "want[%u]", i + 1);
    kase->want |= want;
  }
  return PO_OK;
}

static po_status parse_repeats(po_case *kase, const po_yaml *yaml) {
  size_t repeats = 1;
  if (kase->file->repeats_text &&
      (!po_number_parse_count(kase->file->repeats_text, &repeats) || repeats < 1 || repeats > 1000))
    return po_schema_refuse(yaml, NULL, "repeats");
  kase->repeats = (unsigned)repeats;
  return PO_OK;
}

/* The key and the values of one item of a sweep, of a `when` or an `as_if`. */
static po_status check_axis(const po_axis *axis, const char *where, const po_yaml *yaml) {
  const int key = po_key_of_name(axis->key);
  if (key < 0)
    return po_schema_refuse(yaml, NULL, "%s.key", where);
  po_request first = po_request_default();
  first.scene.amplitude = first.scene.wavelength = 1; /* so that groups of them have a value */
  po_request other = first;
  for (unsigned i = 0; i < axis->values_count; ++i) {
    if (!po_key_set(&first, (po_key)key, axis->values[i]))
      return po_schema_refuse(yaml, po_key_expected((po_key)key), "%s.values[%u]", where, i + 1);
    for (unsigned k = 0; k < i; ++k) {
      po_key_set(&other, (po_key)key, axis->values[k]);
      if (po_key_matches(&other, (po_key)key, axis->values[i]))
        return po_schema_refuse(yaml, "each value once", "%s.values[%u]", where, i + 1);
    }
  }
  return PO_OK;
}

static po_status parse_sweep(po_case *kase, const po_yaml *yaml) {
  const po_case_file *file = kase->file;
  for (unsigned i = 0; i < file->sweep_count; ++i) {
    char where[WHERE_LENGTH];
    snprintf(where, sizeof where, "sweep[%u]", i + 1);
    po_status status = po_axis_fill(&file->sweep[i], where, yaml);
    if (!status)
      status = check_axis(&file->sweep[i], where, yaml);
    if (status)
      return status;
    const int key = po_key_of_name(file->sweep[i].key);
    const po_key target = po_key_target((po_key)key);
    for (unsigned k = 0; k < i; ++k) {
      if (po_key_is_group(key) && po_key_is_group(po_key_of_name(file->sweep[k].key)))
        return po_schema_refuse(yaml, "one of alpha and amplitude_ratio", "%s.key", where);
      if (target == po_key_target((po_key)po_key_of_name(file->sweep[k].key)))
        return po_schema_refuse(yaml, "each key swept once", "%s.key", where);
    }
    if (file->scene.values[target])
      return po_schema_refuse(yaml, "a key that the scene does not fix", "%s.key", where);
  }
  return PO_OK;
}

/* Swept or drawn. */
static bool is_varied(const po_case_file *file, po_key key) {
  for (unsigned i = 0; i < file->sweep_count; ++i)
    if (po_key_target((po_key)po_key_of_name(file->sweep[i].key)) == key)
      return true;
  return po_case_draws(file, key);
}

/* What a case leaves unsaid a reader would have to guess; only what follows from the rest may lack.
 */
static po_status check_scene(const po_case *kase, const po_yaml *yaml) {
  static const po_key NEEDED[] = {PO_KEY_TABOR,  PO_KEY_RADIUS, PO_KEY_OUTER_RADIUS,
                                  PO_KEY_SCHEME, PO_KEY_NODES,  PO_KEY_WAVELENGTH};
  const po_case_file *file = kase->file;
  po_request request = po_request_default();
  for (int key = 0; key < PO_KEY_COUNT; ++key)
    if (file->scene.values[key] && !po_key_set(&request, (po_key)key, file->scene.values[key]))
      return po_schema_refuse(yaml, NULL, "scene.%s", po_key_name((po_key)key));
  const bool panels = request.mesh.scheme == PO_PANEL && !is_varied(file, PO_KEY_SCHEME);
  const bool wavy = request.scene.amplitude > 0 || is_varied(file, PO_KEY_AMPLITUDE);
  for (size_t i = 0; i < sizeof NEEDED / sizeof *NEEDED; ++i) {
    const po_key key = NEEDED[i];
    if (file->scene.values[key] || is_varied(file, key) || (key == PO_KEY_WAVELENGTH && !wavy) ||
        (key == PO_KEY_NODES && panels))
      continue;
    char expected[128];
    snprintf(expected, sizeof expected, "%s, here, in the sweep or in the sample",
             po_key_expected(key));
    return po_schema_refuse(yaml, expected, "scene.%s", po_key_name(key));
  }
  return PO_OK;
}

/* What may be pinned, and what only pins speak of. */
static po_status check_pin(const po_case_file *file, const po_check *check, unsigned number,
                           const po_yaml *yaml) {
  if (po_check_is_pin(check) && is_varied(file, PO_KEY_TIME_LIMIT))
    return po_schema_refuse(yaml, "no pin, as time_limit varies and pins are the same for each",
                            "checks[%u].reference", number);
  if (check->quantity == PO_CURVE && po_check_is_pin(check))
    return po_schema_refuse(yaml, "a curve to be pinned by its folds and extrema",
                            "checks[%u].quantity", number);
  if (check->quantity == PO_WORK && !po_check_is_pin(check))
    return po_schema_refuse(yaml, "pin, as only our own blessed values speak of work",
                            "checks[%u].reference", number);
  return PO_OK;
}

static po_status parse_check(const po_case_file *file, po_check *check, unsigned number,
                             const po_yaml *yaml) {
  int quantity = 0, kind = 0;
  while (quantity < PO_QUANTITY_COUNT &&
         strcmp(check->quantity_text, po_quantity_name((po_quantity)quantity)) != 0)
    ++quantity;
  if (quantity == PO_QUANTITY_COUNT)
    return po_schema_refuse(yaml, NULL, "checks[%u].quantity", number);
  check->quantity = (po_quantity)quantity;
  if (!po_number_parse(check->tolerance_text, &check->tolerance) || check->tolerance <= 0)
    return po_schema_refuse(yaml, NULL, "checks[%u].tolerance", number);
  char path[WHERE_LENGTH];
  snprintf(path, sizeof path, "checks[%u].tolerance", number);
  check->line = po_yaml_line(yaml, path);
  while (kind <= PO_TOLERANCE_ULP &&
         strcmp(check->kind_text, po_tolerance_kind_name((po_tolerance_kind)kind)) != 0)
    ++kind;
  if (kind > PO_TOLERANCE_ULP)
    return po_schema_refuse(yaml, NULL, "checks[%u].kind", number);
  if (check->quantity == PO_CURVE && kind != PO_TOLERANCE_ABS)
    return po_schema_refuse(yaml, "abs, as the distance between curves is one", "checks[%u].kind",
                            number);
  check->kind = (po_tolerance_kind)kind;
  const bool share = check->quantity == PO_SOLVED_SHARE;
  if (share != (strcmp(check->reference, PO_EVERY_SCENE) == 0))
    return po_schema_refuse(yaml,
                            share ? "every_scene, as the share is of the scenes of the case"
                                  : "bradley, pin or the path of a CSV file",
                            "checks[%u].reference", number);
  if (share && (kind != PO_TOLERANCE_ABS || check->tolerance >= 1))
    return po_schema_refuse(yaml, kind ? "abs, as a share is" : "the share that may fail, below 1",
                            "checks[%u].%s", number, kind ? "kind" : "tolerance");
  if (check->because[strspn(check->because, " \t\n")] == '\0')
    return po_schema_refuse(yaml, NULL, "checks[%u].because", number);
  const po_status pin = check_pin(file, check, number, yaml);
  if (pin)
    return pin;
  for (unsigned i = 0; i < check->when_count; ++i) {
    char where[WHERE_LENGTH];
    snprintf(where, sizeof where, "checks[%u].when[%u]", number, i + 1);
    const po_status status = check_axis(&check->when[i], where, yaml);
    if (status)
      return status;
  }
  return PO_OK;
}

static po_status check_as_if(const po_check *check, unsigned number, const po_yaml *yaml) {
  for (unsigned i = 0; i < check->as_if_count; ++i) {
    char where[WHERE_LENGTH];
    snprintf(where, sizeof where, "checks[%u].as_if[%u]", number, i + 1);
    const po_status status = check_axis(&check->as_if[i], where, yaml);
    if (status)
      return status;
    if (check->as_if[i].values_count > 1)
      return po_schema_refuse(yaml, "one value", "%s.values", where);
  }
  if (check->as_if_count && po_check_is_pin(check))
    return po_schema_refuse(yaml, "a reference other than pin, as as_if asks of another scene",
                            "checks[%u].reference", number);
  return PO_OK;
}

/* What is no file cannot be absent. */
static bool is_file(const char *reference) {
  return strcmp(reference, "bradley") != 0 && strcmp(reference, "pin") != 0 &&
         strcmp(reference, PO_EVERY_SCENE) != 0;
}

/* What stands in must itself be compared, or the check would be left out for nothing. */
static po_status check_stand_ins(const po_case *kase, const po_yaml *yaml) {
  const po_case_file *file = kase->file;
  for (unsigned i = 0; i < file->checks_count; ++i) {
    bool found = !file->checks[i].stand_in;
    for (unsigned k = 0; k < file->checks_count && !found; ++k)
      found = !file->checks[k].stand_in &&
              strcmp(file->checks[k].reference, file->checks[i].stand_in) == 0;
    if (!found)
      return po_schema_refuse(yaml, NULL, "checks[%u].stand_in", i + 1);
    if (file->checks[i].stand_in && !is_file(file->checks[i].reference))
      return po_schema_refuse(yaml, "the path of a CSV file, as something stands in for it",
                              "checks[%u].reference", i + 1);
  }
  return PO_OK;
}

/* A check that concerns no point would pass for ever, unseen. */
static po_status check_concerned(const po_case *kase, const po_yaml *yaml) {
  for (unsigned i = 0; i < kase->file->checks_count; ++i) {
    size_t concerned = 0;
    for (size_t k = 0; k < kase->point_count; ++k)
      concerned += po_check_concerns(&kase->file->checks[i], &kase->points[k].request);
    if (!concerned)
      return po_schema_refuse(yaml, "a condition that holds for some point", "checks[%u].when",
                              i + 1);
  }
  return PO_OK;
}

static bool both_concern(const po_check *a, const po_check *b, const po_request *request) {
  return po_check_concerns(a, request) && po_check_concerns(b, request);
}

/* A scene whose solve may fail has nothing to hold on to: it could be blessed on one machine and
 * fail on another. */
static po_status check_pinned(const po_case *kase, const po_yaml *yaml) {
  const po_case_file *file = kase->file;
  for (unsigned i = 0; i < file->checks_count; ++i)
    for (unsigned k = 0; po_check_is_pin(&file->checks[i]) && k < file->checks_count; ++k)
      for (size_t p = 0; file->checks[k].quantity == PO_SOLVED_SHARE && p < kase->point_count; ++p)
        if (both_concern(&file->checks[i], &file->checks[k], &kase->points[p].request))
          return po_schema_refuse(
              yaml, "a reference other than pin where a solved_share lets solves fail",
              "checks[%u].reference", i + 1);
  return PO_OK;
}

po_status po_case_parse(po_case *kase, const po_yaml *yaml) {
  po_status status = parse_names(kase, yaml);
  if (!status)
    status = parse_repeats(kase, yaml);
  if (!status)
    status = parse_sweep(kase, yaml);
  if (!status)
    status = po_case_sample_parse(kase, yaml);
  if (!status)
    status = po_case_physical_parse(kase, yaml);
  if (!status)
    status = check_scene(kase, yaml);
  for (unsigned i = 0; !status && i < kase->file->checks_count; ++i)
    if (!(status = parse_check(kase->file, &kase->file->checks[i], i + 1, yaml)))
      status = check_as_if(&kase->file->checks[i], i + 1, yaml);
  if (!status)
    status = po_lines_parse(kase, yaml);
  if (!status)
    status = check_stand_ins(kase, yaml);
  if (!status)
    status = po_case_expand(kase, yaml);
  if (!status)
    status = check_concerned(kase, yaml);
  return status ? status : check_pinned(kase, yaml);
}
