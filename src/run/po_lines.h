/* The lines of a case: closed forms evaluated along a sweep, as tables in the folder of its record.
 */
#ifndef PO_LINES_H
#define PO_LINES_H

#include <signal.h>

#include "po_case.h"
#include "po_json_value.h"

/* Writes a table line-NAME.csv for each line, with one row for each combination of its sweep. The
 * columns are the keys of the sweep, then the values of the form: those along its variable if the
 * sweep contains the variable, else its fixed values. Values that do not exist are nan.
 * Given: `stop`, which ends the computation when it becomes nonzero; may be NULL.
 * Returned: in *lines, [{name, theory, table, table_sha256}].
 * Status: PO_NO_MEMORY, PO_CANNOT_WRITE, PO_INTERRUPTED (the table of the interrupted line is not
 * written). */
po_status po_lines_write(const po_case *kase, const char *folder, const volatile sig_atomic_t *stop,
                         json_t **lines);

#endif
