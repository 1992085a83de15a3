/* Clocks: elapsed time and processor time. */
#ifndef PO_CLOCK_H
#define PO_CLOCK_H

/* Elapsed time, in seconds, on a monotonic clock (CLOCK_MONOTONIC). */
double po_clock_wall(void);

/* Processor time that the calling thread has used, in seconds. */
double po_clock_thread(void);

#endif
