#include "po_linear.h"

#include <lapacke.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>

#include "po_lock.h"

extern void openblas_set_num_threads(int threads);
extern int openblas_get_num_threads(void);
extern char *openblas_get_config(void);

/* Size of the work area that OpenBLAS maps at its first use, in bytes: 32 << 22 in OpenBLAS 0.3.21,
 * common_x86_64.h; other architectures have at most as much. The additional 1 MB covers the pages
 * at both ends. */
static const size_t WORK_AREA = ((size_t)32 << 22) + ((size_t)1 << 20);

/* Returned: whether OpenBLAS has its work area, or there is address space for it: otherwise it
 * would retry for ever. */
static bool has_work_area(void) {
  static bool is_mapped;
  if (is_mapped)
    return true;
  void *probe =
      mmap(NULL, WORK_AREA, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  is_mapped = probe != MAP_FAILED && munmap(probe, WORK_AREA) == 0;
  return is_mapped;
}

const char *po_linear_library(void) {
  return openblas_get_config();
}

/* One thread at a time calls OpenBLAS, which then needs one work area and no threads of its own. A
 * process that uses OpenBLAS itself gets its number of threads back. */
static lapack_int call_lapack(size_t n, const double *a, size_t stride, double norm,
                              double *reciprocal) {
  lapack_int info = LAPACK_WORK_MEMORY_ERROR;
  po_lock_take(PO_LOCK_OPENBLAS);
  if (has_work_area()) {
    const int threads = openblas_get_num_threads();
    if (threads != 1)
      openblas_set_num_threads(1);
    info = LAPACKE_dgecon(LAPACK_COL_MAJOR, '1', (lapack_int)n, a, (lapack_int)stride, norm,
                          reciprocal);
    if (threads != 1)
      openblas_set_num_threads(threads);
  }
  po_lock_release(PO_LOCK_OPENBLAS);
  return info;
}

double po_linear_condition(size_t n, const double *a, size_t stride, double norm) {
  double reciprocal = 0.0;
  const lapack_int info = call_lapack(n, a, stride, norm, &reciprocal);
  if (info == LAPACK_WORK_MEMORY_ERROR)
    po_fail(PO_NO_MEMORY,
            "out of memory while the condition number of a matrix of order %zu was computed; "
            "OpenBLAS needs %zu MB of address space (ulimit -v)",
            n, WORK_AREA >> 20);
  char rounded[24];
  snprintf(rounded, sizeof rounded, "%.6e", 1.0 / reciprocal);
  return info ? (double)NAN : strtod(rounded, NULL);
}
