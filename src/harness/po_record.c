#include "po_record.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "po_environment.h"
#include "po_file.h"
#include "po_input.h"
#include "po_json.h"
#include "po_json_units.h"
#include "po_lines.h"
#include "po_tables.h"

static json_t *text_or_null(const char *text) {
  return text ? json_string(text) : json_null();
}

static json_t *suites(const po_case *kase) {
  json_t *array = json_array();
  for (unsigned i = 0; i < kase->file->suite_names_count; ++i)
    json_array_append_new(array, json_string(kase->file->suite_names[i]));
  return array;
}

static json_t *sweep(const po_case *kase, size_t point) {
  json_t *object = json_object();
  json_t *input = po_json_input(&kase->points[point].request);
  for (unsigned i = 0; i < kase->file->sweep_count; ++i)
    for (int key = 0; key < PO_KEY_END; ++key) {
      const char *name = po_key_name((po_key)key);
      if (!po_sweep_names(&kase->file->sweep[i], (po_key)key))
        continue;
      if (po_key_is_group(key))
        json_object_set_new(
            object, name, po_json_number(po_key_number(&kase->points[point].request, (po_key)key)));
      else
        json_object_set(object, name, json_object_get(input, name));
    }
  json_decref(input);
  for (unsigned i = 0; kase->file->sample && i < kase->file->sample->keys_count; ++i) {
    const po_draw *draw = &kase->file->sample->keys[i];
    json_object_set_new(object, draw->key,
                        po_json_number(po_key_number(&kase->points[point].request, draw->drawn)));
  }
  return object;
}

/* The times of a point, round after round. */
static json_t *times(const po_case_run *run, const double *seconds, size_t point) {
  const unsigned repeats = run->plan->kase->repeats;
  json_t *array = json_array();
  for (unsigned i = 0; i < repeats; ++i)
    json_array_append_new(array, po_json_number(seconds[point * repeats + i]));
  return array;
}

static void table_name(char name[64], const char *what, const po_point *point) {
  snprintf(name, 64, "%s-%s.csv", what, point->id);
}

/* Writes the curve or the profile of a point, if there is one, and says so in its entry: the name
 * of the file and its checksum, by which a table that is not of this record is told. */
static po_status add_table(const po_case_run *run, size_t index, bool profile, const char *folder,
                           json_t *entry) {
  const po_point *point = &run->plan->kase->points[index];
  const po_outcome *outcome = &run->outcomes[index];
  const char *what = profile ? "profile" : "curve";
  char name[64], digest_key[32], digest[PO_DIGEST_LENGTH];
  table_name(name, what, point);
  json_object_set_new(entry, what, json_null());
  if ((profile ? outcome->profile_count : outcome->curve_count) == 0)
    return PO_OK;
  char *path = po_path_join(folder, name);
  if (!path)
    return PO_NO_MEMORY;
  const po_status status = profile ? po_tables_write_profile(path, &point->request, outcome, digest)
                                   : po_tables_write_curve(path, &point->request, outcome, digest);
  free(path);
  if (profile)
    json_object_set_new(entry, "contact", po_json_contact(outcome));
  snprintf(digest_key, sizeof digest_key, "%s_sha256", what);
  json_object_set_new(entry, what, json_string(name));
  json_object_set_new(entry, digest_key, json_string(digest));
  return status;
}

po_status po_record_add_tables(const po_case_run *run, size_t index, const char *folder,
                               json_t *entry) {
  const po_status status = add_table(run, index, false, folder, entry);
  return status ? status : add_table(run, index, true, folder, entry);
}

static po_status add_tables(const po_case_run *run, const char *folder, json_t *record) {
  json_t *points = json_object_get(record, "points");
  po_status status = PO_OK;
  for (size_t i = 0; !status && i < run->plan->kase->point_count; ++i)
    status = po_record_add_tables(run, i, folder, json_array_get(points, i));
  return status;
}

json_t *po_record_point(const po_case_run *run, size_t index) {
  const po_case *kase = run->plan->kase;
  const po_point *point = &kase->points[index];
  const po_outcome *outcome = &run->outcomes[index];
  json_t *object = po_json_outcome(&point->request, outcome);
  char *command = po_input_command(&point->request);
  json_object_set_new(object, "id", json_string(point->id));
  json_object_set_new(object, "label", json_string(point->label));
  json_object_set_new(object, "sweep", sweep(kase, index));
  json_object_set_new(object, "seconds_all", times(run, run->seconds, index));
  json_object_set_new(object, "processor_seconds_all", times(run, run->processor_seconds, index));
  json_object_set_new(object, "command", text_or_null(command));
  if (point->traced)
    json_object_set_new(object, "traced", po_json_outcome(&point->request, &run->traces[index]));
  if (kase->is_physical)
    json_object_set_new(object, "physical",
                        json_pack("{s:o, s:o}", "units", po_json_units(&kase->units), "pull_off",
                                  po_json_units_pull_off(&kase->units, outcome)));
  free(command);
  return object;
}

static json_t *check_json(const po_case_run *run, const po_result *item) {
  const po_case *kase = run->plan->kase;
  const po_check *check = item->check;
  char command[128];
  snprintf(command, sizeof command, "pulloff verify %s", kase->file->name);
  return json_pack(
      "{s:s, s:s?, s:s, s:o, s:o, s:o, s:s, s:f, s:o, s:o, s:s, s:s, s:b, s:s, s:s, s:s, s:s}",
      "id", item->id, "point", item->whole ? NULL : kase->points[item->point].id, "quantity",
      item->quantity, "obtained", po_json_number(item->obtained), "expected",
      po_json_number(item->expected), "error", po_json_number(item->error), "kind",
      check->kind_text, "tolerance", check->tolerance, "reference_uncertainty",
      po_json_number(item->uncertainty), "ratio", po_json_number(item->ratio), "ledger",
      po_ledger_name(item->ledger), "verdict", po_verdict_name(item->verdict), "passes",
      (int)po_verdict_passes(item->verdict), "note", item->note, "reference",
      po_plan_reference_of(run->plan, check), "because", check->because, "command", command);
}

/* How a measurement ended; `outside` are curves and landmarks that have no one-to-one counterpart.
 */
static const char *measured_as(po_verdict verdict) {
  return verdict == PO_OUTSIDE             ? "no_correspondence"
         : verdict == PO_NO_RESULT         ? "no_result"
         : verdict == PO_MISSING_REFERENCE ? "missing_reference"
                                           : "measured";
}

static json_t *measure_json(const po_case_run *run, const po_result *item) {
  return json_pack("{s:s, s:s, s:s, s:s, s:o, s:o, s:o, s:o, s:s, s:s, s:s}", "id", item->id,
                   "point", run->plan->kase->points[item->point].id, "quantity", item->quantity,
                   "subject", item->subject, "obtained", po_json_number(item->obtained), "expected",
                   po_json_number(item->expected), "error", po_json_number(item->error),
                   "reference_uncertainty", po_json_number(item->uncertainty), "outcome",
                   measured_as(item->verdict), "note", item->note, "reference",
                   po_plan_reference_of(run->plan, item->check));
}

/* The scenes that are not solved, rule by rule. */
static json_t *not_solved(const po_case *kase) {
  json_t *array = json_array();
  for (unsigned i = 0; i < kase->file->leave_out_count; ++i) {
    const po_leave_out *rule = &kase->file->leave_out[i];
    json_t *when = json_array();
    for (unsigned k = 0; k < rule->when_count; ++k) {
      json_t *values = json_array();
      for (unsigned v = 0; v < rule->when[k].values_count; ++v)
        json_array_append_new(values, json_string(rule->when[k].values[v]));
      json_array_append_new(when,
                            json_pack("{s:s, s:o}", "key", rule->when[k].key, "values", values));
    }
    json_array_append_new(array, json_pack("{s:o, s:I, s:s}", "when", when, "points",
                                           (json_int_t)rule->points, "because", rule->because));
  }
  return array;
}

/* The checks that were left out since their reference is absent. */
static json_t *left_out(const po_plan *plan) {
  json_t *array = json_array();
  for (unsigned i = 0; i < plan->kase->file->checks_count; ++i) {
    const po_check *check = &plan->kase->file->checks[i];
    if (plan->references[i].is_absent)
      json_array_append_new(array,
                            json_pack("{s:s, s:s, s:s}", "quantity", check->quantity_text,
                                      "reference", check->reference, "stand_in", check->stand_in));
  }
  return array;
}

static json_t *lists(const po_case_run *run, json_t *record) {
  json_t *plan = json_array(), *points = json_array(), *checks = json_array();
  json_t *measured = json_array();
  for (size_t i = 0; i < run->plan->line_count; ++i)
    json_array_append_new(plan, json_string(run->plan->lines[i]));
  for (size_t i = 0; i < run->plan->kase->point_count; ++i) {
    json_t *point = po_record_point(run, i);
    json_object_set_new(point, "failed", json_boolean(po_case_run_failed(run, i)));
    json_array_append_new(points, point);
  }
  for (size_t i = 0; i < run->results.count; ++i)
    json_array_append_new(checks, check_json(run, &run->results.items[i]));
  for (size_t i = 0; i < run->measured.count; ++i)
    json_array_append_new(measured, measure_json(run, &run->measured.items[i]));
  json_object_set_new(record, "plan", plan);
  json_object_set_new(record, "points", points);
  json_object_set_new(record, "checks", checks);
  json_object_set_new(record, "measured", measured);
  json_object_set_new(record, "left_out", left_out(run->plan));
  json_object_set_new(record, "not_solved", not_solved(run->plan->kase));
  return record;
}

/* Where it was solved. */
static json_t *environment(const po_case_run *run, int jobs) {
  return run->environment ? json_loads(run->environment, 0, NULL) : po_environment_describe(jobs);
}

static json_t *record_json(const po_case_run *run, int jobs) {
  const po_case *kase = run->plan->kase;
  const po_case_file *file = kase->file;
  char command[128];
  snprintf(command, sizeof command, "pulloff run %s", file->name);
  json_t *record = json_pack(
      "{s:s, s:s, s:s, s:o, s:o, s:o, s:s, s:s, s:s, s:o, s:s, s:o, s:o, s:s, s:o}", "schema",
      "pulloff-record/1", "case", file->name, "title", file->title, "figure",
      text_or_null(file->figure), "equations", text_or_null(file->equations), "suites",
      suites(kase), "file", kase->shown, "key", run->plan->key, "solve_key", run->plan->solve_key,
      "figure_script", text_or_null(file->figure_script), "command", command, "versions",
      po_environment_versions(), "environment", environment(run, jobs), "verdict",
      po_case_run_verdict(run), "seconds", po_json_number(run->elapsed));
  return record ? lists(run, record) : NULL;
}

po_status po_record_write(const po_case_run *run, const char *output, int jobs) {
  char *folder = po_path_join(output, run->plan->kase->file->name);
  char *path = folder ? po_path_join(folder, "record.json") : NULL;
  json_t *record = record_json(run, jobs);
  json_t *written = NULL;
  po_text text = {0};
  po_status status = path ? po_folder_make(folder) : PO_NO_MEMORY;
  if (!status)
    status = add_tables(run, folder, record);
  if (!status && !(status = po_lines_write(run->plan->kase, folder, &written)))
    json_object_set_new(record, "lines", written);
  if (!status)
    status = po_json_print(record, &text);
  if (!status)
    status = po_file_write(path, text.data, text.length);
  po_text_clear(&text);
  json_decref(record);
  free(path);
  free(folder);
  return status;
}
