/* Reading and writing of complete files. A file is written under a temporary name and then renamed,
 * so that no reader ever finds a partly written file. */
#ifndef PO_FILE_H
#define PO_FILE_H

#include <limits.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "po_status.h"

/* Reads a complete file. A pipe is read until its writer closes it, and can be read once. Returned:
 * *data, to be freed, with a NUL after its *size bytes. Status: PO_CANNOT_READ, with the name of
 * the file and the reason (absent, a folder, no permission, too long, a pipe that no program has
 * opened for writing in 5 s). */
po_status po_file_read(const char *path, char **data, size_t *size);

/* Writes `size` bytes to the file `path`. The bytes are written to a temporary file in the same
 * folder and flushed to the disk; then that file is renamed to `path`. A reader finds either the
 * old content or the new one. If `path` exists and is not a regular file (/dev/stdout, a pipe), it
 * is written in place; a pipe that no program has opened for reading in 5 s is refused. A
 * symbolic link is kept and its target is written. An existing file keeps
 * its permissions. Missing folders are not created. Status: PO_CANNOT_WRITE, with the name of the
 * file and the reason; then `path` is unchanged and no temporary file remains. PO_NO_MEMORY: an
 * allocation has failed in this thread (see po_no_memory_or), and nothing is written, because the
 * data may be incomplete. */
po_status po_file_write(const char *path, const char *data, size_t size);

/* Creates a folder and its parents, as mkdir -p does. Status: PO_CANNOT_WRITE, with the path that
 * prevents it. */
po_status po_folder_make(const char *path);

/* Returned: whether `path` exists. */
bool po_path_exists(const char *path);

/* Returned: the number of the pipe without a name to which `path` leads (/dev/stdin of a pipeline,
 * the <(...) of a shell); 0: it leads to something else. No program can write such a pipe anew. */
uint64_t po_path_pipe(const char *path);

/* Returned: whether two paths refer to the same existing file. */
bool po_path_is_same(const char *a, const char *b);

/* A path. One that is too long for the system is cut, and is then still too long for it: a file of
 * this path cannot be opened. */
typedef struct {
  char text[PATH_MAX + 2];
} po_file_path;

/* Returned: folder/name, or name if it is absolute or the folder is "". */
po_file_path po_path_join(const char *folder, const char *name);

/* Returned: the path of a program that can be executed: `name` if it has a slash, else in a folder
 * of PATH; "" if there is none. */
po_file_path po_program_find(const char *name);

/* Lists the names in a folder that end in `ending`, in byte order; hidden files are left out.
 * Returned: *names, *count of them, to be freed with po_names_free. Status: PO_CANNOT_READ,
 * PO_NO_MEMORY. */
po_status po_folder_list(const char *path, const char *ending, char ***names, size_t *count);
void po_names_free(char **names, size_t count);

#endif
