#include "po_order.h"

#include <stdlib.h>

#include "po_memory.h"

typedef struct {
  const char *items;
  size_t size;
  po_comparison *compare;
  void *context;
} sort_input;

static int by_item(const void *a, const void *b, void *data) {
  const sort_input *t = data;
  const size_t i = *(const size_t *)a, k = *(const size_t *)b;
  const int order = t->compare(t->items + i * t->size, t->items + k * t->size, t->context);
  return order ? order : (i > k) - (i < k);
}

/* Sorts the indices of `count` items of `size` bytes in ascending order of the items. Equal items
 * keep the order of the array. Returned: `count` indices, to be freed; NULL if memory runs out.
 * Work: O(count log count) comparisons. */
static size_t *make_order(const void *items, size_t count, size_t size, po_comparison *compare,
                          void *context) {
  sort_input t = {items, size, compare, context};
  size_t *order = po_reserve(count, sizeof *order);
  for (size_t i = 0; order && i < count; ++i)
    order[i] = i;
  if (order)
    qsort_r(order, count, sizeof *order, by_item, &t);
  return order;
}

po_status po_order_find_repeat(const void *items, size_t count, size_t size, po_comparison *compare,
                               void *context, po_repeat *repeat) {
  const char *bytes = items;
  size_t *order = make_order(items, count, size, compare, context);
  *repeat = (po_repeat){.again = count};
  if (!order)
    return PO_NO_MEMORY;
  /* Equal items are adjacent in the sorted order; the two with the smallest indices come first. */
  for (size_t n = 1; n < count; ++n)
    if (order[n] < repeat->again &&
        compare(bytes + order[n - 1] * size, bytes + order[n] * size, context) == 0)
      *repeat = (po_repeat){true, order[n - 1], order[n]};
  free(order);
  return PO_OK;
}
