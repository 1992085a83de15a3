/* Which side is likely at fault when ledgers disagree, and why that one. */
#ifndef PO_BLAME_H
#define PO_BLAME_H

#include "po_run.h"

typedef struct {
  const char *side; /* "none", "program", "solve", "reference", "publication", "pin", "tolerance" */
  char why[400];
} po_blame;

/* What the other results of the same point say of one result. Given: a finished run. */
void po_blame_find(const po_case_run *run, const po_check_result *item, po_blame *blame);

#endif
