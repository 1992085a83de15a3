/* The status codes of every function that can fail, and the message that accompanies a failure. */
#ifndef PO_STATUS_H
#define PO_STATUS_H

#include <stdbool.h>

/* Zero: success. Positive: an ordinary numerical result on which the caller acts; the data are
 * unchanged. Negative: misuse, bad input or an exhausted resource, which the message states. */
#define PO_STATUS_LIST(X)                                                                          \
  X(PO_OK, 0, "ok")                                                                                \
  X(PO_NOT_CONVERGED, 1, "not converged")                                                          \
  X(PO_STEP_TOO_SMALL, 2, "the branch could not be followed with the shortest step")               \
  X(PO_TOO_MANY_POINTS, 3, "the branch has more points than allowed")                              \
  X(PO_SINGULAR, 4, "the matrix is singular to working precision")                                 \
  X(PO_NOT_FOUND, 5, "not found")                                                                  \
  X(PO_INTERRUPTED, 6, "interrupted")                                                              \
  X(PO_OUT_OF_DOMAIN, 7, "the contact reached the end of the meshed surface")                      \
  X(PO_OUT_OF_NODES, 8, "the traction needs more nodes than allowed")                              \
  X(PO_OUT_OF_TIME, 9, "the solve took more processor time than allowed")                          \
  X(PO_UNSUPPORTED, 10, "the solver does not support the scene")                                   \
  X(PO_FAILED, 11, "the solver reports a failure")                                                 \
  X(PO_TIMED_OUT, 12, "the solver did not answer within the time limit")                           \
  X(PO_CRASHED, 13, "the solver crashed")                                                          \
  X(PO_NO_ANSWER, 14, "the solver ended without an answer")                                        \
  X(PO_INVALID, 15, "the solver gave an invalid answer")                                           \
  X(PO_BAD_INPUT, -1, "bad input")                                                                 \
  X(PO_NO_MEMORY, -2, "out of memory")                                                             \
  X(PO_CANNOT_READ, -3, "a file could not be read")                                                \
  X(PO_CANNOT_WRITE, -4, "a file could not be written")                                            \
  X(PO_MISSING_TOOL, -5, "a required program is not installed")                                    \
  X(PO_CHECK_FAILED, -6, "a check does not pass")

#define PO_STATUS_ENUM(name, value, text) name = value,
typedef enum { PO_STATUS_LIST(PO_STATUS_ENUM) } po_status;
#undef PO_STATUS_ENUM

/* Returned: the text of a status, e.g. "not converged"; never NULL. */
const char *po_status_text(po_status status);

/* Returned: the name of a status as records contain it, e.g. "not_converged"; never NULL. */
const char *po_status_name(po_status status);

/* Finds the status with a name. Returned: false if no status has it, or for NULL. */
bool po_status_find(const char *name, po_status *status);

/* Sets the message of this thread (printf style). It is called where the failure is detected, and
 * the message contains the offending values. Control characters in the values and bytes that are
 * not UTF-8 are written as \xNN. Returned: `status`, so that a caller can write `return
 * po_fail(PO_BAD_INPUT, "...", x);`. */
po_status po_fail(po_status status, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Returned: the last message of po_fail in this thread, one line; "" if there is none. */
const char *po_message(void);

/* Deletes the message of this thread. */
void po_message_clear(void);

/* A function may report a failed allocation as another failure, e.g. as a step that did not
 * converge. Therefore po_fail records the first PO_NO_MEMORY, and the function that returns the
 * final status of a task calls po_no_memory_or. It returns PO_NO_MEMORY, and restores that first
 * message, if an allocation failed in this thread since the last po_no_memory_forget; otherwise it
 * returns `status`. */
po_status po_no_memory_or(po_status status);
void po_no_memory_forget(void);

#endif
