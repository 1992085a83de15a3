/* Text that may not be UTF-8: names of files are bytes, and a text that was cut may end inside a
 * character. */
#ifndef PO_UTF8_H
#define PO_UTF8_H

#include <stdbool.h>
#include <stddef.h>

/* The length in bytes of the character that `text` begins with, 1 to 4; 0 where the bytes are no
 * character of UTF-8 (a stray byte, an overlong form, a surrogate, above U+10FFFF).
 * Source: the table of well-formed byte sequences of the Unicode Standard (Table 3-7). */
size_t po_utf8_character(const char *text);

/* Whether all of a text is UTF-8. */
bool po_utf8_is_valid(const char *text);

/* How many bytes at `text` begin a character of the length, 1 to 4, that its first byte announces
 * (0: none does): fewer than that when it is broken off. */
size_t po_utf8_present(const char *text, size_t *length);

#endif
