#include "po_order.h"

#include <stdlib.h>
#include <string.h>

#include "po_memory.h"

typedef struct {
  po_comparison *compare;
  void *context;
  size_t size;
} order_of_items;

static void merge_sort(const order_of_items *o, char *items, size_t count, char *room) {
  if (count < 2)
    return;
  const size_t half = count / 2, size = o->size;
  merge_sort(o, items, half, room);
  merge_sort(o, items + half * size, count - half, room);
  size_t left = 0, right = half;
  for (size_t k = 0; k < count; ++k) {
    const bool from_left =
        right == count ||
        (left < half && o->compare(items + left * size, items + right * size, o->context) <= 0);
    memcpy(room + k * size, items + (from_left ? left++ : right++) * size, size);
  }
  memcpy(items, room, count * size);
}

void po_order_sort(void *items, size_t count, size_t size, po_comparison *compare, void *context,
                   void *room) {
  merge_sort(&(order_of_items){compare, context, size}, items, count, room);
}

typedef struct {
  po_comparison *compare;
  void *context;
} sort_input;

static int by_item(const void *a, const void *b, void *data) {
  const sort_input *t = data;
  return t->compare(*(const void *const *)a, *(const void *const *)b, t->context);
}

po_status po_order_find_repeat(const void *items, size_t count, size_t size, po_comparison *compare,
                               void *context, po_repeat *repeat) {
  const char *bytes = items, **order = po_reserve(2 * count, sizeof *order);
  sort_input t = {compare, context};
  *repeat = (po_repeat){.again = count};
  if (!order)
    return PO_NO_MEMORY;
  for (size_t i = 0; i < count; ++i)
    order[i] = bytes + i * size;
  po_order_sort(order, count, sizeof *order, by_item, &t, order + count);
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
