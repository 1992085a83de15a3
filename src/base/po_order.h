/* The order of the items of an array. */
#ifndef PO_ORDER_H
#define PO_ORDER_H

#include <stdbool.h>
#include <stddef.h>

#include "po_status.h"

/* < 0, 0 or > 0 as the item `a` comes before, with or after `b`; `context` is what the caller gave.
 */
typedef int po_comparison(const void *a, const void *b, void *context);

/* The indices of `count` items of `size` bytes in ascending order of the items; items that compare
 * as equal keep the order of the array.
 * Returned: `count` indices, to be freed; NULL without memory.
 * Work: of the order of count log count comparisons. */
size_t *po_order_make(const void *items, size_t count, size_t size, po_comparison *compare,
                      void *context);

/* Two items of an array that compare as equal. */
typedef struct {
  bool found;
  size_t first, again; /* their indices, first < again, and the least `again` there is */
} po_repeat;

/* Looks for an item that is equal to an earlier one.
 * Status: PO_NO_MEMORY. Work: as above. */
po_status po_order_find_repeat(const void *items, size_t count, size_t size, po_comparison *compare,
                               void *context, po_repeat *repeat);

#endif
