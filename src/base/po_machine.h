/* What differs between operating systems, beside files: memory, and the locale of a thread. On
 * Windows po_windows.c has these functions and those of po_file.h that a library needs. */
#ifndef PO_MACHINE_H
#define PO_MACHINE_H

#include <stdbool.h>
#include <stddef.h>

/* Returned: memory, to be freed with free(); NULL if it runs out. Where the system has such a
 * function its address is a multiple of `alignment`, otherwise one of 16 bytes. Given: bytes, a
 * multiple of `alignment`. */
void *po_machine_allocate(size_t alignment, size_t bytes);

/* Returned: the memory of the machine, or less if the process is limited to less, bytes. */
double po_machine_memory(void);

/* Sets the locale of this thread to C, in which numbers have decimal points. Returned: *before, for
 * po_machine_set_locale; false if memory runs out, and nothing is changed. */
bool po_machine_plain_locale(void **before);
void po_machine_set_locale(void *before);

#endif
