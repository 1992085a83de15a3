/* Accepts the results of a run as the pins of a case (po_pins.h). */
#ifndef PO_BLESS_H
#define PO_BLESS_H

#include "po_run.h"
#include "po_text.h"

/* Status: PO_BAD_INPUT if the reason is blank, too long, or has several lines. */
po_status po_bless_check_reason(const char *reason);

/* Writes the pins of cases. A table in which nothing changes is not written. Given: finished runs
 * of this program; `who`, the name of the user; a reason that was checked.
 * Returned: in `report`, by how much the results of each case differ from the stored ones, and one
 * line a table.
 * Status: PO_NOT_CONVERGED (a solve failed) or PO_CHECK_FAILED (a stored result was altered, a
 * quantity has no result, or a check against an oracle does not pass): the message names the first
 * such result, and nothing is written; PO_CANNOT_WRITE (the old pins remain unchanged). */
po_status po_bless(const po_case_run *runs, size_t count, const char *who, const char *reason,
                   po_text *report);

#endif
