/* Clocks. */
#ifndef PO_CLOCK_H
#define PO_CLOCK_H

/* Seconds on a clock that only goes forward. */
double po_clock_wall(void);

/* Seconds of processor time the calling thread has had: it stands still while the thread waits. */
double po_clock_thread(void);

#endif
