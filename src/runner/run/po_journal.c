#include "po_record.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
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
  const po_file_path path = po_path_join(folder, NAME);
  char *bytes = NULL;
  size_t size = 0;
  po_status status = po_path_exists(path.text) ? po_file_read(path.text, &bytes, &size) : PO_OK;
  for (size_t begin = 0; !status && begin < size;) {
    const char *end = memchr(bytes + begin, '\n', size - begin);
    const size_t length = end ? (size_t)(end - bytes) - begin : size - begin;
    status = read_line(run, bytes + begin, length, end != NULL, folder);
    begin += length + 1;
  }
  free(bytes);
  return status;
}

/* Returned: whether a file of `size` bytes ends without a newline. */
static bool lacks_newline(int file, off_t size) {
  char last = '\n';
  return size > 0 && pread(file, &last, 1, size - 1) == 1 && last != '\n';
}

/* Removes a line that was written only in part. If another process has appended to the file in the
 * meantime, the partial line stays; readers skip it. */
static void remove_partial_line(int file, off_t before, off_t put) {
  struct stat now;
  if (put > 0 && fstat(file, &now) == 0 && now.st_size == before + put)
    (void)!ftruncate(file, before);
}

/* Appends a line. Returned: 0 or the errno. */
static int append_line(int file, const char *line, size_t size) {
  struct stat found;
  if (fstat(file, &found) != 0)
    return errno;
  if (lacks_newline(file, found.st_size) && write(file, "\n", 1) == 1)
    found.st_size += 1;
  errno = 0;
  const ssize_t put = write(file, line, size);
  if (put == (ssize_t)size)
    return 0;
  const int error = put < 0 ? errno : ENOSPC; /* a short write does not set errno */
  remove_partial_line(file, found.st_size, put);
  return error;
}

/* Appends a line with one write, because another process may append to the same file. If its last
 * line has no newline, as after a killed process or on a full disk, the new line starts after an
 * added newline. Status: PO_CANNOT_WRITE; then no part of the line remains. */
static po_status append(const char *path, const json_t *entry) {
  po_text text = {0};
  po_status status = po_json_print_line(entry, &text);
  if (!status)
    status = po_no_memory_or(PO_OK); /* the entry may be incomplete */
  if (!status) {
    const int file = open(path, O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    int error = file < 0 ? errno : append_line(file, text.data, text.length);
    if (file >= 0 && close(file) != 0 && !error)
      error = errno;
    if (error)
      status = po_fail(PO_CANNOT_WRITE, "%s cannot be written: %s", path, strerror(error));
  }
  po_text_clear(&text);
  return status;
}

po_status po_journal_add(const po_case_run *run, size_t point, const char *folder) {
  char key[PO_DIGEST_LENGTH];
  po_status status = po_record_key(run, point, key);
  if (!status)
    status = po_folder_make(folder);
  json_t *object = NULL;
  if (!status)
    status = po_record_entry(run, point, folder, false, &object);
  if (!status) {
    json_t *entry = PO_JSON_OBJECT({"key", po_json_text(key)}, {"point", object});
    status = append(po_path_join(folder, NAME).text, entry);
    json_decref(entry);
  } else
    json_decref(object);
  return status;
}

po_status po_journal_remove(const char *folder) {
  const po_file_path path = po_path_join(folder, NAME);
  if (unlink(path.text) != 0 && errno != ENOENT)
    return po_fail(PO_CANNOT_WRITE, "%s cannot be removed: %s", path.text, strerror(errno));
  return PO_OK;
}
