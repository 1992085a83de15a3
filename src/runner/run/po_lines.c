#include "po_lines.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "po_json_digest.h"
#include "po_memory.h"

/* Returned: whether a file of `size` bytes ends without a newline. */
static bool lacks_newline(int file, off_t size) {
  char last = '\n';
  return size > 0 && pread(file, &last, 1, size - 1) == 1 && last != '\n';
}

/* Appends a line with one write, because another process may append to the same file. After the
 * beginning of a line, which a killed process or a full disk leaves, it starts with a newline.
 * Returned: 0 or the errno. */
static int append_line(int file, const po_text *line) {
  struct stat found;
  if (fstat(file, &found) != 0 || (lacks_newline(file, found.st_size) && write(file, "\n", 1) != 1))
    return errno;
  errno = ENOSPC; /* a short write does not set it */
  return write(file, line->data, line->length) == (ssize_t)line->length ? 0 : errno;
}

po_status po_lines_append(const char *path, const po_text *line) {
  const int file = open(path, O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  int error = file < 0 ? errno : append_line(file, line);
  if (file >= 0 && close(file) != 0 && !error)
    error = errno;
  return error ? po_fail(PO_CANNOT_WRITE, "%s cannot be written: %s", path, strerror(error))
               : PO_OK;
}

static po_status read_line(const char *line, size_t length, po_lines_visit *visit, void *data) {
  json_t *document = NULL;
  bool intact = false;
  po_status status = po_json_parse_checked(line, length, &document, &intact);
  if (status != PO_NO_MEMORY)
    status = visit(data, !status && intact ? document : NULL, true);
  json_decref(document);
  return status;
}

/* Line by line: with curves, a file may be larger than what is read at once. The last line counts
 * only if it is complete. */
po_status po_lines_read(const char *path, po_lines_visit *visit, void *data) {
  char *line = NULL;
  size_t size = 0;
  po_status status = PO_OK;
  po_memory_watch();
  FILE *file = fopen(path, "re");
  errno = file ? 0 : errno;
  for (ssize_t length; file && !status && (length = getline(&line, &size, file)) > 0;)
    status = line[length - 1] == '\n' ? read_line(line, (size_t)length, visit, data)
                                      : visit(data, NULL, false);
  if (po_memory_ran_out() && !status)
    status = po_fail(PO_NO_MEMORY, "no memory to read %s", path);
  else if (!status && (file ? ferror(file) : errno != ENOENT))
    status = po_fail(PO_CANNOT_READ, "%s cannot be read: %s", path, strerror(errno));
  free(line);
  if (file)
    fclose(file);
  return status;
}
