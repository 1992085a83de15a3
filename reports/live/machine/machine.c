/* What wasi-libc lacks, and what the solver takes of OpenBLAS and of a file system, which the
 * module does not have. */
#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "po_file.h"
#include "po_linear.h"

/* Sorts by merging; equal items keep their order. */
static void merge_sort(char *items, size_t count, size_t size, char *room,
                       int (*compare)(const void *, const void *, void *), void *context) {
  if (count < 2)
    return;
  const size_t half = count / 2;
  merge_sort(items, half, size, room, compare, context);
  merge_sort(items + half * size, count - half, size, room, compare, context);
  size_t left = 0, right = half;
  for (size_t k = 0; k < count; ++k) {
    const bool from_left =
        right == count ||
        (left < half && compare(items + left * size, items + right * size, context) <= 0);
    memcpy(room + k * size, items + (from_left ? left++ : right++) * size, size);
  }
  memcpy(items, room, count * size);
}

void qsort_r(void *base, size_t count, size_t size,
             int (*compare)(const void *, const void *, void *), void *context) {
  char *room = malloc(count * size + 1);
  if (!room)
    abort();
  merge_sort(base, count, size, room, compare, context);
  free(room);
}

/* Replaces that of wasi-libc, which grows the memory by as little as 64 KiB: every growth costs the
 * browser a new ArrayBuffer, and a scene three times its time. */
void *sbrk(intptr_t more) {
  static uintptr_t end;
  const uintptr_t PAGE = 65536, STEP = 512; /* at least 32 MiB */
  const uintptr_t pages = (uintptr_t)__builtin_wasm_memory_size(0);
  if (!end)
    end = pages * PAGE;
  if (more <= 0)
    return (void *)end;
  const uintptr_t before = end, room = pages * PAGE - end;
  if ((uintptr_t)more > room) {
    const uintptr_t least = ((uintptr_t)more - room + PAGE - 1) / PAGE;
    const uintptr_t wanted = least > STEP ? least : STEP;
    if (__builtin_wasm_memory_grow(0, wanted) == SIZE_MAX &&
        __builtin_wasm_memory_grow(0, least) == SIZE_MAX) {
      errno = ENOMEM;
      return (void *)-1;
    }
  }
  end = before + (uintptr_t)more;
  return (void *)before;
}

/* po_linear.c without OpenBLAS, which has threads to limit and estimates condition numbers. */
void po_linear_single_thread(void) {}

int po_linear_share_threads(void) {
  return 1;
}

void po_linear_return_threads(int threads) {
  (void)threads;
}

po_status po_linear_reserve(int threads) {
  (void)threads;
  return PO_OK;
}

double po_linear_condition(size_t n, const double *a, size_t stride, double norm) {
  (void)n;
  (void)a;
  (void)stride;
  (void)norm;
  return (double)NAN;
}

/* The module has no files, and so no pipes. */
uint64_t po_path_pipe(const char *path) {
  (void)path;
  return 0;
}
