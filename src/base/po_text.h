/* A string that grows. */
#ifndef PO_TEXT_H
#define PO_TEXT_H

#include <stdbool.h>
#include <stddef.h>

/* Zero-initialise, add, use `data` (NUL-terminated once something was added), clear. When memory
 * runs out `failed` stays set, further additions are ignored, and po_message() says so. */
typedef struct {
  char *data;
  size_t length;
  size_t capacity;
  bool failed;
} po_text;

/* Appends, printf style. */
void po_text_add(po_text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Appends `size` bytes as they are. */
void po_text_add_bytes(po_text *text, const char *bytes, size_t size);

/* Appends a word so that a shell reads it back as it is: quoted if it needs to be, with the escapes
 * of $'...' if a terminal could not show it. */
void po_text_add_word(po_text *text, const char *word);

/* The string so far; "" when nothing was added. */
const char *po_text_string(const po_text *text);

/* Frees and zeroes. */
void po_text_clear(po_text *text);

/* A copy that is UTF-8: each byte that belongs to no character becomes U+FFFD (the replacement
 * character), and an incomplete character at the end, as a cut text has, is left out. Free it.
 * NULL with a message without memory. */
char *po_text_utf8(const char *text);

#endif
