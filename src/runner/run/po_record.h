/* The record of a case: record.json in the folder of the case (po_case_run_place), with the curves
 * and profiles in the same folder; its points; and the journal of a run that is not finished. */
#ifndef PO_RECORD_H
#define PO_RECORD_H

#include <signal.h>

#include "po_case_run.h"
#include "po_json_digest.h"

/* Writes the tables, then the record. That of an external solver whose run is limited to some
 * points is named part.json, and the other points get the status PO_UNSUPPORTED: the report reads
 * it if there is no record of all points, but no later run does. Status: PO_CANNOT_WRITE,
 * PO_NO_MEMORY; PO_INTERRUPTED if *stop became nonzero while closed forms were evaluated: the
 * record is not written, and an earlier one remains. */
po_status po_record_write(po_case_run *run, const char *folder, int jobs,
                          const volatile sig_atomic_t *stop);

/* Reads the results of the requested points from the record of an earlier run, and marks them as
 * done. A result that was altered since is counted in run->altered and not used. run->damaged:
 * something else in the record was altered, or a table of closed forms. Status: PO_NOT_FOUND if not
 * all points are done then, because there is no record, or it was altered, or it belongs to other
 * scenes or another program; PO_NO_MEMORY. */
po_status po_record_read(po_case_run *run, const char *folder);

/* Checks, for a case file outside the folder of cases, that its record would not replace the record
 * of another existing file. Status: PO_BAD_INPUT (the message names both files), PO_NO_MEMORY. */
po_status po_record_check_owner(const po_case_run *run);

/* A point of the record, which is also a line of the journal: its result and all that belongs to
 * it, with a checksum, and the tables of its curve and its profile. */

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

/* The journal of a case: the solved points of a run that is not finished, in
 * points.jsonl in the folder of the case. Each solved point is appended as one line: its entry in
 * the record and its key. An interrupted run is resumed from the journal.
 * Journals of runs of different points, on one machine or on several, can be concatenated. The
 * journal is deleted when the record is written. */

/* Reads the requested points from the journal and marks them as done. Lines of other scenes or of
 * another program, and damaged lines, are ignored. If a point occurs twice, the later line is used.
 * Status: PO_NO_MEMORY, PO_CANNOT_READ (the journal exists but cannot be read). */
po_status po_journal_read(po_case_run *run, const char *folder);

/* Appends a point that was just solved, and writes its curve and profile.
 * Status: PO_CANNOT_WRITE, PO_NO_MEMORY. */
po_status po_journal_add(const po_case_run *run, size_t point, const char *folder);

/* Deletes the journal if it exists. Status: PO_CANNOT_WRITE, PO_NO_MEMORY. */
po_status po_journal_remove(const char *folder);

#endif
