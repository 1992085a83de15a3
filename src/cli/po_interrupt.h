/* Ctrl-C, and the TERM signal: the first asks the solves to end, the second ends at once. */
#ifndef PO_INTERRUPT_H
#define PO_INTERRUPT_H

#include <signal.h>

/* Starts listening. Returned: the flag that becomes nonzero. */
const volatile sig_atomic_t *po_interrupt_listen(void);

#endif
