/* Whole files: read at once, written beside and renamed, so that nothing is ever half-written. */
#ifndef PO_FILE_H
#define PO_FILE_H

#include <stdbool.h>
#include <stddef.h>

#include "po_status.h"

/* Reads a file whole into *data (free it), with a NUL after its *size bytes.
 * Status: PO_CANNOT_READ naming the file and why (absent, a folder, no permission, too long). */
po_status po_file_read(const char *path, char **data, size_t *size);

/* After memory ran out in this thread (po_lack_or), po_file_write and po_file_append_line write
 * nothing, as their input may be incomplete. Status: PO_NO_MEMORY. */

/* Writes `size` bytes as the file `path`: into a file beside it, flushed to the disk, then renamed
 * over it, so a reader finds the old content or the new. What is there and is not a regular file
 * (/dev/stdout, a pipe) is written in place. A symbolic link stays, and the file it leads to is
 * written; the file keeps its permissions. Folders on the way are not made.
 * Status: PO_CANNOT_WRITE naming the file and why; then `path` is as it was and nothing is left. */
po_status po_file_write(const char *path, const char *data, size_t size);

/* Appends a line, which ends in a newline, in one piece, as another process may append to the same
 * file; the file is made if it does not exist. If the last line has no newline, as a killed process
 * or a full disk may leave it, the appended line begins on a new line. Status: PO_CANNOT_WRITE
 * naming the file and why; then nothing of the line is left. */
po_status po_file_append_line(const char *path, const char *line, size_t size);

/* Makes a folder and those above it, as mkdir -p. Status: PO_CANNOT_WRITE, naming what is in the
 * way.
 */
po_status po_folder_make(const char *path);

/* Whether something is at `path`. */
bool po_path_exists(const char *path);

/* Whether two paths lead to the same file. */
bool po_path_is_same(const char *a, const char *b);

/* folder/name, or name alone when it is absolute or the folder is ""; NULL without memory. */
char *po_path_join(const char *folder, const char *name);

/* The names in a folder that end in `ending`, sorted by bytes: *names of *count, to be given to
 * po_names_free. Status: PO_CANNOT_READ. */
po_status po_folder_list(const char *path, const char *ending, char ***names, size_t *count);
void po_names_free(char **names, size_t count);

#endif
