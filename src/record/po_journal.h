/* The journal of a case: the solved points of a run that is not finished, in
 * points.jsonl in the folder of the case. Each solved point is appended as one line: its entry in
 * the record (po_record_point.h) and its key. An interrupted run is resumed from the journal.
 * Journals of runs of different points, on one machine or on several, can be concatenated. The
 * journal is deleted when the record is written. */
#ifndef PO_JOURNAL_H
#define PO_JOURNAL_H

#include "po_case_run.h"

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
