/* Checked, aligned allocation. */
#ifndef PO_MEMORY_H
#define PO_MEMORY_H

#include <stdbool.h>
#include <stddef.h>

/* `count` zeroed objects of `size` bytes, aligned to a cache line (so that the BLAS kernels take
 * the same path, and give the same bits, in every run), or NULL with a message when there is no
 * memory or count*size overflows. Free with free(). A count of 0 gives a valid pointer. */
void *po_allocate(size_t count, size_t size);

/* The same without zeroing: pages that are never written cost nothing. */
void *po_reserve(size_t count, size_t size);

/* Room for a square matrix of order n, what was in it being lost: the matrix itself where its room,
 * in numbers, will do, else a new one with some to spare. Returned: it, and its room; NULL with a
 * message, and room 0, when there is no memory. */
void *po_reserve_matrix(void *matrix, size_t *room, size_t n, size_t size);

/* As realloc for arrays that grow, checked for overflow; on failure NULL, a message, and the old
 * array untouched. Not aligned: for records, not for linear algebra. */
void *po_resize(void *array, size_t count, size_t size);

/* Room for one more in an array of `count` that grows: the array, or a larger one that takes its
 * place, and its room, in records; on failure as po_resize. */
void *po_grow(void *array, size_t count, size_t *room, size_t size);

/* A copy of a string, or NULL with a message. */
char *po_copy_text(const char *text);

/* For library functions that report a failed allocation like any other failure, or not at all: call
 * po_memory_watch before the function; po_memory_ran_out after it returns whether an allocation of
 * this thread failed (POSIX: malloc then sets errno to ENOMEM). */
void po_memory_watch(void);
bool po_memory_ran_out(void);

#endif
