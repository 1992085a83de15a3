/* Tests whether an external solver follows the protocol and computes known scenes. */
#ifndef PO_CONFORM_H
#define PO_CONFORM_H

#include <signal.h>

#include "po_ask.h"

/* Makes all tests, and prints each finding at once as a line, "ok ...", "note ..." or "wrong ...".
 * Given: the folder of the reference tables, and the folder in which the solver runs. Returned:
 * *wrong, the number of findings that are wrong. Status: PO_CANNOT_READ (a reference table),
 * PO_CANNOT_WRITE, PO_INTERRUPTED, PO_NO_MEMORY. A solver that does not conform does not change the
 * status. */
po_status po_conform(const po_solver *solver, const char *data_folder, const char *folder,
                     const volatile sig_atomic_t *stop, size_t *wrong);

#endif
