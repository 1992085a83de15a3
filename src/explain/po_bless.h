/* Accepts the results of a run as the pins and the stored digests of a case. */
#ifndef PO_BLESS_H
#define PO_BLESS_H

#include "po_run.h"
#include "po_text.h"

/* Checks what can be checked before the run. Status: PO_BAD_INPUT if the reason is blank, too long,
 * or has several lines, or if nothing is asked of an external solver that can be pinned. */
po_status po_bless_check_request(const po_plan *plan, const char *reason);

/* Checks whether the results of a finished run may be pinned. Status: as above; PO_NOT_CONVERGED (a
 * solve failed); PO_CHECK_FAILED (a pinned quantity has no result, or a check against an oracle
 * does not pass). The message names the first such result. */
po_status po_bless_check(const po_case_run *run, const char *reason);

/* Writes the pins of a case, if it has checks against pins, and the digests of its results, if they
 * are of this program. Pins that no check needs are removed; the headers of earlier blessings
 * remain. A table in which nothing changes is not written. Given: `who`, the name of the user.
 * Returned: in `report`, one line for each changed pin, with the change, and one a table.
 * Status: as po_bless_check; PO_CANNOT_WRITE (the old pins remain unchanged). */
po_status po_bless(const po_case_run *run, const char *who, const char *reason, po_text *report);

#endif
