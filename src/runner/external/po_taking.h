/* Which questions have been answered, while the answers of an external solver come in. */
#ifndef PO_TAKING_H
#define PO_TAKING_H

#include <stdbool.h>
#include <stddef.h>

#include "po_answer.h"
#include "po_text.h"

/* Takes an answer. It is called for the answers of the solver in the order in which they come, and
 * for the questions that end without one (status PO_TIMED_OUT, PO_CRASHED, PO_NO_ANSWER, or
 * PO_INVALID); such a call replaces what was taken for the same question before. The answer may be
 * moved out of *answer. Given: `final`, whether it is the last one for the question. Status: any; a
 * status other than PO_OK ends the asking. */
typedef po_status po_answer_taker(void *context, size_t question, po_answer *answer, bool final);

/* A response file that is being written. */
typedef struct {
  const char *path;
  int file;        /* -1: the file does not exist yet */
  size_t read;     /* bytes read so far */
  size_t taken;    /* bytes of `pending` that are lines which were taken */
  po_text pending; /* bytes after the last complete line */
  char wrong[120]; /* what is wrong with the file; "": nothing */
} po_response;

/* What the present process has answered. */
typedef struct {
  size_t lines;    /* that are not blank */
  size_t answered; /* points */
  double reported; /* sum of the times that its answers report, in seconds */
} po_taking_count;

typedef struct {
  const po_question *questions;
  size_t count;
  po_answer_taker *take;
  void *context;
  bool *open;     /* one a question: it has not been answered */
  bool *asked;    /* one a question: the present process was asked */
  unsigned *seen; /* one a question: bit set of the repeats that were answered */
  bool *spoiled;  /* one a question: it has got an invalid answer */
  bool ever;      /* the solver has answered something */
  bool unusual;   /* the present process has given an invalid answer, or did not end as it should */
  char complaint[sizeof((po_result *)0)->reason]; /* about a line that belongs to no question */
  po_response response;                           /* of the present process */
  po_taking_count found;
} po_taking;

/* Opens all questions. Returned: to be cleared whatever the status. Status: PO_NO_MEMORY. */
po_status po_taking_make(const po_question *questions, size_t count, po_answer_taker *take,
                         void *context, po_taking *taking);

void po_taking_clear(po_taking *taking);

/* Begins a process, which is asked all open questions, each from its first repeat on. Given: the
 * path of its response, which must live until the last po_taking_lines. */
void po_taking_begin(po_taking *taking, const char *response);

/* Returned: the first open question; `count`: there is none. */
size_t po_taking_first(const po_taking *taking);

/* Takes the lines that have been added to the response, which must be a regular file: a link is not
 * followed. Given: `last`, whether the process has ended; then the rest of the file counts as a
 * line although it has no newline. Status: PO_NO_MEMORY, that of `take`. What is wrong with the
 * file itself is in taking->response.wrong. */
po_status po_taking_lines(po_taking *taking, bool last);

/* Ends a question without an answer of the solver. Status: PO_NO_MEMORY, that of `take`. */
po_status po_taking_give_up(po_taking *taking, size_t question, po_status status,
                            const char *reason);

#endif
