/* Which questions have been answered, while the answers of an external solver come in. */
#ifndef PO_TAKING_H
#define PO_TAKING_H

#include "po_answer.h"
#include "po_response.h"

/* Takes an answer. It is called for the answers of the solver in the order in which they come, and
 * for the questions that end without one (status PO_TIMED_OUT, PO_CRASHED, PO_NO_ANSWER, or
 * PO_INVALID); such a call replaces what was taken for the same question before. The answer may be
 * moved out of *answer. Given: `final`, whether it is the last one for the question. Status: any; a
 * status other than PO_OK ends the asking. */
typedef po_status po_answer_taker(void *context, size_t question, po_answer *answer, bool final);

typedef struct {
  const po_question *questions;
  size_t count;
  po_answer_taker *take;
  void *context;
  bool *open;        /* one a question: it has not been answered */
  bool *asked;       /* one a question: the present process was asked */
  unsigned *answers; /* one a question: number of answers so far */
  bool *seen;        /* `repeats` a question: this repeat was answered */
  bool *spoiled;     /* one a question: it has got an invalid answer */
  bool ever;         /* the solver has answered something */
  bool unusual; /* the present process has given an invalid answer, or did not end as it should */
  char complaint[sizeof((po_result *)0)->reason]; /* about a line that belongs to no question */
} po_taking;

/* What the present process has answered. */
typedef struct {
  size_t answered; /* points */
  double reported; /* sum of the times that its answers report, in seconds */
} po_taking_count;

/* Opens all questions. Returned: to be cleared whatever the status. Status: PO_NO_MEMORY. */
po_status po_taking_make(const po_question *questions, size_t count, po_answer_taker *take,
                         void *context, po_taking *taking);
void po_taking_clear(po_taking *taking);

/* Begins a process, which is asked all open questions, each from its first repeat on. */
void po_taking_begin(po_taking *taking);

/* Returned: the first open question; `count`: there is none. */
size_t po_taking_first(const po_taking *taking);

/* Takes the lines that have been added to the response. Given: `last`, whether the process has
 * ended. Returned: in *news, whether there are any; *found, increased. Status: PO_NO_MEMORY, that
 * of `take`. What is wrong with the file itself is in response->wrong. */
po_status po_taking_lines(po_taking *taking, po_response *response, bool last,
                          po_taking_count *found, bool *news);

/* Ends a question without an answer of the solver. Status: PO_NO_MEMORY, that of `take`. */
po_status po_taking_give_up(po_taking *taking, size_t question, po_status status,
                            const char *reason);

#endif
