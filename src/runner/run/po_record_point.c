#include "po_record.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "po_file.h"
#include "po_input.h"
#include "po_json.h"
#include "po_result_rows.h"
#include "po_tables.h"

/* Names of the arrays in the record, and the members that they contain. All points have the first
 * two; the others are in the member `timing` of an external solver. */
static const struct {
  const char *name;
  size_t place;
} COLUMNS[] = {{"seconds_all", offsetof(po_round, seconds)},
               {"processor_seconds_all", offsetof(po_round, processor_seconds)},
               {"first_seconds", offsetof(po_round, first)},
               {"reported_seconds", offsetof(po_round, reported)},
               {"process_seconds", offsetof(po_round, wall)},
               {"process_processor_seconds", offsetof(po_round, processor)},
               {"start_seconds", offsetof(po_round, start_wall)},
               {"start_processor_seconds", offsetof(po_round, start_processor)}};
enum { COLUMN_COUNT = sizeof COLUMNS / sizeof *COLUMNS, OF_ALL = 2 };

static double *cell(po_round *round, size_t column) {
  return (double *)(void *)((char *)round + COLUMNS[column].place);
}

/* Returned: times of a point in the order of the rounds, all or those in which it was solved. */
static json_t *times(const po_case_run *run, size_t point, size_t column, bool all) {
  json_t *array = po_json_empty_array();
  for (unsigned r = 0; r < run->plan->kase->repeats; ++r)
    if (all || !isnan(run->points[point].rounds[r].seconds))
      po_json_append(&array, po_json_number(*cell(&run->points[point].rounds[r], column)));
  return array;
}

/* Returned: the member `timing` of a point of an external solver that was timed. */
static json_t *timing_json(const po_case_run *run, size_t point) {
  json_t *object = po_json_empty_object();
  for (size_t c = OF_ALL; c < COLUMN_COUNT; ++c)
    po_json_set(&object, COLUMNS[c].name, times(run, point, c, true));
  po_json_set(&object, "interleaved", json_boolean(run->points[point].interleaved));
  return object;
}

/* Reads times of a point; those that the array lacks are NAN. */
static void read_times(po_case_run *run, size_t point, size_t column, const json_t *array) {
  for (unsigned r = 0; r < run->plan->kase->repeats; ++r) {
    const json_t *value = json_array_get(array, r);
    *cell(&run->points[point].rounds[r], column) =
        json_is_number(value) ? json_number_value(value) : (double)NAN;
  }
}

/* Reads that member. Status: PO_BAD_INPUT if it is missing or incomplete. */
static po_status read_timing(po_case_run *run, size_t point, const json_t *timing) {
  if (!run->starts)
    return PO_OK;
  for (size_t c = OF_ALL; c < COLUMN_COUNT; ++c) {
    const json_t *array = json_object_get(timing, COLUMNS[c].name);
    if (json_array_size(array) != run->plan->kase->repeats)
      return po_fail(PO_BAD_INPUT, "the times of the rounds are incomplete");
    read_times(run, point, c, array);
  }
  run->points[point].interleaved = json_is_true(json_object_get(timing, "interleaved"));
  return PO_OK;
}

/* A law or a profile as cases write it, "mie:4,10": the name and the parameters. */
static json_t *with_parameters(const po_request *request, po_key name) {
  char value[PO_KEY_TEXT_LENGTH];
  po_key_print(request, name, value);
  po_text text = {0};
  po_text_add(&text, "%s", value);
  const char *before = ":";
  for (int key = 0; key < PO_KEY_COUNT; ++key)
    if (po_key_is_parameter(key, PO_KEYS[name].owner) && po_key_is_continuous(key) &&
        !isnan(po_key_number(request, key))) {
      po_key_print(request, key, value);
      po_text_add(&text, "%s%s", before, value);
      before = ",";
    }
  return po_json_take_text(po_text_take(&text));
}

static json_t *swept_value(const po_request *request, const json_t *input, po_key key) {
  if (key == PO_KEY_LAW || key == PO_KEY_PROFILE)
    return with_parameters(request, key);
  if (po_key_is_group(key))
    return po_json_number(po_key_number(request, key));
  json_t *value = json_object_get(input, PO_KEYS[key].name); /* an elastic body has no speed */
  return value ? json_incref(value) : json_null();
}

/* The value of a key in SI units, as it is written: a number, two with a comma between; null: the
 * setting of the point does not give it. */
static json_t *in_si(const po_case *kase, size_t point, unsigned item, po_key key) {
  const char *text = po_case_swept_text(kase, &kase->points[point], item, key);
  double value = 0;
  return text && po_number_parse(text, &value) ? po_json_number(value) : po_json_text(text);
}

static json_t *sweep(const po_case *kase, size_t point) {
  json_t *object = po_json_empty_object();
  const po_request *request = &kase->points[point].request;
  json_t *input = po_json_input(request);
  for (unsigned i = 0; i < kase->file->sweep_count; ++i)
    for (int key = 0; key < PO_KEY_END; ++key)
      if (kase->file->sweep[i].named.has[key])
        po_json_set(&object, PO_KEYS[key].name, swept_value(request, input, key));
  for (unsigned i = 0; i < kase->file->sweep_count; ++i)
    for (int key = PO_KEY_END; key < PO_KEY_VARIABLES; ++key)
      if (kase->file->sweep[i].named.has[key])
        po_json_set(&object, PO_KEYS[key].name, in_si(kase, point, i, key));
  json_decref(input);
  for (unsigned i = 0; kase->file->sample && i < kase->file->sample->keys_count; ++i) {
    const po_draw *draw = &kase->file->sample->keys[i];
    po_json_set(&object, draw->key, po_json_number(po_key_number(request, draw->drawn)));
  }
  return object;
}

/* The request of a point for documents: the table of its profile is named relative to the folder of
 * the case file, as the case names it. */
static po_request shown_request(const po_case *kase, const po_point *point) {
  po_request request = point->request;
  po_profile *profile = &request.scene.profile;
  if (po_profile_is_table(profile))
    profile->shown = po_case_profile_shown(kase, po_profile_file(profile));
  if (po_creep_file(&request.creep))
    request.creep.shown = po_case_profile_shown(kase, po_creep_file(&request.creep));
  return request;
}

static void table_name(char name[64], const char *what, const po_point *point) {
  snprintf(name, 64, "%s-%s.csv", what, point->id);
}

/* The tables of a point. */
static const struct {
  po_table table;
  const char *what;
} TABLES[] = {{PO_CURVE_TABLE, "curve"}, {PO_PROFILE_TABLE, "profile"}, {PO_LOOP_TABLE, "loop"}};
enum { TABLE_COUNT = sizeof TABLES / sizeof *TABLES };

/* The number of rows of a table. */
static size_t rows_of(const po_result *result, po_table table) {
  return table == PO_CURVE_TABLE     ? result->curve_count
         : table == PO_PROFILE_TABLE ? result->profile_count
                                     : result->hysteresis.of[PO_AT_APPROACH].row_count;
}

/* Writes a table of a point, if it has it, and adds the name of the file and its checksum to the
 * entry. The checksum detects a table of another record. A table of the loop is in SI units if the
 * scene is. */
static po_status add_table(const po_case_run *run, size_t index, size_t number, const char *folder,
                           json_t **entry) {
  const po_point *point = &run->plan->kase->points[index];
  const po_result *result = &run->points[index].result;
  const po_table table = TABLES[number].table;
  const char *what = TABLES[number].what;
  char name[64], digest_key[32], digest[PO_DIGEST_LENGTH];
  table_name(name, what, point);
  if (table != PO_LOOP_TABLE || run->plan->want & PO_WANT_LOOP)
    po_json_set(entry, what, json_null());
  if (rows_of(result, table) == 0)
    return PO_OK;
  const po_file_path path = po_path_join(folder, name);
  po_request shown = shown_request(run->plan->kase, point);
  shown.in_si = table == PO_LOOP_TABLE && run->plan->kase->is_physical;
  shown.units = point->request.units;
  const po_status status = po_tables_write(table, path.text, &shown, result, digest);
  if (table == PO_PROFILE_TABLE)
    po_json_set(entry, "contact", po_json_of(&PO_CONTACT_ROWS, result));
  snprintf(digest_key, sizeof digest_key, "%s_sha256", what);
  po_json_set(entry, what, po_json_text(name));
  po_json_set(entry, digest_key, po_json_text(digest));
  return status ? status : *entry ? PO_OK : PO_NO_MEMORY;
}

/* Returned: the command that solves a point again. That of a followed point traces its scene, to
 * which the report links; po_plan_add_rerun has the command that follows it again. A scene with
 * uncertain numbers is solved again by its case, which has them. */
static json_t *command_json(const po_case_run *run, size_t index) {
  po_text text = {0};
  po_request shown = shown_request(run->plan->kase, &run->plan->kase->points[index]);
  shown.want = run->plan->want;
  if (run->plan->solver || shown.variations)
    po_plan_add_rerun(run->plan, index, &text);
  else
    po_input_add_command(&shown, &text);
  return po_json_take_text(po_text_take(&text));
}

static json_t *sealed_result(const po_request *request, const po_result *result) {
  json_t *object = po_json_result(request, result);
  po_json_seal(&object);
  return object;
}

po_status po_record_digest(const po_case_run *run, size_t index,
                           char digest[PO_RESULT_DIGEST_LENGTH]) {
  const po_request shown = shown_request(run->plan->kase, &run->plan->kase->points[index]);
  json_t *object = po_json_result(&shown, &run->points[index].result);
  const po_status status = po_json_digest(object, digest);
  json_decref(object);
  return status;
}

json_t *po_record_result(const po_case_run *run, size_t index) {
  const po_point *point = &run->plan->kase->points[index];
  const po_request shown = shown_request(run->plan->kase, point);
  json_t *object = sealed_result(&shown, &run->points[index].result);
  for (size_t c = 0; c < OF_ALL; ++c)
    po_json_set(&object, COLUMNS[c].name, times(run, index, c, false));
  if (run->starts)
    po_json_set(&object, "timing", timing_json(run, index));
  if (point->traced)
    po_json_set(&object, "traced", sealed_result(&shown, &run->points[index].trace));
  return object;
}

po_status po_record_read_result(po_case_run *run, size_t index, const json_t *object) {
  const json_t *seconds = json_object_get(object, COLUMNS[0].name);
  const json_t *processor = json_object_get(object, COLUMNS[1].name);
  po_point_run *point = &run->points[index];
  if (json_array_size(seconds) > run->plan->kase->repeats ||
      json_array_size(processor) != json_array_size(seconds))
    return po_fail(PO_BAD_INPUT, "the times are not those of %u solves", run->plan->kase->repeats);
  po_result_clear(&point->result);
  po_result_clear(&point->trace);
  po_status status = po_json_read_result(object, &point->result);
  if (!status && run->plan->kase->points[index].traced)
    status = po_json_read_result(json_object_get(object, "traced"), &point->trace);
  read_times(run, index, 0, seconds);
  read_times(run, index, 1, processor);
  return status ? status : read_timing(run, index, json_object_get(object, "timing"));
}

json_t *po_record_point(const po_case_run *run, size_t index) {
  const po_case *kase = run->plan->kase;
  const po_point *point = &kase->points[index];
  json_t *object = po_record_result(run, index);
  po_json_set(&object, "id", po_json_text(point->id));
  po_json_set(&object, "label", po_json_text(point->label));
  po_json_set(&object, "checksum",
              po_json_text(*run->points[index].checksum ? run->points[index].checksum : NULL));
  po_json_set(&object, "sweep", sweep(kase, index));
  po_json_set(&object, "command", command_json(run, index));
  po_json_set(&object, "failed", json_boolean(po_case_run_failed(run, index)));
  if (kase->is_physical) {
    json_t *physical = PO_JSON_OBJECT({"units", po_json_units(&point->request.units)});
    po_json_set_all(&physical,
                    po_json_result_in_si(&point->request.units, &run->points[index].result));
    po_json_set(&object, "physical", physical);
  }
  return object;
}

po_status po_record_entry(const po_case_run *run, size_t index, const char *folder,
                          json_t **entry) {
  *entry = po_record_point(run, index);
  po_status status = PO_OK;
  for (size_t k = 0; k < TABLE_COUNT && !status; ++k)
    status = add_table(run, index, k, folder, entry);
  return status;
}

const char *po_record_text(const json_t *object, const char *key) {
  const char *text = json_string_value(json_object_get(object, key));
  return text ? text : "";
}
