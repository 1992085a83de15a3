/* A string with dynamic length. */
#ifndef PO_TEXT_H
#define PO_TEXT_H

#include <stdbool.h>
#include <stddef.h>

#include "po_status.h"

/* Initialise to zero, append, use `data` (NUL-terminated after the first append), clear. If memory
 * runs out, `failed` is set, later appends are ignored, and po_message() states it. */
typedef struct {
  char *data;
  size_t length;
  size_t capacity;
  bool failed;
} po_text;

/* Appends formatted text (printf style). */
void po_text_add(po_text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Appends `size` bytes unchanged. */
void po_text_add_bytes(po_text *text, const char *bytes, size_t size);

/* Appends a word so that a shell reads it back unchanged: quoted if necessary, with the escapes of
 * $'...' if it has characters that a terminal cannot show. */
void po_text_add_word(po_text *text, const char *word);

/* Returned: the string; "" before the first append. */
const char *po_text_string(const po_text *text);

/* Returned: the word for a count: `one` for 1, else `more`: "point", "points". */
const char *po_one_or_more(size_t count, const char *one, const char *more);

/* Frees the string and sets it to zero. */
void po_text_clear(po_text *text);

/* Returned: the string, to be freed; NULL before the first append, and if memory ran out. */
char *po_text_take(po_text *text);

/* Prints the string on standard output and clears it. Status: PO_NO_MEMORY; then nothing is
 * printed. */
po_status po_text_print(po_text *text);

#endif
