/* The record of a case: record.json in the folder of the case (po_case_run_place), with the curves
 * and profiles in the same folder. */
#ifndef PO_RECORD_H
#define PO_RECORD_H

#include <signal.h>

#include "po_case_run.h"

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

#endif
