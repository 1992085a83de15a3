/* Accepts what a run gave as the pins of a case. */
#ifndef PO_BLESS_H
#define PO_BLESS_H

#include "po_run.h"
#include "po_text.h"

/* What can be refused before anything is solved: PO_BAD_INPUT when the case pins nothing, or the
 * reason is blank, or of several lines. */
po_status po_bless_check_request(const po_plan *plan, const char *reason);

/* Whether the numbers of a finished run may be pinned. Status: as above;
 * PO_NOT_CONVERGED: a solve failed; PO_CHECK_FAILED: a pinned quantity has no result, or a check
 * against an oracle does not pass. The message names the first. */
po_status po_bless_check(const po_case_run *run, const char *reason);

/* Writes the pins of a case, those it has no more use for left out, and the earlier blessings
 * kept; says line by line in `report` what moved by how much. When nothing did, nothing is written.
 * Given: `who` does it. Status: that of po_bless_check; PO_CANNOT_WRITE, the old pins as they were.
 */
po_status po_bless(const po_case_run *run, const char *who, const char *reason, po_text *report);

#endif
