/* Validation of UTF-8: file names are arbitrary bytes, and a truncated text may end inside a
 * character. */
#ifndef PO_UTF8_H
#define PO_UTF8_H

#include <stdbool.h>
#include <stddef.h>

/* Returned: the length in bytes, 1 to 4, of the UTF-8 character at `text`; 0 if the bytes are not a
 * character (a stray byte, an overlong form, a surrogate, above U+10FFFF). Source: the table of
 * well-formed byte sequences of the Unicode Standard (Table 3-7). */
size_t po_utf8_character(const char *text);

/* Returned: whether the complete text is valid UTF-8. */
bool po_utf8_is_valid(const char *text);

/* Returned: the number of bytes at `text` that belong to its first character, and in *length the
 * number, 1 to 4, that the first byte announces (0: it cannot begin a character). The returned
 * number is smaller than *length if the character is incomplete. */
size_t po_utf8_present(const char *text, size_t *length);

#endif
