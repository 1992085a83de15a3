/* The record of a case: <output>/<case>/record.json, beside it the curves and profiles. */
#ifndef PO_RECORD_H
#define PO_RECORD_H

#include "po_json_value.h"
#include "po_run.h"

/* Writes the tables, then the record.
 * Status: PO_CANNOT_WRITE, PO_NO_MEMORY; PO_INTERRUPTED when *stop became nonzero while closed
 * forms were computed: then there is no record, or still the earlier one. */
po_status po_record_write(const po_case_run *run, const char *output, int jobs,
                          const volatile sig_atomic_t *stop);

/* Reads the results of an earlier run of the same solves back. Status: PO_NOT_FOUND when there is
 * none, or it is of other scenes, another program, or damaged: then it has to be solved again;
 * PO_NO_MEMORY. */
po_status po_record_read(po_case_run *run, const char *output);

/* Whether the folder of a case of the user's own is free for it: a record of another file that is
 * still there would be lost. Status: PO_BAD_INPUT, naming both files; PO_NO_MEMORY. */
po_status po_record_check_owner(const po_case_run *run, const char *output);

/* The entry of one point in the record; NULL without memory. */
json_t *po_record_point(const po_case_run *run, size_t index);

/* Writes the curve and the profile of a point, if there are, and names them in its entry. */
po_status po_record_add_tables(const po_case_run *run, size_t index, const char *folder,
                               json_t **entry);

/* The inverse of both: the result of a point from its entry and its tables.
 * Status: PO_NOT_FOUND when the entry is of another point, or something is lost or damaged;
 * PO_NO_MEMORY. */
po_status po_record_read_point(po_case_run *run, size_t index, const json_t *entry,
                               const char *folder);

#endif
