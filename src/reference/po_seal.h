/* Makes a reference table of a user's own table: completes its headers and adds the checksum. */
#ifndef PO_SEAL_H
#define PO_SEAL_H

#include <stddef.h>

#include "po_status.h"

/* The headers that a reference table must have, except the checksum. */
enum { PO_SEAL_HEADERS = 9 };
extern const char *const PO_SEAL_NAMES[PO_SEAL_HEADERS];

/* Writes the table back with complete headers and its checksum. A byte order mark and the line ends
 * of other systems are removed. Given: `values`, for each header of PO_SEAL_NAMES its text, or
 * NULL; a header that the file has is replaced if a text is given. generator, command and date have
 * defaults. Status: PO_BAD_INPUT if headers are missing, all of which the message names;
 * PO_CANNOT_READ (the file, or what makes it no table, with its line); PO_CANNOT_WRITE; the file is
 * then unchanged. */
po_status po_seal(const char *path, const char *const values[PO_SEAL_HEADERS]);

#endif
