/* Asks an external solver: starts it with the open questions, reads its answers as it writes them,
 * and starts it again for the rest when it crashes or exceeds a time limit. */
#ifndef PO_ASK_H
#define PO_ASK_H

#include <signal.h>

#include "po_taking.h"

/* One process of the solver. */
typedef struct {
  size_t asked; /* points */
  po_taking_count found;
  double wall, processor; /* seconds */
  double first;           /* seconds from its start to its first answer; NAN: none */
  bool left;              /* it left processes of its group behind, which were killed */
} po_ask_process;

typedef struct {
  po_ask_process *processes;
  size_t count;
  po_file_path folder; /* request and response of the last process that gave an invalid answer or
                     failed; "": there was none */
} po_ask_log;

/* Asks all questions. Given: `folder`, in which the solver gets folders of its own; `key`, a digest
 * that identifies the questions for po_recover, or NULL; `stop`, ends the process when it
 * becomes nonzero; may be NULL. Returned: log, to be cleared whatever the status. Status:
 * PO_INTERRUPTED, PO_CANNOT_WRITE, PO_CANNOT_READ (the program cannot be started), PO_NO_MEMORY,
 * that of `take`. If `take` returns PO_INTERRUPTED, it needs no further answer: the process is
 * killed at once, and is in the log. */
po_status po_ask(const po_solver *solver, const po_question *questions, size_t count,
                 const char *folder, const char *key, const volatile sig_atomic_t *stop,
                 po_answer_taker *take, void *context, po_ask_log *log);

void po_ask_log_clear(po_ask_log *log);

#endif
