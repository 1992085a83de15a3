/* Sorts arrays, and searches in them: for repeated items, and for the place of a number. */
#ifndef PO_ORDER_H
#define PO_ORDER_H

#include <stdbool.h>
#include <stddef.h>

#include "po_status.h"

/* Compares two items. Given: `context`, passed through from the caller. Returned: < 0, 0 or > 0 if
 * `a` comes before, equals or comes after `b`. */
typedef int po_comparison(const void *a, const void *b, void *context);

/* Sorts `count` items of `size` bytes each; equal items keep their order, so that the result is the
 * same with every C library. Given: room for as many items. Work: O(count log count)
 * comparisons. */
void po_order_sort(void *items, size_t count, size_t size, po_comparison *compare, void *context,
                   void *room);

/* A pair of equal items in an array. */
typedef struct {
  bool found;
  size_t first, again; /* their indices, first < again; `again` is the smallest possible */
} po_repeat;

/* Finds the first item that is equal to an earlier one. Status: PO_NO_MEMORY. Work: O(count log
 * count) comparisons. */
po_status po_order_find_repeat(const void *items, size_t count, size_t size, po_comparison *compare,
                               void *context, po_repeat *repeat);

/* Compares two numbers, of type double: the function of qsort for ascending order. */
int po_order_ascending(const void *a, const void *b);

/* Returned: the index of the last of `count` ascending numbers that is not above x; 0 if all are
 * above it. Given: count >= 1. */
size_t po_order_last_up_to(const double *numbers, size_t count, double x);

#endif
