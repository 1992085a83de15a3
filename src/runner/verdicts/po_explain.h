/* Explains the checks of a finished run: the difference, its place on the branch, the side that is
 * probably wrong, and the command that repeats the solve. */
#ifndef PO_EXPLAIN_H
#define PO_EXPLAIN_H

#include "po_json_value.h"
#include "po_run.h"
#include "po_text.h"

typedef struct {
  const bool *points; /* one a point: the point is selected; NULL: all are */
  bool all;           /* include checks whose verdict is within */
  const char *output; /* the folder of the records; NULL: it is the default */
} po_explain_choice;

/* Reports whether a text selects a point: it is the number of the point, or consists of words of
 * its label. */
bool po_explain_means(const po_point *point, const char *text);

/* Reports whether a finding belongs to the selected points. A result of all points together does if
 * all points are selected. */
bool po_explain_concerns(const po_case_run *run, const po_explain_choice *choice,
                         const po_finding *finding);

enum { PO_PLACE_LENGTH = 160 };

/* Returned: in `words`, the place relative to the special points, which have the names that the ids
 * of checks contain: "at jump_in-1", "between jump_out-2 and minimum-1", "before jump_in-1", "after
 * minimum-1". "" if the branch has no special point, or if the place depends on the points of the
 * curve and the result has none. */
void po_place_describe(const po_result *result, double approach, double load,
                       char words[PO_PLACE_LENGTH]);

/* Adds a paragraph for each check, and one for each failed solve (see po_case_run_failed). */
void po_explain_text(const po_case_run *run, const po_explain_choice *choice, po_text *text);

/* Returned: the content of these paragraphs as a document of schema "pulloff-explain/1"; NULL
 * without memory. */
json_t *po_explain_json(const po_case_run *run, const po_explain_choice *choice);

/* Which side is probably wrong if references disagree, and why. */
typedef struct {
  const char *side; /* "none", "program", "solver", "solve", "reference", "publication",
                       "tolerance" */
  char why[400];
} po_blame;

/* Determines the side that is probably wrong from one result and the other results of the same
 * point. Given: a finished run. */
void po_blame_find(const po_case_run *run, const po_check_result *item, po_blame *blame);

#endif
