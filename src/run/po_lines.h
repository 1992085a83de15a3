/* The lines of a case: closed forms along a sweep, as tables beside its record. */
#ifndef PO_LINES_H
#define PO_LINES_H

#include <signal.h>

#include "po_case.h"
#include "po_json_value.h"

/* Writes line-NAME.csv for each line into the folder, one row a combination of its sweep: the swept
 * keys, then what the form gives along its variable if that is swept, else the rest; nan where it
 * gives nothing. `stop`: nonzero: end soon; NULL: never. Returned: [{name, theory, table,
 * table_sha256}]. Status: PO_NO_MEMORY, PO_CANNOT_WRITE; PO_INTERRUPTED, the line that was being
 * made is not written. */
po_status po_lines_write(const po_case *kase, const char *folder, const volatile sig_atomic_t *stop,
                         json_t **lines);

#endif
