/* The parts of the program that are written in Python: the report, and the fit of force curves. */
#ifndef PO_PYTHON_H
#define PO_PYTHON_H

#include "po_status.h"

/* Returned: the path of Python: that of PULLOFF_PYTHON, or the one that was found at the build. */
const char *po_python(void);

/* Runs Python and waits for it; its messages go to standard error. The module pulloff of the source
 * tree and the library of this program are found. Given: argv, po_python() first, NULL last.
 * Returned: its exit code, or that of the program if it cannot be started. */
int po_python_run(char *const *argv);

#endif
