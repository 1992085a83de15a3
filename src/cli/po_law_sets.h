/* The laws of contact of a table of parameter sets: one file a row, and a summary. */
#ifndef PO_LAW_SETS_H
#define PO_LAW_SETS_H

#include "po_law_line.h"

/* Makes the law of each row of the table line->sets, in parallel, and writes it to the folder
 * line->output, with summary.csv; a row that has no law is a row of the summary with its reason.
 * Given: a line that is not completed. Status: PO_BAD_INPUT: the table, or its columns beside the
 * options of the line, or no row has a law; PO_CANNOT_READ, PO_CANNOT_WRITE, PO_NO_MEMORY;
 * PO_INTERRUPTED, with the rows so far in the summary. */
po_status po_law_sets(const po_law_line *line);

#endif
