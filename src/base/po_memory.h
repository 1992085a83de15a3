/* Memory allocation with overflow checks and cache-line alignment. */
#ifndef PO_MEMORY_H
#define PO_MEMORY_H

#include <stdbool.h>
#include <stddef.h>

/* Allocates `count` zeroed objects of `size` bytes, aligned to a cache line
 * (see po_machine_allocate). Returned: the memory, to be freed with free(), a valid pointer also
 * for a count of 0; NULL with a message if memory runs out or count * size overflows. */
void *po_allocate(size_t count, size_t size);

/* As po_allocate, but without zeroing: pages that are never written use no physical memory. */
void *po_reserve(size_t count, size_t size);

/* Provides memory for a square matrix of order n. The content is lost. Given: matrix, from an
 * earlier call or NULL; *room, the number of elements it has memory for. Returned: the same matrix
 * if it is large enough, otherwise a new one with some reserve, and *room; NULL with a message, and
 * *room = 0, if memory runs out. */
void *po_reserve_matrix(void *matrix, size_t *room, size_t n, size_t size);

/* The arrays of an object, which are freed together. Begins as {0}. */
typedef struct {
  void *last;
  bool ran_out; /* an allocation failed since the arrays were freed last */
} po_arena;

/* As po_allocate and po_reserve, but the memory belongs to the arrays, and free() must not be
 * called. Given: size, > 0. */
void *po_arena_allocate(po_arena *arrays, size_t count, size_t size);
void *po_arena_reserve(po_arena *arrays, size_t count, size_t size);

/* Frees all arrays; others may then be allocated. */
void po_arena_free(po_arena *arrays);

/* As realloc, with a check for overflow. The memory is not aligned: it is meant for records, not
 * for linear algebra. Returned: NULL with a message on failure; then the old array is unchanged. */
void *po_resize(void *array, size_t count, size_t size);

/* Provides memory for one more record in an array that grows. Given: array, with `count` records
 * and memory for *room. Returned: the array, or a larger one that replaces it, and *room; on
 * failure as po_resize. */
void *po_grow(void *array, size_t count, size_t *room, size_t size);

/* Returned: a copy of a string, to be freed; NULL with a message if memory runs out. */
char *po_copy_text(const char *text);

/* Detect a failed allocation inside a library function that reports it like any other failure, or
 * not at all: call po_memory_watch before the function; po_memory_ran_out after it returns whether
 * an allocation of this thread failed (POSIX: malloc then sets errno to ENOMEM). */
void po_memory_watch(void);
bool po_memory_ran_out(void);

#endif
