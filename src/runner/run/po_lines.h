/* Files of JSON lines, each with its checksum, to which results are appended as they are ready.
 *
 * A line is appended with one write and never changed. So a process that is killed leaves at most
 * the beginning of a line, which is ignored; an altered line is noticed; and several threads or
 * processes may append to one file. Nothing is locked. */
#ifndef PO_LINES_H
#define PO_LINES_H

#include "po_json_value.h"
#include "po_text.h"

/* Appends one line, with its newline. It is not flushed to the disk, which takes longer than a
 * quick solve: after a power failure its checksum shows whether it is whole. Status:
 * PO_CANNOT_WRITE. */
po_status po_lines_append(const char *path, const po_text *line);

/* Is given the document of a line; NULL: the line was altered, or, if it is not whole, it is the
 * beginning of one. A status other than PO_OK ends the reading. */
typedef po_status po_lines_visit(void *data, const json_t *document, bool whole);

/* Reads a file line by line; one that does not exist has no lines. Status: PO_CANNOT_READ (the file
 * exists but cannot be read), PO_NO_MEMORY, and those of the visit. */
po_status po_lines_read(const char *path, po_lines_visit *visit, void *data);

#endif
