/* Accepts the results of a run as the pins and the stored digests of a case. */
#ifndef PO_BLESS_H
#define PO_BLESS_H

#include "po_run.h"
#include "po_text.h"

/* Checks what can be checked before the run. Status: PO_BAD_INPUT if the reason is blank, too long,
 * or has several lines, or if nothing is asked of an external solver that can be pinned. */
po_status po_bless_check_request(const po_plan *plan, const char *reason);

/* Writes the pins of cases, if they have checks against pins, and the digests of their results, if
 * these are of this program. Pins that no check needs are removed; the headers of earlier blessings
 * remain. A table in which nothing changes is not written. Given: finished runs; `who`, the name of
 * the user; a reason that was checked.
 * Returned: in `report`, one line for each changed pin, with the change, and one a table.
 * Status: PO_NOT_CONVERGED (a solve failed) or PO_CHECK_FAILED (a pinned quantity has no result, or
 * a check against an oracle does not pass): the message names the first such result, and nothing is
 * written; PO_CANNOT_WRITE (the old pins remain unchanged). */
po_status po_bless(const po_case_run *runs, size_t count, const char *who, const char *reason,
                   po_text *report);

#endif
