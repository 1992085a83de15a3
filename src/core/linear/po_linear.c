#include "po_linear.h"

#include <lapacke.h>
#include <math.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>

#include "po_lock.h"

extern void openblas_set_num_threads(int threads);
extern int openblas_get_num_threads(void);
extern char *openblas_get_config(void);
/* NULL in an OpenBLAS that was built without threads. */
extern int blas_thread_shutdown_(void) __attribute__((weak));

extern void *blas_memory_alloc(int position) __attribute__((weak));
extern void blas_memory_free(void *area) __attribute__((weak));

/* Whether the threads of OpenBLAS belong to a process that also uses them itself. */
static bool is_shared;

/* For versions of OpenBLAS that do not call the function of po_linear_start.c, and for programs
 * that do not have it. */
static void end_threads(void) {
  if (is_shared)
    return;
  openblas_set_num_threads(1);
  if (blas_thread_shutdown_)
    blas_thread_shutdown_();
}

/* Called once, because openblas_set_num_threads restarts threads that have ended. */
void po_linear_single_thread(void) {
  static pthread_once_t ended = PTHREAD_ONCE_INIT;
  pthread_once(&ended, end_threads);
}

int po_linear_share_threads(void) {
  is_shared = true;
  const int threads = openblas_get_num_threads();
  if (threads != 1)
    openblas_set_num_threads(1);
  return threads;
}

void po_linear_return_threads(int threads) {
  if (threads != 1)
    openblas_set_num_threads(threads);
}

/* Size of a work area, in bytes: 32 << 22 in OpenBLAS 0.3.21, common_x86_64.h; other architectures
 * have at most as much. The additional 1 MB covers the pages at both ends. */
static const size_t WORK_AREA = ((size_t)32 << 22) + ((size_t)1 << 20);

/* Returned: whether `bytes` bytes of contiguous address space are free. */
static bool is_address_space_free(size_t bytes) {
  void *probe = mmap(NULL, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  return probe != MAP_FAILED && munmap(probe, bytes) == 0;
}

/* Returned: the default stack size of a thread, in bytes; 0 if it is unknown. */
static size_t stack_size(void) {
  pthread_attr_t attributes;
  size_t size = 0;
  if (pthread_attr_init(&attributes) != 0)
    return 0;
  pthread_attr_getstacksize(&attributes, &size);
  pthread_attr_destroy(&attributes);
  return size;
}

/* Lets OpenBLAS map work areas until there are `threads`. All are allocated before any is freed,
 * because OpenBLAS reuses a freed area. Returned: the number of areas. */
static int map_areas(int threads) {
  enum { MOST = 256 };
  void *areas[MOST];
  int count = 0;
  const size_t stacks = (size_t)(threads - 1) * stack_size();
  while (count < threads && count < MOST && is_address_space_free(WORK_AREA + stacks))
    areas[count++] = blas_memory_alloc(0);
  for (int i = 0; i < count; ++i)
    blas_memory_free(areas[i]);
  return count == MOST ? threads : count;
}

po_status po_linear_reserve(int threads) {
  static int reserved;
  po_linear_single_thread();
  po_lock_take(PO_LOCK_WORK_AREAS);
  if (reserved < threads && blas_memory_alloc && blas_memory_free)
    reserved = map_areas(threads);
  const bool enough = reserved >= threads || !blas_memory_alloc || !blas_memory_free;
  po_lock_release(PO_LOCK_WORK_AREAS);
  if (enough)
    return PO_OK;
  return po_fail(
      PO_NO_MEMORY,
      "out of memory: OpenBLAS needs %zu MB of address space for each thread (%d), and this "
      "process does not have it: raise the limit (ulimit -v)%s",
      WORK_AREA >> 20, threads, threads > 1 ? ", or solve fewer points at a time" : "");
}

const char *po_linear_library(void) {
  return openblas_get_config();
}

double po_linear_condition(size_t n, const double *a, size_t stride, double norm) {
  double reciprocal = 0.0;
  const lapack_int info = LAPACKE_dgecon(LAPACK_COL_MAJOR, '1', (lapack_int)n, a,
                                         (lapack_int)stride, norm, &reciprocal);
  if (info == LAPACK_WORK_MEMORY_ERROR)
    po_fail(PO_NO_MEMORY,
            "out of memory while the condition number of a matrix of order %zu was computed", n);
  char rounded[24];
  snprintf(rounded, sizeof rounded, "%.6e", 1.0 / reciprocal);
  return info ? (double)NAN : strtod(rounded, NULL);
}
