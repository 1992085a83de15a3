#include "po_record.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "po_file.h"

static const char NAME[] = "points.jsonl";

/* Reads a point if it is requested and its key agrees. A result that is known already remains if
 * the entry does not have its checksum. */
static po_status read_entry(po_case_run *run, json_t *entry, const char *folder) {
  json_t *point = json_object_get(entry, "point");
  const char *key = json_string_value(json_object_get(entry, "key"));
  const char *id = json_string_value(json_object_get(point, "id"));
  size_t index = 0;
  char expected[PO_DIGEST_LENGTH];
  if (!key || !id || !po_number_parse_count(id, &index) || index >= run->plan->kase->point_count ||
      !run->points[index].asked)
    return PO_OK;
  po_status status = po_record_key(run, index, expected);
  if (!status && strcmp(key, expected) == 0)
    status = po_record_read_point(run, index, point, folder, false);
  return status == PO_NO_MEMORY ? status : PO_OK;
}

/* A line that is not JSON is damaged; it is ignored and its point is solved again. So is an
 * incomplete last line, which a killed run leaves behind. */
static po_status read_line(po_case_run *run, const char *line, size_t length, bool is_complete,
                           const char *folder) {
  json_t *entry = NULL;
  po_status status = po_json_parse(line, length, &entry);
  if (!status)
    status = read_entry(run, entry, folder);
  else if (is_complete)
    run->altered += 1;
  json_decref(entry);
  return status == PO_NO_MEMORY ? status : PO_OK;
}

po_status po_journal_read(po_case_run *run, const char *folder) {
  char *path = po_path_join(folder, NAME), *bytes = NULL;
  size_t size = 0;
  po_status status = path ? PO_OK : PO_NO_MEMORY;
  if (!status && po_path_exists(path))
    status = po_file_read(path, &bytes, &size);
  for (size_t begin = 0; !status && begin < size;) {
    const char *end = memchr(bytes + begin, '\n', size - begin);
    const size_t length = end ? (size_t)(end - bytes) - begin : size - begin;
    status = read_line(run, bytes + begin, length, end != NULL, folder);
    begin += length + 1;
  }
  free(bytes);
  free(path);
  return status;
}

static po_status append(const char *path, const json_t *entry) {
  po_text text = {0};
  po_status status = po_json_print_line(entry, &text);
  if (!status)
    status = po_file_append_line(path, text.data, text.length);
  po_text_clear(&text);
  return status;
}

po_status po_journal_add(const po_case_run *run, size_t point, const char *folder) {
  char *path = po_path_join(folder, NAME), key[PO_DIGEST_LENGTH];
  po_status status = path ? po_record_key(run, point, key) : PO_NO_MEMORY;
  if (!status)
    status = po_folder_make(folder);
  json_t *object = NULL;
  if (!status)
    status = po_record_entry(run, point, folder, false, &object);
  if (!status) {
    json_t *entry = PO_JSON_OBJECT({"key", po_json_text(key)}, {"point", object});
    status = append(path, entry);
    json_decref(entry);
  } else
    json_decref(object);
  free(path);
  return status;
}

po_status po_journal_remove(const char *folder) {
  char *path = po_path_join(folder, NAME);
  po_status status = path ? PO_OK : PO_NO_MEMORY;
  if (!status && unlink(path) != 0 && errno != ENOENT)
    status = po_fail(PO_CANNOT_WRITE, "%s cannot be removed: %s", path, strerror(errno));
  free(path);
  return status;
}
