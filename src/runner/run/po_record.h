/* The record of a case: record.json in the folder of the case (po_case_run_place), with the curves
 * and profiles in the same folder, for the report and for readers. It is made of the results, which
 * are kept in the store (po_store.h), and never read back. */
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

/* Compares the record and the tables in the folder with the results of the requested points, which
 * are all in the store. Returned: run->current, whether they are those of these results, checks and
 * references, so that they need not be written; run->damaged, whether one of them was altered since
 * it was written. Status: PO_NO_MEMORY. */
po_status po_record_check(po_case_run *run, const char *folder);

/* Checks, for a case file outside the folder of cases, that its record would not replace the record
 * of another existing file. Status: PO_BAD_INPUT (the message names both files), PO_NO_MEMORY. */
po_status po_record_check_owner(const po_case_run *run);

/* Returned: a member that is a text; "" if it is none. */
const char *po_record_text(const json_t *object, const char *key);

/* Returned: the result of a point with its times, and its trace; the entry of the point in the
 * record, without tables; NULL without memory. */
json_t *po_record_result(const po_case_run *run, size_t index);
json_t *po_record_point(const po_case_run *run, size_t index);

/* The inverse of po_record_result. Status: PO_BAD_INPUT, PO_NO_MEMORY; the result of the point is
 * then incomplete, and is to be cleared. */
po_status po_record_read_result(po_case_run *run, size_t index, const json_t *object);

/* Writes the curve, the profile and the loop of a point, if it has them. Returned: *entry, that of
 * po_record_point with the names and checksums of these tables. Status: PO_CANNOT_WRITE,
 * PO_NO_MEMORY; *entry is to be released in any case. */
po_status po_record_entry(const po_case_run *run, size_t index, const char *folder, json_t **entry);

/* Computes the digest of the result of a point, as in its entry. Status: PO_NO_MEMORY. */
po_status po_record_digest(const po_case_run *run, size_t index,
                           char digest[PO_RESULT_DIGEST_LENGTH]);

#endif
