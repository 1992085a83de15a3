/* The locks of the process. A child that fork() makes while other threads hold some of them finds
 * all of them free: otherwise it would wait for ever for threads that it does not have. */
#ifndef PO_LOCK_H
#define PO_LOCK_H

/* What a lock guards. A thread that holds one may take only those below it. */
typedef enum {
  PO_LOCK_CALLS,    /* the count of threads that use the library */
  PO_LOCK_OPENBLAS, /* it is called by one thread at a time */
  PO_LOCK_PANELS,   /* the influence coefficients that all solves share */
  PO_LOCK_TABLES,   /* the tables of profiles and materials that were read */
  PO_LOCKS
} po_lock;

void po_lock_take(po_lock lock);
void po_lock_release(po_lock lock);

#endif
