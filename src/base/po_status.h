/* Results of every function that can fail, and the message that goes with a failure. */
#ifndef PO_STATUS_H
#define PO_STATUS_H

#include <stdbool.h>

/* Zero is success. Positive: an ordinary numerical result the caller acts on, its data unchanged.
 * Negative: misuse, bad input or an exhausted resource; a message says which. */
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
  X(PO_BAD_INPUT, -1, "bad input")                                                                 \
  X(PO_NO_MEMORY, -2, "out of memory")                                                             \
  X(PO_CANNOT_READ, -3, "a file could not be read")                                                \
  X(PO_CANNOT_WRITE, -4, "a file could not be written")                                            \
  X(PO_MISSING_TOOL, -5, "a program this needs is not installed")                                  \
  X(PO_CHECK_FAILED, -6, "a check does not pass")

#define PO_STATUS_ENUM(name, value, text) name = value,
typedef enum { PO_STATUS_LIST(PO_STATUS_ENUM) } po_status;
#undef PO_STATUS_ENUM

/* The fixed text of a status, e.g. "not converged"; never NULL. */
const char *po_status_text(po_status status);

/* The name of a status as written in records, e.g. "not_converged"; never NULL. */
const char *po_status_name(po_status status);

/* The status of a name; false for a name of none, or NULL. */
bool po_status_find(const char *name, po_status *status);

/* Writes the message of a failure where it is seen, with the offending values (printf style), for
 * this thread, and returns `status`, so that `return po_fail(PO_BAD_INPUT, "...", x);` reads.
 * Control characters in the values, and bytes that are not UTF-8, are written as \xNN. */
po_status po_fail(po_status status, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The last message written by po_fail in this thread; "" when there is none. One line. */
const char *po_message(void);

/* Forgets the message of this thread. */
void po_message_clear(void);

/* A failed allocation may be reported as another failure, e.g. as a step that did not converge.
 * So po_fail remembers PO_NO_MEMORY, and the function that passes on a result calls po_lack_or. If
 * memory ran out in this thread since po_lack_forget, that returns PO_NO_MEMORY with the first such
 * message; otherwise it returns `status`. */
po_status po_lack_or(po_status status);
void po_lack_forget(void);

#endif
