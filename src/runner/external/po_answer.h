/* Answers of an external solver: the lines of the response file of doc/solvers.md. */
#ifndef PO_ANSWER_H
#define PO_ANSWER_H

#include "po_question.h"
#include "po_result.h"

typedef struct {
  char id[PO_QUESTION_ID]; /* "" if the line does not show it */
  unsigned repeat;         /* from 1 */
  po_result result;    /* its status: PO_OK, PO_UNSUPPORTED, PO_FAILED; PO_INVALID: see `reason` */
  double setup, solve; /* seconds, as the solver reports them; NAN: not reported */
} po_answer;

/* Reads one line. A line that is not an answer, or whose numbers are not those of the protocol,
 * gives the status PO_INVALID with the reason in the result. The result must be passed to
 * po_result_clear. Status: PO_NO_MEMORY. */
po_status po_answer_read(const char *line, size_t length, po_answer *answer);

/* Checks whether a successful answer contains what the question wants; otherwise its status becomes
 * PO_INVALID. */
void po_answer_check(const po_question *question, po_answer *answer);

#endif
