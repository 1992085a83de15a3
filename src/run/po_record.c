#include "po_record.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "po_environment.h"
#include "po_file.h"
#include "po_input.h"
#include "po_json.h"
#include "po_json_rows.h"
#include "po_json_units.h"
#include "po_lines.h"
#include "po_result_rows.h"
#include "po_rounds.h"
#include "po_run_solver.h"
#include "po_tables.h"

/* The record of some points. */
static const char PART[] = "part.json";

static json_t *suites(const po_case *kase) {
  json_t *array = po_json_empty_array();
  for (unsigned i = 0; i < kase->file->suite_names_count; ++i)
    po_json_append(&array, po_json_text(kase->file->suite_names[i]));
  return array;
}

/* A law or a profile as cases write it, "mie:4,10": the name and the parameters. */
static json_t *with_parameters(const po_request *request, po_key name) {
  char value[PO_KEY_TEXT_LENGTH];
  po_key_print(request, name, value);
  po_text text = {0};
  po_text_add(&text, "%s", value);
  const char *before = ":";
  for (int key = 0; key < PO_KEY_COUNT; ++key)
    if (po_key_is_parameter(key, po_key_row_of((int)name)->owner) && po_key_is_continuous(key) &&
        !isnan(po_key_number(request, (po_key)key))) {
      po_key_print(request, (po_key)key, value);
      po_text_add(&text, "%s%s", before, value);
      before = ",";
    }
  if (text.failed)
    po_text_clear(&text);
  return po_json_take_text(text.data);
}

static json_t *swept_value(const po_request *request, const json_t *input, po_key key) {
  if (key == PO_KEY_LAW || key == PO_KEY_PROFILE)
    return with_parameters(request, key);
  return po_key_is_group(key) ? po_json_number(po_key_number(request, key))
                              : json_incref(json_object_get(input, po_key_name(key)));
}

static json_t *sweep(const po_case *kase, size_t point) {
  json_t *object = po_json_empty_object();
  const po_request *request = &kase->points[point].request;
  json_t *input = po_json_input(request);
  for (unsigned i = 0; i < kase->file->sweep_count; ++i)
    for (int key = 0; key < PO_KEY_END; ++key)
      if (po_sweep_names(&kase->file->sweep[i], (po_key)key))
        po_json_set(&object, po_key_name((po_key)key), swept_value(request, input, (po_key)key));
  json_decref(input);
  for (unsigned i = 0; kase->file->sample && i < kase->file->sample->keys_count; ++i) {
    const po_draw *draw = &kase->file->sample->keys[i];
    po_json_set(&object, draw->key, po_json_number(po_key_number(request, draw->drawn)));
  }
  return object;
}

/* Returned: the times of a point in the order of the rounds in which it was solved. */
static json_t *times(const po_case_run *run, const double *seconds, size_t point) {
  const unsigned repeats = run->plan->kase->repeats;
  json_t *array = po_json_empty_array();
  for (unsigned i = 0; i < repeats; ++i)
    if (!isnan(run->seconds[point * repeats + i]))
      po_json_append(&array, po_json_number(seconds[point * repeats + i]));
  return array;
}

/* The request of a point for documents: the table of its profile is named relative to the folder of
 * the case file, as the case names it. */
static po_request shown_request(const po_case *kase, const po_point *point) {
  po_request request = point->request;
  po_profile *profile = &request.scene.profile;
  if (po_profile_is_table(profile))
    profile->shown = po_case_profile_shown(kase, po_profile_file(profile));
  return request;
}

static void table_name(char name[64], const char *what, const po_point *point) {
  snprintf(name, 64, "%s-%s.csv", what, point->id);
}

/* Writes the curve or the profile of a point, if it has one, and adds the name of the file and its
 * checksum to the entry. The checksum detects a table of another record. */
static po_status add_table(const po_case_run *run, size_t index, bool profile, const char *folder,
                           json_t **entry) {
  const po_point *point = &run->plan->kase->points[index];
  const po_result *result = &run->results[index];
  const char *what = profile ? "profile" : "curve";
  char name[64], digest_key[32], digest[PO_DIGEST_LENGTH];
  table_name(name, what, point);
  po_json_set(entry, what, json_null());
  if ((profile ? result->profile_count : result->curve_count) == 0)
    return PO_OK;
  char *path = po_path_join(folder, name);
  if (!path)
    return PO_NO_MEMORY;
  const po_request shown = shown_request(run->plan->kase, point);
  const po_status status = profile ? po_tables_write_profile(path, &shown, result, digest)
                                   : po_tables_write_curve(path, &shown, result, digest);
  free(path);
  if (profile)
    po_json_set(entry, "contact", po_json_of(&PO_CONTACT_ROWS, result));
  snprintf(digest_key, sizeof digest_key, "%s_sha256", what);
  po_json_set(entry, what, po_json_text(name));
  po_json_set(entry, digest_key, po_json_text(digest));
  return status ? status : *entry ? PO_OK : PO_NO_MEMORY;
}

po_status po_record_add_tables(const po_case_run *run, size_t index, const char *folder,
                               json_t **entry) {
  const po_status status = add_table(run, index, false, folder, entry);
  return status ? status : add_table(run, index, true, folder, entry);
}

static json_t *rerun_json(const po_plan *plan, size_t point) {
  po_text text = {0};
  po_plan_add_rerun(plan, point, &text);
  if (text.failed)
    po_text_clear(&text);
  return po_json_take_text(text.data);
}

static json_t *sealed_result(const po_request *request, const po_result *result) {
  json_t *object = po_json_result(request, result);
  po_json_seal(&object);
  return object;
}

po_status po_record_digest(const po_case_run *run, size_t index,
                           char digest[PO_RESULT_DIGEST_LENGTH]) {
  const po_request shown = shown_request(run->plan->kase, &run->plan->kase->points[index]);
  json_t *object = po_json_result(&shown, &run->results[index]);
  const po_status status = po_json_digest(object, digest);
  json_decref(object);
  return status;
}

json_t *po_record_point(const po_case_run *run, size_t index) {
  const po_case *kase = run->plan->kase;
  const po_point *point = &kase->points[index];
  const po_result *result = &run->results[index];
  const po_request shown = shown_request(kase, point);
  json_t *object = sealed_result(&shown, result);
  po_json_set(&object, "id", po_json_text(point->id));
  po_json_set(&object, "label", po_json_text(point->label));
  po_json_set(&object, "sweep", sweep(kase, index));
  po_json_set(&object, "seconds_all", times(run, run->seconds, index));
  po_json_set(&object, "processor_seconds_all", times(run, run->processor_seconds, index));
  if (run->rounds)
    po_json_set(&object, "timing", po_rounds_json(run, index));
  po_json_set(&object, "command",
              run->plan->solver ? rerun_json(run->plan, index)
                                : po_json_take_text(po_input_command(&shown)));
  if (point->traced)
    po_json_set(&object, "traced", sealed_result(&shown, &run->traces[index]));
  if (kase->is_physical)
    po_json_set(&object, "physical",
                PO_JSON_OBJECT({"units", po_json_units(&kase->units)},
                               {"pull_off", po_json_units_pull_off(&kase->units, result)}));
  return object;
}

/* Returned: the command that applies a verb to a case, quoted for a shell. */
static json_t *command_json(const char *verb, const po_plan *plan) {
  po_text text = {0};
  po_text_add(&text, "pulloff %s %s", verb, po_case_word(plan->kase));
  po_plan_add_solver(plan, &text);
  if (text.failed)
    po_text_clear(&text);
  return po_json_take_text(text.data);
}

static json_t *check_json(const po_case_run *run, const po_check_result *item) {
  const po_case *kase = run->plan->kase;
  const po_check *check = item->check;
  return PO_JSON_OBJECT(
      {"id", po_json_text(item->id)},
      {"point", po_json_text(item->whole ? NULL : kase->points[item->point].id)},
      {"quantity", po_json_text(item->quantity)}, {"obtained", po_json_number(item->obtained)},
      {"expected", po_json_number(item->expected)}, {"error", po_json_number(item->error)},
      {"kind", po_json_text(check->kind_text)}, {"tolerance", po_json_number(check->tolerance)},
      {"reference_uncertainty", po_json_number(item->uncertainty)},
      {"ratio", po_json_number(item->ratio)},
      {"ledger", po_json_text(po_ledger_name(item->ledger))},
      {"verdict", po_json_text(po_verdict_name(item->verdict))},
      {"passes", po_json_flag(po_verdict_passes(item->verdict))},
      {"note", po_json_text(item->note)},
      {"reference", po_json_text(po_plan_reference_of(run->plan, check))},
      {"because", po_json_text(check->because)}, {"command", command_json("verify", run->plan)});
}

/* Returned: the result of a measurement. Its tolerance is infinite, so the verdict `outside` means
 * that the special points or folds of result and reference do not correspond one to one. */
static const char *measured_as(po_verdict verdict) {
  return verdict == PO_OUTSIDE             ? "no_correspondence"
         : verdict == PO_NO_RESULT         ? "no_result"
         : verdict == PO_MISSING_REFERENCE ? "missing_reference"
                                           : "measured";
}

static json_t *measure_json(const po_case_run *run, const po_check_result *item) {
  return PO_JSON_OBJECT(
      {"id", po_json_text(item->id)},
      {"point", po_json_text(run->plan->kase->points[item->point].id)},
      {"quantity", po_json_text(item->quantity)}, {"subject", po_json_text(item->subject)},
      {"obtained", po_json_number(item->obtained)}, {"expected", po_json_number(item->expected)},
      {"error", po_json_number(item->error)},
      {"reference_uncertainty", po_json_number(item->uncertainty)},
      {"outcome", po_json_text(measured_as(item->verdict))}, {"note", po_json_text(item->note)},
      {"reference", po_json_text(po_plan_reference_of(run->plan, item->check))});
}

static json_t *conditions(const po_leave_out *rule) {
  json_t *when = po_json_empty_array();
  for (unsigned k = 0; k < rule->when_count; ++k) {
    json_t *values = po_json_empty_array();
    for (unsigned v = 0; v < rule->when[k].values_count; ++v)
      po_json_append(&values, po_json_text(rule->when[k].values[v]));
    po_json_append(&when,
                   PO_JSON_OBJECT({"key", po_json_text(rule->when[k].key)}, {"values", values}));
  }
  return when;
}

/* Returned: the rules of `leave_out`, with the number of points that each excludes. */
static json_t *not_solved(const po_case *kase) {
  json_t *array = po_json_empty_array();
  for (unsigned i = 0; i < kase->file->leave_out_count; ++i) {
    const po_leave_out *rule = &kase->file->leave_out[i];
    po_json_append(&array, PO_JSON_OBJECT({"when", conditions(rule)},
                                          {"points", po_json_count(rule->points)},
                                          {"because", po_json_text(rule->because)}));
  }
  return array;
}

/* Returned: the checks that were not made because their reference is absent. */
static json_t *left_out(const po_plan *plan) {
  json_t *array = po_json_empty_array();
  for (unsigned i = 0; i < plan->kase->file->checks_count; ++i) {
    const po_check *check = &plan->kase->file->checks[i];
    if (plan->references[i].type == PO_REFERENCE_ABSENT)
      po_json_append(&array, PO_JSON_OBJECT({"quantity", po_json_text(check->quantity_text)},
                                            {"reference", po_json_text(check->reference)},
                                            {"stand_in", po_json_text(check->stand_in)}));
  }
  return array;
}

/* Writes the tables of all points. Returned: in *points, the entries. */
static po_status write_points(const po_case_run *run, const char *folder, json_t **points) {
  po_status status = PO_OK;
  *points = po_json_empty_array();
  for (size_t i = 0; !status && i < run->plan->kase->point_count; ++i) {
    json_t *point = po_record_point(run, i);
    po_json_set(&point, "failed", po_json_flag(po_case_run_failed(run, i)));
    status = po_record_add_tables(run, i, folder, &point);
    if (!status)
      status = po_record_add_checksum(run, i, &point);
    po_json_append(points, point);
  }
  return status;
}

static json_t *plan_json(const po_plan *plan) {
  json_t *lines = po_json_empty_array();
  for (size_t i = 0; i < plan->line_count; ++i)
    po_json_append(&lines, po_json_text(plan->lines[i]));
  return lines;
}

static json_t *results_json(const po_case_run *run, const po_check_results *check_results,
                            json_t *(*item_json)(const po_case_run *, const po_check_result *)) {
  json_t *items = po_json_empty_array();
  for (size_t i = 0; i < check_results->count; ++i)
    po_json_append(&items, item_json(run, &check_results->items[i]));
  return items;
}

/* Returned: the environment in which the case was solved. */
static json_t *environment(const po_case_run *run, int jobs) {
  json_t *found = NULL;
  if (!run->environment)
    return po_environment_describe(jobs);
  return po_json_parse(run->environment, strlen(run->environment), &found) ? NULL : found;
}

/* The digests of the points, whose digest is that of the case. */
static json_t *digests(const json_t *points) {
  json_t *all = po_json_empty_array();
  for (size_t i = 0; i < json_array_size(points); ++i)
    po_json_append(&all, json_incref(json_object_get(json_array_get(points, i), "digest")));
  return all;
}

/* Takes ownership of `points` and `lines`. */
static json_t *record_json(const po_case_run *run, int jobs, json_t *points, json_t *lines) {
  const po_case *kase = run->plan->kase;
  const po_case_file *file = kase->file;
  char digest[PO_RESULT_DIGEST_LENGTH];
  json_t *all = digests(points);
  const po_status status = po_json_digest(all, digest);
  json_decref(all);
  return PO_JSON_OBJECT(
      {"schema", po_json_text("pulloff-record/1")}, {"case", po_json_text(file->name)},
      {"title", po_json_text(file->title)}, {"figure", po_json_text(file->figure)},
      {"equations", po_json_text(file->equations)}, {"suites", suites(kase)},
      {"file", po_json_text(kase->shown)}, {"key", po_json_text(run->plan->key)},
      {"solve_key", po_json_text(run->plan->solve_key)},
      {"figure_script", po_json_text(file->figure_script)},
      {"command", command_json("run", run->plan)}, {"versions", po_environment_versions()},
      {"environment", environment(run, jobs)}, {"verdict", po_json_text(po_case_run_verdict(run))},
      {"seconds", po_json_number(run->elapsed)}, {"plan", plan_json(run->plan)}, {"points", points},
      {"digest", status ? NULL : po_json_text(digest)},
      {"checks", results_json(run, &run->check_results, check_json)},
      {"measured", results_json(run, &run->measured, measure_json)},
      {"left_out", left_out(run->plan)}, {"not_solved", not_solved(kase)}, {"lines", lines},
      {"solver", po_run_solver_json(run)});
}

/* Writes a record with this name. */
static po_status write_record(const po_case_run *run, const char *name, const char *output,
                              int jobs, const volatile sig_atomic_t *stop) {
  char *folder = po_path_join(output, run->plan->kase->file->name);
  char *path = folder ? po_path_join(folder, name) : NULL;
  json_t *points = NULL, *lines = NULL;
  po_text text = {0};
  po_status status = path ? po_folder_make(folder) : PO_NO_MEMORY;
  if (!status)
    status = write_points(run, folder, &points);
  if (!status)
    status = po_lines_write(run->plan->kase, folder, stop, &lines);
  if (!status) {
    json_t *record = record_json(run, jobs, points, lines);
    status = po_json_print_checked(record, &text);
    json_decref(record);
  } else {
    json_decref(points);
    json_decref(lines);
  }
  if (!status)
    status = po_file_write(path, text.data, text.length);
  po_text_clear(&text);
  free(path);
  free(folder);
  return status;
}

po_status po_record_write(const po_case_run *run, const char *output, int jobs,
                          const volatile sig_atomic_t *stop) {
  const po_status status = write_record(run, "record.json", output, jobs, stop);
  char *folder = status ? NULL : po_path_join(output, run->plan->kase->file->name);
  char *part = folder ? po_path_join(folder, PART) : NULL;
  if (part)
    unlink(part);
  free(part);
  free(folder);
  return status;
}

po_status po_record_write_part(po_case_run *run, const char *output, int jobs,
                               const volatile sig_atomic_t *stop) {
  for (size_t i = 0; i < run->plan->kase->point_count; ++i) {
    po_result *result = &run->results[i];
    if (run->asked[i])
      continue;
    run->beyond[i] = true;
    po_result_clear(result);
    *result = po_result_none();
    result->status = PO_UNSUPPORTED;
    result->work.seconds = (double)NAN;
    snprintf(result->reason, sizeof result->reason,
             "not asked: the run was limited to other points");
  }
  return write_record(run, PART, output, jobs, stop);
}
