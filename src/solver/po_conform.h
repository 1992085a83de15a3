/* Tests whether an external solver follows the protocol and computes known scenes. */
#ifndef PO_CONFORM_H
#define PO_CONFORM_H

#include <signal.h>

#include "po_ask.h"
#include "po_text.h"

typedef struct {
  po_text lines; /* the findings, one a line: "ok ...", "note ..." or "wrong ..." */
  size_t wrong;  /* number of findings that are wrong */
  bool tell;     /* print each finding on standard output at once */
} po_conform_report;

/* Makes all tests. Given: the folder of the reference tables, and the folder in which the solver
 * runs. Status: PO_CANNOT_READ (a reference table), PO_CANNOT_WRITE, PO_INTERRUPTED, PO_NO_MEMORY.
 * A solver that does not conform does not change the status. */
po_status po_conform(const po_solver *solver, const char *data_folder, const char *folder,
                     const volatile sig_atomic_t *stop, po_conform_report *report);

#endif
