#include "po_record.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "po_csv.h"
#include "po_environment.h"
#include "po_file.h"
#include "po_json_digest.h"

static const char RECORD[] = "record.json";

static po_status write_line(const po_case *kase, const po_case_line *line, const char *folder,
                            const volatile sig_atomic_t *stop, json_t **entry) {
  po_text header = {0}, rows = {0}, text = {0};
  char digest[PO_DIGEST_LENGTH];
  po_file_path name;
  snprintf(name.text, sizeof name.text, "line-%s.csv", line->name);
  po_text_add(&header,
              "# what: pulloff theory %s along a sweep\n"
              "# units: lengths and approach in epsilon; forces and load in pi w R, of a "
              "profile without a radius in pi w epsilon, load compressive > 0; work in w; tension "
              "and traction in w/epsilon\n"
              "# command: pulloff run %s\n",
              line->theory, po_case_word(kase));
  po_status status = po_case_line_table(kase->file, line, stop, &rows);
  po_csv_seal(&header, &rows, &text, digest);
  if (!status)
    status = po_file_write(po_path_join(folder, name.text).text, text.data, text.length);
  po_json_set(entry, "table", po_json_text(name.text));
  po_json_set(entry, "table_sha256", po_json_text(digest));
  po_text_clear(&header);
  po_text_clear(&rows);
  po_text_clear(&text);
  return status;
}

/* Writes the table line-NAME.csv of each line.
 * Given: `stop`, as for po_record_write.
 * Returned: in *lines, [{name, theory, table, table_sha256}].
 * Status: PO_NO_MEMORY, PO_CANNOT_WRITE, PO_INTERRUPTED (the table of the interrupted line is not
 * written). */
static po_status write_lines(const po_case *kase, const char *folder,
                             const volatile sig_atomic_t *stop, json_t **lines) {
  po_status status = PO_OK;
  *lines = po_json_empty_array();
  for (unsigned i = 0; !status && i < kase->file->lines_count; ++i) {
    const po_case_line *line = &kase->file->lines[i];
    json_t *entry =
        PO_JSON_OBJECT({"name", po_json_text(line->name)}, {"theory", po_json_text(line->theory)});
    status = write_line(kase, line, folder, stop, &entry);
    po_json_append(lines, entry);
  }
  return status;
}

/* Returned: the command that applies a verb to a case, quoted for a shell. */
static json_t *command_json(const char *verb, const po_plan *plan) {
  po_text text = {0};
  po_text_add(&text, "pulloff %s %s", verb, po_case_word(plan->kase));
  po_plan_add_options(plan, &text);
  return po_json_take_text(po_text_take(&text));
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
      {"ratio", po_json_number(item->ratio)}, {"ledger", po_json_text(PO_LEDGERS[item->ledger])},
      {"verdict", po_json_text(PO_VERDICTS[item->verdict])},
      {"passes", json_boolean(po_verdict_passes(item->verdict))},
      {"note", po_json_text(item->note)}, {"reference", po_json_text(item->reference->name)},
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
      {"reference", po_json_text(item->reference->name)});
}

static json_t *conditions(const po_leave_out *rule) {
  json_t *when = po_json_empty_array();
  for (unsigned k = 0; k < rule->when_count; ++k) {
    const po_axis *axis = &rule->when[k];
    po_json_append(&when,
                   PO_JSON_OBJECT({"key", po_json_text(axis->key)},
                                  {"values", po_json_texts(axis->values, axis->values_count)}));
  }
  return when;
}

/* Returned: the rules of `leave_out`, with the number of combinations for which each holds. */
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
    json_t *point = NULL;
    status = po_record_entry(run, i, folder, &point);
    po_json_append(points, point);
  }
  return status;
}

static json_t *results_json(const po_case_run *run, const po_check_results *check_results,
                            json_t *(*item_json)(const po_case_run *, const po_check_result *)) {
  json_t *items = po_json_empty_array();
  for (size_t i = 0; i < check_results->count; ++i)
    po_json_append(&items, item_json(run, &check_results->items[i]));
  return items;
}

static json_t *processes_json(const po_case_run *run) {
  json_t *array = po_json_empty_array();
  for (size_t i = 0; i < run->process_count; ++i) {
    const po_ask_process *p = &run->processes[i];
    po_json_append(&array, PO_JSON_OBJECT({"asked", po_json_count(p->asked)},
                                          {"answered", po_json_count(p->found.answered)},
                                          {"seconds", po_json_number(p->wall)},
                                          {"processor_seconds", po_json_number(p->processor)},
                                          {"first_answer", po_json_number(p->first)},
                                          {"reported_seconds", po_json_number(p->found.reported)},
                                          {"left_behind", po_json_count(p->left)}));
  }
  return array;
}

/* Returned: what the record says about an external solver; null for a run of this program. */
static json_t *solver_json(const po_case_run *run) {
  const po_solver *solver = run->plan->solver;
  const po_coverage *c = &run->coverage;
  if (!solver)
    return json_null();
  const po_solver_file *file = solver->file;
  return PO_JSON_OBJECT(
      {"name", po_json_text(solver->name)}, {"manifest", po_json_text(solver->path.text)},
      {"knob", po_json_text(file->knob ? file->knob->name : NULL)},
      {"knob_value", po_json_text(solver->knob)},
      {"command", po_json_texts(file->command, file->command_count)},
      {"quantities", po_json_texts(file->can.quantities, file->can.quantities_count)},
      {"unstable", json_boolean(solver->unstable)}, {"sha256", po_json_text(solver->digest)},
      {"coverage",
       PO_JSON_OBJECT({"points", po_json_count(c->points)}, {"asked", po_json_count(c->asked)},
                      {"checks", po_json_count(c->checks)}, {"made", po_json_count(c->made)},
                      {"not_reachable", po_json_count(c->not_reachable)})},
      {"processes", processes_json(run)});
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
      {"equations", po_json_text(file->equations)},
      {"suites", po_json_texts(file->suite_names, file->suite_names_count)},
      {"file", po_json_text(kase->shown)}, {"key", po_json_text(run->plan->key)},
      {"solve_key", po_json_text(run->plan->solve_key)},
      {"scenes", po_json_text(run->plan->pins.scenes)},
      {"figure_script", po_json_text(file->figure_script)},
      {"command", command_json("run", run->plan)}, {"versions", po_environment_versions()},
      {"environment",
       run->environment ? json_incref(run->environment) : po_environment_describe(jobs)},
      {"verdict", po_json_text(po_case_run_verdict(run))},
      {"seconds", po_json_number(run->elapsed)}, {"plan", po_plan_describe(run->plan)},
      {"points", points}, {"digest", status ? NULL : po_json_text(digest)},
      {"checks", results_json(run, &run->check_results, check_json)},
      {"measured", results_json(run, &run->measured, measure_json)},
      {"left_out", left_out(run->plan)}, {"not_solved", not_solved(kase)}, {"lines", lines},
      {"solver", solver_json(run)});
}

po_status po_record_write(po_case_run *run, const char *folder, int jobs,
                          const volatile sig_atomic_t *stop) {
  const bool whole = po_case_run_is_whole(run);
  const po_file_path part = po_path_join(folder, "part.json"), path = po_path_join(folder, RECORD);
  json_t *points = NULL, *lines = NULL;
  char digest[PO_DIGEST_LENGTH];
  po_text text = {0};
  po_status status = po_folder_make(folder);
  for (size_t i = 0; i < run->plan->kase->point_count; ++i)
    if (!run->points[i].asked)
      po_case_run_exclude(run, i, "the run was limited to other points");
  if (!status)
    status = write_points(run, folder, &points);
  if (!status)
    status = write_lines(run->plan->kase, folder, stop, &lines);
  if (!status) {
    json_t *record = record_json(run, jobs, points, lines);
    status = po_json_print_checked(record, false, &text, digest);
    json_decref(record);
  } else {
    json_decref(points);
    json_decref(lines);
  }
  if (!status)
    status = po_file_write(whole ? path.text : part.text, text.data, text.length);
  if (!status && whole)
    unlink(part.text);
  po_text_clear(&text);
  return status;
}

/* Reads the record in a folder. Returned: *record, NULL if there is none; *intact, whether it has
 * its checksum; *exists, whether there is a file, which may be no JSON. Status: PO_NO_MEMORY. */
static po_status load_record(const char *folder, json_t **record, bool *intact, bool *exists) {
  char *bytes = NULL;
  size_t size = 0;
  po_status status = po_file_read(po_path_join(folder, RECORD).text, &bytes, &size);
  *exists = status == PO_OK;
  *intact = false;
  if (!status)
    status = po_json_parse_checked(bytes, size, record, intact);
  free(bytes);
  return status == PO_NO_MEMORY ? status : PO_OK;
}

/* Checks that a table beside the record has the checksum that the member NAME_sha256 states.
 * Status: PO_NOT_FOUND if it does not; PO_NO_MEMORY. */
static po_status check_table(const json_t *entry, const char *name, const char *folder) {
  char key[32];
  po_csv csv = {0};
  if (!*po_record_text(entry, name))
    return PO_OK;
  const po_file_path path = po_path_join(folder, po_record_text(entry, name));
  snprintf(key, sizeof key, "%s_sha256", name);
  po_status status = po_csv_read(path.text, path.text, &csv);
  if (!status && strcmp(csv.digest, po_record_text(entry, key)) != 0)
    status = PO_NOT_FOUND;
  po_csv_clear(&csv);
  return status == PO_OK || status == PO_NO_MEMORY ? status : PO_NOT_FOUND;
}

static po_status check_tables(const json_t *record, const char *folder) {
  const json_t *entry;
  size_t i;
  po_status status = PO_OK;
  json_array_foreach(json_object_get(record, "points"), i, entry) {
    if (!status)
      status = check_table(entry, "curve", folder);
    if (!status)
      status = check_table(entry, "profile", folder);
    if (!status)
      status = check_table(entry, "loop", folder);
  }
  json_array_foreach(json_object_get(record, "lines"), i, entry) {
    if (!status)
      status = check_table(entry, "table", folder);
  }
  return status;
}

/* Reports whether a record is that of this plan and of the files of the store that were read. */
static bool is_of_run(const po_case_run *run, const json_t *record) {
  const json_t *points = json_object_get(record, "points");
  bool same = strcmp(po_record_text(record, "key"), run->plan->key) == 0;
  for (size_t i = 0; same && i < run->plan->kase->point_count; ++i)
    same = !run->points[i].asked || strcmp(po_record_text(json_array_get(points, i), "checksum"),
                                           run->points[i].checksum) == 0;
  return same;
}

po_status po_record_check(po_case_run *run, const char *folder) {
  json_t *record = NULL;
  bool intact, exists;
  po_status status = load_record(folder, &record, &intact, &exists);
  const po_status tables = status || !intact ? PO_OK : check_tables(record, folder);
  if (tables == PO_NO_MEMORY)
    status = tables;
  run->damaged = !status && ((exists && !intact) || tables);
  run->current = !status && record && !run->damaged && is_of_run(run, record);
  if (run->current)
    run->elapsed = json_number_value(json_object_get(record, "seconds"));
  json_decref(record);
  return status;
}

po_status po_record_check_owner(const po_case_run *run) {
  const po_case *kase = run->plan->kase;
  json_t *record = NULL;
  bool intact, exists;
  if (!kase->is_own)
    return PO_OK;
  po_status status = load_record(run->folder.text, &record, &intact, &exists);
  const char *owner = po_record_text(record, "file");
  if (!status && po_path_exists(owner) && !po_path_is_same(owner, kase->path))
    status = po_fail(
        PO_BAD_INPUT,
        "%s: name is %s: expected another name or another folder for the records, as %s contains "
        "the record of %s",
        kase->shown, kase->file->name, run->folder.text, owner);
  json_decref(record);
  return status;
}
