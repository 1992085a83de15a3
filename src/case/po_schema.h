/* What a case file may hold, and what each value must be. */
#ifndef PO_SCHEMA_H
#define PO_SCHEMA_H

#include "po_case.h"
#include "po_yaml.h"

/* Fills the structs of a case from its file. *file is to be freed whatever the status.
 * Status: PO_BAD_INPUT with file, line, path, value and what was expected; PO_NO_MEMORY. */
po_status po_schema_load(const po_yaml *yaml, po_case_file **file);
void po_schema_free(po_case_file *file);

/* po_yaml_refuse for the path written by `format`; what was expected is `expected`, or, when that
 * is NULL, what the schema says of the path, which it must know: "abs, rel or ulp" for
 * "checks[2].kind". */
po_status po_schema_refuse(const po_yaml *yaml, const char *expected, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
