#include "po_deadline.h"

#include <math.h>
#include <stddef.h>
#include <time.h>

static _Thread_local po_deadline present = {NULL, INFINITY};

po_deadline po_deadline_begin(const volatile sig_atomic_t *stop, double deadline) {
  const po_deadline before = present;
  if (stop)
    present.stop = stop;
  present.deadline = fmin(before.deadline, deadline);
  return before;
}

void po_deadline_end(po_deadline before) {
  present = before;
}

po_status po_deadline_check(void) {
  if (present.stop && *present.stop)
    return po_fail(PO_INTERRUPTED, "interrupted");
  if (isfinite(present.deadline) && po_clock_thread() > present.deadline)
    return po_fail(PO_OUT_OF_TIME, "the time limit is reached");
  return PO_OK;
}

/* Clocks: elapsed time and processor time. */

static double read_clock(clockid_t clock) {
  struct timespec now;
  clock_gettime(clock, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double po_clock_wall(void) {
  return read_clock(CLOCK_MONOTONIC);
}

double po_clock_thread(void) {
  return read_clock(CLOCK_THREAD_CPUTIME_ID);
}
