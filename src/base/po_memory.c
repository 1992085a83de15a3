#include "po_memory.h"

#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "po_machine.h"
#include "po_status.h"

static const size_t CACHE_LINE = 64; /* bytes; also the width of an AVX-512 register */

void *po_reserve(size_t count, size_t size) {
  if (size && count > (SIZE_MAX - CACHE_LINE) / size) {
    po_fail(PO_NO_MEMORY, "out of memory: %zu objects of %zu bytes are more than can be addressed",
            count, size);
    return NULL;
  }
  const size_t bytes = (count * size / CACHE_LINE + 1) * CACHE_LINE;
  void *memory = po_machine_allocate(CACHE_LINE, bytes);
  if (!memory)
    po_fail(PO_NO_MEMORY, "out of memory: %zu bytes could not be allocated", bytes);
  return memory;
}

/* po_reserve_matrix allocates for an order larger than requested by this factor, because the order
 * grows in small increments. */
static const double GROWTH = 1.3;

void *po_reserve_matrix(void *matrix, size_t *room, size_t n, size_t size) {
  if (matrix && n * n <= *room)
    return matrix;
  const size_t order = (size_t)(GROWTH * (double)n);
  free(matrix);
  void *memory = po_reserve(order * order, size);
  *room = memory ? order * order : 0;
  return memory;
}

void *po_allocate(size_t count, size_t size) {
  void *memory = po_reserve(count, size);
  return memory ? memset(memory, 0, count * size) : NULL;
}

/* Each array follows the address of the one that was allocated before, on a cache line of its own,
 * which takes the place of `extra` objects. */
void *po_arena_reserve(po_arena *arrays, size_t count, size_t size) {
  const size_t extra = CACHE_LINE / size + 1;
  void **block = po_reserve(count < SIZE_MAX - extra ? count + extra : SIZE_MAX, size);
  if (!block) {
    arrays->ran_out = true;
    return NULL;
  }
  *block = arrays->last;
  arrays->last = block;
  return (char *)block + CACHE_LINE;
}

void *po_arena_allocate(po_arena *arrays, size_t count, size_t size) {
  void *array = po_arena_reserve(arrays, count, size);
  return array ? memset(array, 0, count * size) : NULL;
}

void po_arena_free(po_arena *arrays) {
  for (void **block = arrays->last, **before; block; block = before) {
    before = *block;
    free(block);
  }
  *arrays = (po_arena){0};
}

void *po_resize(void *array, size_t count, size_t size) {
  if (size && count > SIZE_MAX / size) {
    po_fail(PO_NO_MEMORY, "out of memory: %zu objects of %zu bytes are more than can be addressed",
            count, size);
    return NULL;
  }
  void *memory = realloc(array, count > 0 ? count * size : size);
  if (!memory)
    po_fail(PO_NO_MEMORY, "out of memory: %zu bytes could not be allocated", count * size);
  return memory;
}

/* Records for which a growing array has memory at first; the memory is then doubled. */
enum { FIRST_ROOM = 16 };

void *po_grow(void *array, size_t count, size_t *room, size_t size) {
  if (count < *room)
    return array;
  const size_t larger = *room ? 2 * *room : FIRST_ROOM;
  void *moved = po_resize(array, larger, size);
  if (moved)
    *room = larger;
  return moved;
}

char *po_copy_text(const char *text) {
  char *copy = strdup(text);
  if (!copy)
    po_fail(PO_NO_MEMORY, "out of memory: %zu bytes could not be allocated", strlen(text) + 1);
  return copy;
}

void po_memory_watch(void) {
  errno = 0;
}

bool po_memory_ran_out(void) {
  return errno == ENOMEM;
}
