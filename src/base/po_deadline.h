/* What ends a computation before its end: a flag that a signal sets, and a limit of the processor
 * time of its thread. Whoever begins a solve begins a deadline; whatever may take long below it, a
 * factorisation as well as a closed form, looks. And the clocks. */
#ifndef PO_DEADLINE_H
#define PO_DEADLINE_H

#include <signal.h>

#include "po_status.h"

typedef struct {
  const volatile sig_atomic_t *stop; /* nonzero: interrupted; NULL: none */
  double deadline;                   /* processor time (po_clock_thread); INFINITY: none */
} po_deadline;

/* Begins a deadline of this thread within the present one: what is not given, or ends later, is
 * that of the present one. Returned: the present one, for po_deadline_end. */
po_deadline po_deadline_begin(const volatile sig_atomic_t *stop, double deadline);
void po_deadline_end(po_deadline before);

/* Status: PO_INTERRUPTED, PO_OUT_OF_TIME, with a message. Takes less than a microsecond; a solve
 * ends about as late as the longest time between two looks. */
po_status po_deadline_check(void);

/* Elapsed time, in seconds, on a monotonic clock (CLOCK_MONOTONIC). */
double po_clock_wall(void);

/* Processor time that the calling thread has used, in seconds. */
double po_clock_thread(void);

#endif
