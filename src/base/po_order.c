#include "po_order.h"

#include <stdlib.h>

#include "po_memory.h"

typedef struct {
  po_comparison *compare;
  void *context;
} sort_input;

/* Equal items keep the order of the array. */
static int by_item(const void *a, const void *b, void *data) {
  const sort_input *t = data;
  const char *x = *(const char *const *)a, *y = *(const char *const *)b;
  const int order = t->compare(x, y, t->context);
  return order ? order : (x > y) - (x < y);
}

po_status po_order_find_repeat(const void *items, size_t count, size_t size, po_comparison *compare,
                               void *context, po_repeat *repeat) {
  const char *bytes = items, **order = po_reserve(count, sizeof *order);
  sort_input t = {compare, context};
  *repeat = (po_repeat){.again = count};
  if (!order)
    return PO_NO_MEMORY;
  for (size_t i = 0; i < count; ++i)
    order[i] = bytes + i * size;
  qsort_r(order, count, sizeof *order, by_item, &t);
  /* Equal items are adjacent in the sorted order; the two with the smallest indices come first. */
  for (size_t n = 1; n < count; ++n) {
    const size_t first = (size_t)(order[n - 1] - bytes) / size,
                 again = (size_t)(order[n] - bytes) / size;
    if (again < repeat->again && compare(order[n - 1], order[n], context) == 0)
      *repeat = (po_repeat){true, first, again};
  }
  free(order);
  return PO_OK;
}

size_t po_order_last_up_to(const double *numbers, size_t count, double x) {
  size_t low = 0, high = count;
  while (high - low > 1) {
    const size_t middle = (low + high) / 2;
    if (numbers[middle] <= x)
      low = middle;
    else
      high = middle;
  }
  return low;
}

int po_order_ascending(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}
