/* The points of a case that is not finished: <output>/<case>/points.jsonl, one JSON document a
 * line, added as each point is solved. So an interrupted run goes on where it was, and the journals
 * of runs of different points, on one machine or on several, can be put together by appending one
 * to the other. With the record of the case it has done its work and goes. */
#ifndef PO_JOURNAL_H
#define PO_JOURNAL_H

#include "po_run.h"

/* Takes over what is in the journal of a case, of these solves by this program; marks those of
 * them that are asked for as done. Of a point that is there twice the later holds; lines that are
 * of other solves, or damaged, are passed over. Status: PO_NO_MEMORY; PO_CANNOT_READ when there is
 * a journal that cannot be read. */
po_status po_journal_read(po_case_run *run, const char *output);

/* Adds a point that was just solved, and writes its curve and profile.
 * Status: PO_CANNOT_WRITE, PO_NO_MEMORY. */
po_status po_journal_add(const po_case_run *run, size_t point, const char *output);

/* Deletes the journal, if there is one. Status: PO_CANNOT_WRITE, PO_NO_MEMORY. */
po_status po_journal_remove(const po_case_run *run, const char *output);

#endif
