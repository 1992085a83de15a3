/* The state of the process and of the thread that the solver needs, for the duration of a call of
 * the library. */
#ifndef PO_PROCESS_H
#define PO_PROCESS_H

#include <fenv.h>
#include <locale.h>

#include "po_status.h"

typedef struct {
  locale_t locale;
  fenv_t floating_point;
} po_process_state;

/* Turns off the error handler of GSL and limits OpenBLAS to one thread, unless another thread is
 * between enter and leave already; sets the locale and the floating-point environment of this
 * thread to those in which the program runs; forgets messages of earlier calls. Status:
 * PO_NO_MEMORY; then nothing has changed, and po_process_leave does nothing. */
po_status po_process_enter(po_process_state *state);

/* Restores the state of the thread, and that of the process if no other thread needs it. */
void po_process_leave(const po_process_state *state);

#endif
