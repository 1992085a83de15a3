/* Determines which side is probably wrong if references disagree, and why. */
#ifndef PO_BLAME_H
#define PO_BLAME_H

#include "po_run.h"

typedef struct {
  const char *side; /* "none", "program", "solver", "solve", "reference", "publication", "pin",
                       "tolerance" */
  char why[400];
} po_blame;

/* Determines the side that is probably wrong from one result and the other results of the same
 * point. Given: a finished run. */
void po_blame_find(const po_case_run *run, const po_check_result *item, po_blame *blame);

#endif
