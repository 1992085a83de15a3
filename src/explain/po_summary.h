/* The summary of a case with many scenes: the number of solves with each status, their cost, and
 * for each failure its reason and the command that repeats it. */
#ifndef PO_SUMMARY_H
#define PO_SUMMARY_H

#include "po_run.h"
#include "po_text.h"

/* Adds the summary of the requested points of a finished run. */
void po_summary_add(const po_case_run *run, po_text *text);

#endif
