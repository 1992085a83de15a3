/* The progress of a verb that may take long: a line on standard error that is updated on a
 * terminal, from the second second on; elsewhere, if `plain` is set, a line every ten seconds. And
 * its interruption by Ctrl-C or the signal TERM: the first signal asks the solves to end, the
 * second ends the program at once. */
#ifndef PO_LIVE_H
#define PO_LIVE_H

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>

typedef struct {
  bool is_terminal, plain;
  double begin, last; /* seconds of the monotonic clock */
  size_t width;       /* of the line that is now on the terminal */
} po_live;

/* Begins now. */
po_live po_live_begin(bool plain);

/* Shows a line, with the time since the beginning after it, if one is due. */
void po_live_show(po_live *live, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Erases the updated line. */
void po_live_end(po_live *live);

/* Installs the handlers. Returned: a flag that becomes nonzero when the first signal arrives. */
const volatile sig_atomic_t *po_interrupt_listen(void);

#endif
