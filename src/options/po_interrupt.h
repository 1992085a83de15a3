/* Handles Ctrl-C and the signal TERM: the first signal asks the solves to end, the second ends the
 * program at once. */
#ifndef PO_INTERRUPT_H
#define PO_INTERRUPT_H

#include <signal.h>

/* Installs the handlers. Returned: a flag that becomes nonzero when the first signal arrives. */
const volatile sig_atomic_t *po_interrupt_listen(void);

#endif
