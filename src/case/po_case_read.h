/* Reads case files. */
#ifndef PO_CASE_READ_H
#define PO_CASE_READ_H

#include "po_case.h"

/* Reads and checks one case file.
 * Given: `shown`, the name of the file in messages.
 * Status: PO_BAD_INPUT with one line `file:line: path is VALUE: expected ...`; PO_CANNOT_READ. */
po_status po_case_read(const char *path, const char *shown, po_case **result);
void po_case_destroy(po_case *kase);

#endif
