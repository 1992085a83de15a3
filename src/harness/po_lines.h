/* The lines of a case: closed forms along a sweep, as tables beside its record. */
#ifndef PO_LINES_H
#define PO_LINES_H

#include "po_case.h"
#include "po_json_value.h"
#include "po_yaml.h"

/* Checks the section `lines`: names, forms, the keys of their sweeps, and that each form has what
 * it needs. Status: PO_BAD_INPUT. */
po_status po_lines_parse(po_case *kase, const po_yaml *yaml);

/* Writes line-NAME.csv for each line into the folder, one row a combination of its sweep: the swept
 * keys, then what the form gives along its variable if that is swept, else the rest; nan where it
 * gives nothing. Returned: [{name, theory, table, table_sha256}]. Status: PO_NO_MEMORY,
 * PO_CANNOT_WRITE. */
po_status po_lines_write(const po_case *kase, const char *folder, json_t **lines);

#endif
