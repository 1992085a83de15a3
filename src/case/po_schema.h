/* The schema of case files: the keys and their permitted values. */
#ifndef PO_SCHEMA_H
#define PO_SCHEMA_H

#include "po_case.h"
#include "po_yaml.h"

/* Fills the structs of a case from its file. Whatever the status, po_schema_free must free *file.
 * Status: PO_BAD_INPUT; the message states file, line, path, value and what was expected.
 * PO_NO_MEMORY. */
po_status po_schema_load(const po_yaml *yaml, po_case_file **file);
void po_schema_free(po_case_file *file);

/* Calls po_yaml_refuse for the path that `format` and its arguments give.
 * Given: `expected`, the permitted values; NULL: those of the schema, e.g. "abs, rel or ulp" for
 * "checks[2].kind". In this case the path must be in the schema. */
po_status po_schema_refuse(const po_yaml *yaml, const char *expected, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
