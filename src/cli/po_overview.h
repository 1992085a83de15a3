/* The verdicts of a run on one screen: a line a case, what does not pass with the command that
 * explains it, the totals. */
#ifndef PO_OVERVIEW_H
#define PO_OVERVIEW_H

#include "po_run.h"
#include "po_text.h"

/* Adds the overview of finished runs. `output` is the folder of the records, NULL if it is the one
 * that the verbs take by default. */
void po_overview_add(const po_case_run *runs, size_t count, const char *output, po_text *text);

#endif
