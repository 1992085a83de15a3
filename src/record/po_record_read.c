#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_csv.h"
#include "po_file.h"
#include "po_record.h"
#include "po_record_point.h"

/* A damaged record counts as absent. Without memory it is not known whether it is damaged. */
static po_status found_or_not(po_status status) {
  return status == PO_OK || status == PO_NO_MEMORY ? status : PO_NOT_FOUND;
}

/* Whether the tables of the closed forms have the checksums of the record. */
static po_status check_lines(const json_t *lines, const char *folder) {
  po_status status = PO_OK;
  for (size_t i = 0; !status && i < json_array_size(lines); ++i) {
    const json_t *line = json_array_get(lines, i);
    char *path = po_path_join(folder, po_record_text(line, "table"));
    po_csv csv = {0};
    status = path ? po_csv_read(path, path, &csv) : PO_NO_MEMORY;
    if (!status && strcmp(csv.digest, po_record_text(line, "table_sha256")) != 0)
      status = PO_NOT_FOUND;
    po_csv_clear(&csv);
    free(path);
  }
  return found_or_not(status);
}

/* Reads the points that are requested and not known. A record without its checksum was altered:
 * the points that have theirs are used, and the record is written again. */
static po_status read_record(po_case_run *run, const json_t *record, bool intact,
                             const char *folder) {
  const json_t *points = json_object_get(record, "points");
  if (strcmp(po_record_text(record, "solve_key"), run->plan->solve_key) != 0 &&
      (intact || !json_object_get(record, "checksum")))
    return PO_NOT_FOUND; /* of other scenes or of another program */
  for (size_t i = 0; i < run->plan->kase->point_count; ++i)
    if (run->asked[i] && !run->done[i] &&
        po_record_read_point(run, i, json_array_get(points, i), folder, intact) == PO_NO_MEMORY)
      return PO_NO_MEMORY;
  if (!po_case_run_is_done(run))
    return PO_NOT_FOUND;
  const po_status lines = check_lines(json_object_get(record, "lines"), folder);
  if (lines == PO_NO_MEMORY)
    return lines;
  run->damaged = !intact || lines;
  snprintf(run->old_key, sizeof run->old_key, "%s",
           run->damaged ? "" : po_record_text(record, "key"));
  run->elapsed = json_number_value(json_object_get(record, "seconds"));
  run->kept = run->finished = true;
  run->pending = 0;
  return PO_OK;
}

/* Reads the record in the folder of a case. Returned: *intact, whether it has its checksum;
 * *exists, whether there is a file, which may be no JSON. */
static po_status load(const char *folder, json_t **record, bool *intact, bool *exists) {
  char *path = po_path_join(folder, "record.json");
  char *bytes = NULL;
  size_t size = 0;
  po_status status = path ? po_file_read(path, &bytes, &size) : PO_NO_MEMORY;
  *exists = status == PO_OK;
  if (!status)
    status = po_json_parse_checked(bytes, size, record, intact);
  free(bytes);
  free(path);
  return found_or_not(status);
}

po_status po_record_read(po_case_run *run, const char *folder) {
  json_t *record = NULL;
  bool intact = false, exists = false;
  po_status status = load(folder, &record, &intact, &exists);
  if (status == PO_NOT_FOUND && exists)
    run->altered += run->asked_count;
  if (!status)
    status = read_record(run, record, intact, folder);
  json_decref(record);
  return found_or_not(status);
}

po_status po_record_check_owner(const po_case_run *run) {
  const po_case *kase = run->plan->kase;
  json_t *record = NULL;
  bool intact, exists;
  if (!kase->is_own)
    return PO_OK;
  po_status status = load(run->folder, &record, &intact, &exists);
  const char *owner = po_record_text(record, "file");
  if (!status && po_path_exists(owner) && !po_path_is_same(owner, kase->path))
    status = po_fail(
        PO_BAD_INPUT,
        "%s: name is %s: expected another name or another folder for the records, as %s contains "
        "the record of %s",
        kase->shown, kase->file->name, run->folder, owner);
  json_decref(record);
  return status == PO_NOT_FOUND ? PO_OK : status;
}
