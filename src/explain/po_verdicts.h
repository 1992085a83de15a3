/* The verdicts of a run, for people, for meson and for CI services. */
#ifndef PO_VERDICTS_H
#define PO_VERDICTS_H

#include "po_run.h"
#include "po_text.h"

/* One line a check: case, quantity, point, obtained, expected, error in units of the tolerance,
 * verdict; then a line for each solve that failed and the totals, by verdict. */
void po_verdicts_table(const po_case_run *runs, size_t count, po_text *text);

/* The totals alone: "69 checks pass (1 improved, 2 slack), 1 do not (1 outside), 0 solves failed".
 */
void po_verdicts_totals(const po_case_run *runs, size_t count, po_text *text);

/* TAP 13: a line for each check, and each solve that failed (`not ok`). A check that passes with
 * something to say (improved, slack) is `ok` and says it in a diagnostic line. */
void po_verdicts_tap(const po_case_run *runs, size_t count, po_text *text);

/* JUnit XML: a suite for each case, a test for each check and each solve that failed. */
void po_verdicts_junit(const po_case_run *runs, size_t count, po_text *text);

#endif
