/* Questions to an external solver: the request file of doc/solvers.md. */
#ifndef PO_QUESTION_H
#define PO_QUESTION_H

#include "po_solver.h"
#include "po_text.h"

enum { PO_QUESTION_ID = 24 };

typedef struct {
  char id[PO_QUESTION_ID];
  po_request request;
  unsigned want;    /* bit set of 1 << po_quantity: those that the answer must contain */
  unsigned repeats; /* number of answers, each for a solve from the beginning; less than 32 */
  double limit;     /* seconds for each of them */
} po_question;

/* Appends the request for some questions as JSON, and the same as a CSV table, for languages
 * without JSON: one row a question, with the columns id, limit_s, repeats, load_unit,
 * preload_approach, preload_load, approach_start, approach_end, the knob, and each key of the scene
 * that one of the questions has ("-" for the others). Given: `open`, one flag a question: it is
 * asked. All questions have the same number of repeats. Status: PO_NO_MEMORY. */
po_status po_questions_print(const po_solver *solver, const po_question *questions,
                             const bool *open, size_t count, po_text *json, po_text *table);

#endif
