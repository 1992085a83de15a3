#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_file.h"
#include "po_json.h"
#include "po_json_digest.h"
#include "po_record.h"
#include "po_rounds.h"
#include "po_tables.h"

static const char *string_of(const json_t *object, const char *key) {
  const char *text = json_string_value(json_object_get(object, key));
  return text ? text : "";
}

static double number_or_nan(const json_t *value) {
  return json_is_number(value) ? json_number_value(value) : (double)NAN;
}

static po_status read_table(const json_t *point, bool profile, bool needed, const char *folder,
                            po_result *result) {
  const char *name = string_of(point, profile ? "profile" : "curve");
  const char *digest = string_of(point, profile ? "profile_sha256" : "curve_sha256");
  if (!*name)
    return needed && result->status == PO_OK ? PO_NOT_FOUND : PO_OK;
  char *path = po_path_join(folder, name);
  if (!path)
    return PO_NO_MEMORY;
  const po_status status = profile ? po_tables_read_profile(path, digest, result)
                                   : po_tables_read_curve(path, digest, result);
  free(path);
  return status;
}

/* Whether the result that was read has the digest of its entry: PO_NOT_FOUND if it was altered. */
static po_status check_digest(po_case_run *run, size_t index, const json_t *entry,
                              const po_result *result) {
  char digest[PO_RESULT_DIGEST_LENGTH];
  json_t *object = po_json_result(&run->plan->kase->points[index].request, result);
  po_status status = po_json_digest(object, digest);
  json_decref(object);
  if (!status && strcmp(digest, string_of(entry, "digest")) != 0) {
    run->altered += 1;
    status = PO_NOT_FOUND;
  }
  return status;
}

po_status po_record_read_point(po_case_run *run, size_t index, const json_t *point,
                               const char *folder) {
  const unsigned repeats = run->plan->kase->repeats;
  po_result *result = &run->results[index];
  const json_t *seconds = json_object_get(point, "seconds_all");
  const json_t *processor = json_object_get(point, "processor_seconds_all");
  if (strcmp(string_of(point, "id"), run->plan->kase->points[index].id) != 0 ||
      json_array_size(seconds) > repeats || json_array_size(processor) != json_array_size(seconds))
    return PO_NOT_FOUND;
  po_status status = po_json_read_result(point, result);
  if (!status && result->status == PO_NO_MEMORY)
    status = PO_NOT_FOUND; /* lack of memory is no result: the point is solved again */
  if (!status)
    status = check_digest(run, index, point, result);
  if (!status && run->plan->kase->points[index].traced) {
    po_result_clear(&run->traces[index]);
    status = po_json_read_result(json_object_get(point, "traced"), &run->traces[index]);
    if (!status)
      status = check_digest(run, index, json_object_get(point, "traced"), &run->traces[index]);
  }
  for (unsigned i = 0; i < repeats; ++i) {
    const size_t place = index * repeats + i;
    run->seconds[place] = number_or_nan(json_array_get(seconds, i));
    run->processor_seconds[place] = number_or_nan(json_array_get(processor, i));
  }
  if (!status)
    status = po_rounds_read(run, index, json_object_get(point, "timing"));
  if (!status)
    status = read_table(point, false, run->plan->want & PO_WANT_CURVE, folder, result);
  if (!status)
    status = read_table(point, true, run->plan->want & PO_WANT_PROFILE, folder, result);
  return status;
}

static po_status read_record(po_case_run *run, const json_t *record, const char *folder) {
  const json_t *points = json_object_get(record, "points");
  if (strcmp(string_of(record, "solve_key"), run->plan->solve_key) != 0 ||
      json_array_size(points) != run->plan->kase->point_count)
    return PO_NOT_FOUND;
  po_status status = PO_OK;
  for (size_t i = 0; !status && i < run->plan->kase->point_count; ++i)
    status = po_record_read_point(run, i, json_array_get(points, i), folder);
  if (!status) {
    snprintf(run->old_key, sizeof run->old_key, "%s", string_of(record, "key"));
    run->elapsed = json_number_value(json_object_get(record, "seconds"));
    run->kept = run->finished = true;
    run->pending = 0;
    for (size_t i = 0; i < run->plan->kase->point_count; ++i)
      run->done[i] = true;
  } else
    for (size_t i = 0; i < run->plan->kase->point_count; ++i)
      po_result_clear(&run->results[i]);
  return status;
}

/* A damaged record counts as absent. Without memory it is not known whether it is damaged. */
static po_status found_or_not(po_status status) {
  return status == PO_OK || status == PO_NO_MEMORY ? status : PO_NOT_FOUND;
}

/* Reads the record in the folder of a case. */
static po_status load(const char *folder, json_t **record) {
  char *path = po_path_join(folder, "record.json");
  char *bytes = NULL;
  size_t size = 0;
  po_status status = path ? po_file_read(path, &bytes, &size) : PO_NO_MEMORY;
  if (!status)
    status = po_json_parse(bytes, size, record);
  free(bytes);
  free(path);
  return found_or_not(status);
}

po_status po_record_read(po_case_run *run, const char *output) {
  char *folder = po_path_join(output, run->plan->kase->file->name);
  json_t *record = NULL;
  po_status status = folder ? load(folder, &record) : PO_NO_MEMORY;
  if (!status)
    status = read_record(run, record, folder);
  json_decref(record);
  free(folder);
  return found_or_not(status);
}

po_status po_record_check_owner(const po_case_run *run, const char *output) {
  const po_case *kase = run->plan->kase;
  json_t *record = NULL;
  if (!kase->is_own)
    return PO_OK;
  char *folder = po_path_join(output, kase->file->name);
  po_status status = folder ? load(folder, &record) : PO_NO_MEMORY;
  const char *owner = string_of(record, "file");
  if (!status && po_path_exists(owner) && !po_path_is_same(owner, kase->path))
    status = po_fail(
        PO_BAD_INPUT,
        "%s: name is %s: expected another name or another folder for the records, as %s contains "
        "the record of %s",
        kase->shown, kase->file->name, folder, owner);
  json_decref(record);
  free(folder);
  return status == PO_NOT_FOUND ? PO_OK : status;
}
