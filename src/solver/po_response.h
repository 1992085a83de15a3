/* The lines of a response file that is being written. */
#ifndef PO_RESPONSE_H
#define PO_RESPONSE_H

#include <stdbool.h>
#include <stddef.h>

#include "po_text.h"

/* A response, and the longest line in it, of more bytes end the process. */
extern const size_t PO_RESPONSE_BYTES, PO_RESPONSE_LINE;

typedef struct {
  const char *path;
  int file;        /* -1: the file does not exist yet */
  size_t read;     /* bytes read so far */
  size_t taken;    /* bytes of `pending` that are lines which were taken */
  po_text pending; /* bytes after the last complete line */
  char wrong[120]; /* what is wrong with the file; "": nothing */
} po_response;

/* Reads what has been added to the file. The file must be a regular one: a link is not followed.
 * Returned: false if something is wrong with it, see `wrong`, or without memory. */
bool po_response_read(po_response *response);

/* Returned: the next complete line, *length bytes that end with a NUL; NULL if there is none.
 * Given: `last`, whether the rest of the file counts as a line although it has no newline. */
const char *po_response_line(po_response *response, bool last, size_t *length);

void po_response_close(po_response *response);

#endif
