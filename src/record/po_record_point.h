/* A point of the record, which is also a line of the journal: its result and all that belongs to
 * it, with a checksum, and the tables of its curve and its profile. */
#ifndef PO_RECORD_POINT_H
#define PO_RECORD_POINT_H

#include "po_case_run.h"
#include "po_json_digest.h"

/* Returned: a member that is a text; "" if it is none. */
const char *po_record_text(const json_t *object, const char *key);

/* Returned: the entry of a point without tables and checksum; NULL without memory. */
json_t *po_record_point(const po_case_run *run, size_t index);

/* Computes the digest of the result of a point, as in its entry. Status: PO_NO_MEMORY. */
po_status po_record_digest(const po_case_run *run, size_t index,
                           char digest[PO_RESULT_DIGEST_LENGTH]);

/* Returned: the number of points at which the clock of an external solver disagrees with the times
 * of its processes. */
size_t po_record_disagreements(const po_case_run *run);

/* Returned: a digest of all that determines the results of a point. It does not depend on the other
 * points of the case, except in a series, where each result depends on its predecessors. Status:
 * PO_NO_MEMORY. */
po_status po_record_key(const po_case_run *run, size_t point, char key[PO_DIGEST_LENGTH]);

/* Writes the curve and the profile of a point, if it has them. Returned: *entry, that of
 * po_record_point with the names and checksums of these tables, if `judged` with "failed", and with
 * "checksum": the SHA-256 of the key of the point and of all other members. Status:
 * PO_CANNOT_WRITE, PO_NO_MEMORY; *entry is to be released in any case. */
po_status po_record_entry(const po_case_run *run, size_t index, const char *folder, bool judged,
                          json_t **entry);

/* Reads the result of a point from its entry and its tables, and marks the point as done. The
 * checksum is removed from the entry. Given: intact, that the entry is part of a document with a
 * checksum. Status: PO_NOT_FOUND, with the point counted in run->altered, if the entry or a table
 * is missing or was altered; PO_NO_MEMORY. */
po_status po_record_read_point(po_case_run *run, size_t index, json_t *entry, const char *folder,
                               bool intact);

#endif
