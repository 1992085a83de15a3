/* Text in the encodings of other programs. */
#ifndef PO_ENCODING_H
#define PO_ENCODING_H

#include "po_status.h"
#include "po_text.h"

/* Returned: the bytes of the no-break or thin space (U+00A0, U+2007, U+2009, U+202F) with which a
 * text in UTF-8 begins, as word processors write between digits; 0 if it begins with none. */
size_t po_encoding_blank(const char *text);

/* Makes UTF-8 of UTF-16 with a byte order mark and of Latin-1 (bytes A0 to FF that are not UTF-8,
 * and none from 80 to 9F), line feeds of carriage returns that are not beside one, and adds a line
 * feed at the end. Other text stays as it is. Given: `name` of the file in messages. Status:
 * PO_CANNOT_READ (UTF-32, an odd number of bytes of UTF-16, a NUL byte, the first bytes of a
 * compressed file, a workbook, an array or an image), PO_NO_MEMORY. */
po_status po_encoding_decode(const char *name, po_text *text);

#endif
