/* A function that wasi-libc lacks. */
#ifndef PO_LIVE_STDLIB_H
#define PO_LIVE_STDLIB_H

#include_next <stdlib.h>
void qsort_r(void *base, size_t count, size_t size,
             int (*compare)(const void *, const void *, void *), void *context);

#endif
