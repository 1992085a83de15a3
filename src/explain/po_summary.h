/* A case of many scenes in a few lines: how many ended how, what they cost, and for each failure
 * its reason and the line that repeats it. */
#ifndef PO_SUMMARY_H
#define PO_SUMMARY_H

#include "po_run.h"
#include "po_text.h"

/* Adds the summary of the points asked for in a finished run. */
void po_summary_add(const po_case_run *run, po_text *text);

#endif
