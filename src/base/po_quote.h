/* Text from outside (arguments, files, names of files) that is printed: control characters, which a
 * terminal would obey, and bytes that JSON cannot hold are made visible. */
#ifndef PO_QUOTE_H
#define PO_QUOTE_H

#include <stddef.h>

/* The first byte of `text`, `length` bytes and a NUL, that is a control character (C0 but tab and
 * line ends, DEL, C1: the escape sequences of terminals begin with one) or not valid UTF-8; NULL if
 * there is no such byte. */
const char *po_quote_find(const char *text, size_t length);

/* Copies `text` into `shown`, `size` bytes with the final NUL: valid UTF-8 is kept, control
 * characters and all other bytes are written as \xNN. Only whole characters are copied when there
 * is too little room. Returned: shown. */
char *po_quote_text(const char *text, char *shown, size_t size);

enum { PO_QUOTE_BYTES = 80, PO_QUOTE_LENGTH = 4 * PO_QUOTE_BYTES + 1 };

/* The same for a value in a message: its first 80 bytes, "empty" when there is none. */
char *po_quote(const char *value, char shown[PO_QUOTE_LENGTH]);

#endif
