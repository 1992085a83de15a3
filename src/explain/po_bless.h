/* Accepts the results of a run as the pins of a case. */
#ifndef PO_BLESS_H
#define PO_BLESS_H

#include "po_run.h"
#include "po_text.h"

/* Checks what can be checked before the run. Status: PO_BAD_INPUT if the case has no check against
 * pins, or if the reason is blank, too long, or has several lines. */
po_status po_bless_check_request(const po_plan *plan, const char *reason);

/* Checks whether the results of a finished run may be pinned. Status: as above; PO_NOT_CONVERGED (a
 * solve failed); PO_CHECK_FAILED (a pinned quantity has no result, or a check against an oracle
 * does not pass). The message names the first such result. */
po_status po_bless_check(const po_case_run *run, const char *reason);

/* Writes the pins of a case. Pins that no check needs are removed; the headers of earlier blessings
 * remain. If no pin changes, nothing is written.
 * Given: `who`, the name of the user.
 * Returned: in `report`, one line for each changed pin, with the change.
 * Status: as po_bless_check; PO_CANNOT_WRITE (the old pins remain unchanged). */
po_status po_bless(const po_case_run *run, const char *who, const char *reason, po_text *report);

#endif
