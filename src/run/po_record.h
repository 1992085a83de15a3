/* The record of a case: <output>/<case>/record.json, with the curves and profiles in the same
 * folder. */
#ifndef PO_RECORD_H
#define PO_RECORD_H

#include "po_json_digest.h"
#include "po_run.h"

/* Writes the tables, then the record.
 * Status: PO_CANNOT_WRITE, PO_NO_MEMORY; PO_INTERRUPTED if *stop became nonzero while closed forms
 * were evaluated: the record is not written, and an earlier one remains. */
po_status po_record_write(const po_case_run *run, const char *output, int jobs,
                          const volatile sig_atomic_t *stop);

/* Writes the record of a run of an external solver that is limited to some points, as part.json:
 * the report reads it if there is no record of all points, but no later run does. The other points
 * get the status PO_UNSUPPORTED. Status: as po_record_write. */
po_status po_record_write_part(po_case_run *run, const char *output, int jobs,
                               const volatile sig_atomic_t *stop);

/* Reads the results of the requested points from the record of an earlier run, and marks them as
 * done. A result that was altered since is counted in run->altered and not used. run->damaged:
 * something else in the record was altered, or a table of closed forms. Status: PO_NOT_FOUND if not
 * all points are done then, because there is no record, or it was altered, or it belongs to other
 * scenes or another program; PO_NO_MEMORY. */
po_status po_record_read(po_case_run *run, const char *output);

/* Checks, for a case file outside the folder of cases, that its record would not replace the record
 * of another existing file. Status: PO_BAD_INPUT (the message names both files), PO_NO_MEMORY. */
po_status po_record_check_owner(const po_case_run *run, const char *output);

/* Returned: the entry of a point in the record; NULL without memory. */
json_t *po_record_point(const po_case_run *run, size_t index);

/* Computes the digest of the result of a point, as in its entry. Status: PO_NO_MEMORY. */
po_status po_record_digest(const po_case_run *run, size_t index,
                           char digest[PO_RESULT_DIGEST_LENGTH]);

/* Writes the curve and the profile of a point, if it has them, and adds their names and checksums
 * to its entry. Status: PO_CANNOT_WRITE, PO_NO_MEMORY. */
po_status po_record_add_tables(const po_case_run *run, size_t index, const char *folder,
                               json_t **entry);

/* Returned: a digest of all that determines the results of a point. It does not depend on the other
 * points of the case, except in a series, where each result depends on its predecessors. Status:
 * PO_NO_MEMORY. */
po_status po_record_key(const po_case_run *run, size_t point, char key[PO_DIGEST_LENGTH]);

/* Adds "checksum" to a complete entry: the SHA-256 of the key of its point and of all its members.
 * Status: PO_NO_MEMORY. */
po_status po_record_add_checksum(const po_case_run *run, size_t point, json_t **entry);

/* Checks that an entry is as it was written, for this point, and removes its checksum. Status:
 * PO_NOT_FOUND if it is not; PO_NO_MEMORY. */
po_status po_record_check(const po_case_run *run, size_t point, json_t *entry);

/* Reads the result of a point from its entry and its tables: the inverse of po_record_point,
 * po_record_add_tables and po_record_add_checksum, and marks the point as done. Given: intact, that
 * the entry is part of a document with a checksum. Status: PO_NOT_FOUND, with the point counted in
 * run->altered, if the entry or a table is missing or was altered; PO_NO_MEMORY. */
po_status po_record_read_point(po_case_run *run, size_t index, json_t *entry, const char *folder,
                               bool intact);

#endif
