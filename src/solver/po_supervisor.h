/* The supervisor of a process (po_process.h): the code that runs after the fork. */
#ifndef PO_SUPERVISOR_H
#define PO_SUPERVISOR_H

#include "po_process.h"

/* What the supervisor reports when the process has ended and nothing of it is left. */
typedef struct {
  int start_error; /* errno of the step that failed before the program ran; 0: it ran */
  int status;      /* of waitpid */
  size_t left;
  double processor;
} po_supervisor_report;

/* Messages to the supervisor, one byte each; closing the socket means PO_SUPERVISOR_KILL. */
enum { PO_SUPERVISOR_TERM = 'T', PO_SUPERVISOR_KILL = 'K' };

/* Runs the process of a request and supervises it. To be called in a new process of its own; does
 * not return. Calls only functions that are safe after a fork of a program with threads.
 * Given: the socket for messages to the supervisor, and the pipes for its report and for the output
 * of the program. */
_Noreturn void po_supervise(const po_process_request *request, int control, int report, int output);

/* Restricts this process and its descendants to writing in one folder and in /dev. Returned: 0, or
 * an errno; ENOSYS or EOPNOTSUPP if the kernel cannot. */
int po_confine(const char *folder);

/* Gives up the capabilities by which a program of root, executed next, could read the memory and
 * the environment of other processes. Without such capabilities this has no effect. */
void po_blind(void);

#endif
