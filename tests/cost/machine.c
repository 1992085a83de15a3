#include "machine.h"

#include <stdlib.h>

#include <cblas.h>

#include "po_deadline.h"
#include "po_linear.h"
#include "po_memory.h"

const double LEAST_TIME = 0.02;

/* Orders of the matrices whose product is timed, which are in the cache, and of the matrix that is
 * read from memory. */
enum { PRODUCT_ORDER = 768, MEMORY_ORDER = 4096 };

static double time_of(void (*call)(void *data), void *data, int calls) {
  const double begin = po_clock_thread();
  for (int k = 0; k < calls; ++k)
    call(data);
  return po_clock_thread() - begin;
}

static int ascending(const void *left, const void *right) {
  const double a = *(const double *)left, b = *(const double *)right;
  return (a > b) - (a < b);
}

double median_time(void (*call)(void *data), void *data) {
  double time[ROUNDS];
  int calls = 1;
  call(data);
  while (time_of(call, data, calls) < LEAST_TIME)
    calls *= 2;
  for (int k = 0; k < ROUNDS; ++k)
    time[k] = time_of(call, data, calls) / calls;
  qsort(time, ROUNDS, sizeof *time, ascending);
  return time[ROUNDS / 2];
}

typedef struct {
  double *a, *b, *c;
  float *d, *e, *f;
} matrices;

static void multiply(void *data) {
  const matrices *m = data;
  enum { n = PRODUCT_ORDER };
  cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, n, n, n, 1.0, m->a, n, m->b, n, 0.0, m->c,
              n);
}

static void multiply_single(void *data) {
  const matrices *m = data;
  enum { n = PRODUCT_ORDER };
  cblas_sgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, n, n, n, 1.0F, m->d, n, m->e, n, 0.0F,
              m->f, n);
}

static void read_memory(void *data) {
  const matrices *m = data;
  po_linear_apply(MEMORY_ORDER, MEMORY_ORDER, m->a, MEMORY_ORDER, m->b, m->c);
}

po_status machine_measure(machine_rates *rates) {
  const size_t n = (size_t)PRODUCT_ORDER * PRODUCT_ORDER;
  const size_t large = (size_t)MEMORY_ORDER * MEMORY_ORDER;
  matrices m = {po_reserve(large, sizeof(double)), po_allocate(n, sizeof(double)),
                po_allocate(n, sizeof(double)),    po_allocate(n, sizeof(float)),
                po_allocate(n, sizeof(float)),     po_allocate(n, sizeof(float))};
  const bool had = m.a && m.b && m.c && m.d && m.e && m.f;
  for (size_t k = 0; had && k < large; ++k) /* the pages must exist */
    m.a[k] = (double)(k % 7);
  if (had) {
    const double flops = 2.0 * (double)n * PRODUCT_ORDER;
    rates->in_double = flops / median_time(multiply, &m);
    rates->in_single = flops / median_time(multiply_single, &m);
    rates->memory = (double)(large * sizeof(double)) / median_time(read_memory, &m);
  }
  free(m.a);
  free(m.b);
  free(m.c);
  free(m.d);
  free(m.e);
  free(m.f);
  return had ? PO_OK : PO_NO_MEMORY;
}
