/* The verdicts of a run: a table for the user, TAP for meson, JUnit XML for CI services. */
#ifndef PO_VERDICTS_H
#define PO_VERDICTS_H

#include "po_identity.h"
#include "po_run.h"
#include "po_text.h"

/* Adds one line for each check: case, quantity, point, obtained, expected, error relative to the
 * tolerance, verdict; then a line for each failed solve, and the totals. */
void po_verdicts_table(const po_case_run *runs, size_t count, po_text *text);

/* Adds the totals: "69 checks pass (2 slack), 1 does not (1 outside), 0 solves failed". */
void po_verdicts_totals(const po_case_run *runs, size_t count, po_text *text);

/* Adds TAP 13: a line for each check, for each failed solve (`not ok`), and for the comparison of a
 * case with its pins, if there are any. A check whose verdict is slack is `ok`, with a diagnostic
 * line. */
void po_verdicts_tap(const po_case_run *runs, const po_identity *identities, size_t count,
                     po_text *text);

/* Adds JUnit XML: a suite for each case, with the same tests. */
void po_verdicts_junit(const po_case_run *runs, const po_identity *identities, size_t count,
                       po_text *text);

/* Adds the summary of the requested points of a finished run, for a case with many scenes: the
 * number of solves with each status, their cost, and for each failure its reason and the command
 * that repeats it. */
void po_summary_add(const po_case_run *run, po_text *text);

#endif
