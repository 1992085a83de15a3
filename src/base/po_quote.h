/* Makes text from outside the program (arguments, file contents, file names) safe to print: control
 * characters, which a terminal would execute, and bytes that JSON cannot represent are escaped or
 * replaced. */
#ifndef PO_QUOTE_H
#define PO_QUOTE_H

#include <stddef.h>

/* Finds the first byte of `text`, `length` bytes and a NUL, that belongs to a control character or
 * is not valid UTF-8. Control characters are C0 (except tab and line ends), DEL and C1; the escape
 * sequences of terminals begin with one. Returned: that byte, or NULL. */
const char *po_quote_find(const char *text, size_t length);

/* Returned: the number of bytes of the byte order mark with which some programs begin UTF-8; 0 if
 * `text` does not begin with it. */
size_t po_quote_mark(const char *text);

/* Copies `text` into `shown`, `size` bytes including the NUL. Valid UTF-8 is kept; control
 * characters and invalid bytes are written as \xNN. If `shown` is too short, the copy ends after a
 * complete character. Returned: shown. */
char *po_quote_text(const char *text, char *shown, size_t size);

#define PO_QUOTE_CUT "..."

enum { PO_QUOTE_BYTES = 80, PO_QUOTE_LENGTH = 4 * PO_QUOTE_BYTES + sizeof PO_QUOTE_CUT };

/* As po_quote_text, for a value in a message: its first 80 bytes, and PO_QUOTE_CUT if it is longer;
 * "empty" for an empty string. */
char *po_quote(const char *value, char shown[PO_QUOTE_LENGTH]);

/* Returned: a copy of a text in valid UTF-8, to be freed. Each byte that is not part of a character
 * becomes U+FFFD (the replacement character); an incomplete character at the end of the text is
 * left out. NULL with a message if memory runs out. */
char *po_quote_utf8(const char *text);

#endif
