/* Clocks. */
#ifndef PO_CLOCK_H
#define PO_CLOCK_H

/* Seconds on a clock that only goes forward. */
double po_clock_wall(void);

/* Seconds of processor time the calling thread has had: a busy machine does not make it run. */
double po_clock_thread(void);

#endif
