/* A finished run, check by check: what differs, where, who is likely at fault, how to repeat it. */
#ifndef PO_EXPLAIN_H
#define PO_EXPLAIN_H

#include "po_json_value.h"
#include "po_run.h"
#include "po_text.h"

typedef struct {
  const bool *points; /* which points of the case; NULL: all */
  bool all;           /* also the checks that are within */
} po_explain_choice;

/* Whether a point is meant by what a user wrote: its number, or words of its label. */
bool po_explain_means(const po_point *point, const char *text);

/* Whether a result is of the points chosen; one of all points together is when all are. */
bool po_explain_concerns(const po_case_run *run, const po_explain_choice *choice,
                         const po_check_result *item);

/* For people; a paragraph a check, and one for each solve that failed (as po_case_run_failed says).
 */
void po_explain_text(const po_case_run *run, const po_explain_choice *choice, po_text *text);

/* The same as a document of schema "pulloff-explain/1". NULL without memory. */
json_t *po_explain_json(const po_case_run *run, const po_explain_choice *choice);

#endif
