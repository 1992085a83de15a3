/* The store of a case: its solved points, in points.jsonl in the folder of the case
 * (po_case_run_place). Each point is a line with its key and its checksum. The key covers all that
 * determines the result, so a result is used wherever it is found: in a later run, in one with
 * other points, in the folder of a shard.
 *
 * A line is appended when its point is solved, as po_lines.h says. A later line of a point replaces
 * an earlier one, so stores can be concatenated. */
#ifndef PO_STORE_H
#define PO_STORE_H

#include "po_case_run.h"

/* Returned: a digest of all that determines the results of a point. It does not depend on the other
 * points of the case, except in a series, where each result depends on its predecessors, and in a
 * case that is timed, in rounds over all points. Status: PO_NO_MEMORY. */
po_status po_store_key(const po_case_run *run, size_t point, char key[PO_DIGEST_LENGTH]);

/* Appends a point. Returned: its checksum in run->points. Status: PO_CANNOT_WRITE, PO_NO_MEMORY. */
po_status po_store_put(po_case_run *run, size_t point, const char *folder);

/* Reads the results of the requested points that are not known, and marks those that are found as
 * done. Returned: a complete line that was altered is counted in run->altered and not used;
 * run->untidy, whether there is a line that is not that of a result which was read. Status:
 * PO_CANNOT_READ (the file exists but cannot be read), PO_NO_MEMORY. */
po_status po_store_read(po_case_run *run, const char *folder);

/* Replaces the file by one with the points of the case, which are all known, and nothing else.
 * Status: PO_CANNOT_WRITE, PO_NO_MEMORY; then the file is unchanged. */
po_status po_store_renew(po_case_run *run, const char *folder);

#endif
