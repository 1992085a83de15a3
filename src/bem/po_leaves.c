#include "po_leaves.h"

#include <string.h>

bool po_leaf_equal(po_leaf a, po_leaf b) {
  return a.level == b.level && a.index == b.index;
}

void po_leaves_uniform(po_leaves *leaves, uint32_t level) {
  leaves->count = (size_t)1 << level;
  for (uint32_t i = 0; i < leaves->count; ++i)
    leaves->leaf[i] = (po_leaf){level, i};
}

size_t po_leaves_find(const po_leaves *leaves, double x) {
  size_t low = 0, high = leaves->count;
  while (high - low > 1) {
    const size_t middle = (low + high) / 2;
    if (po_leaf_begin(leaves->leaf[middle]) <= x)
      low = middle;
    else
      high = middle;
  }
  return low;
}

/* Marks leaves too coarse for what a neighbour is about to become. Returned: whether any was
 * marked. */
static bool mark_neighbours(const po_leaves *leaves, bool *split) {
  bool marked = false;
  for (size_t k = 0; k + 1 < leaves->count; ++k) {
    const uint32_t left = leaves->leaf[k].level + split[k];
    const uint32_t right = leaves->leaf[k + 1].level + split[k + 1];
    if (left > right + PO_MOST_LEVEL_STEP && !split[k + 1])
      marked = split[k + 1] = true;
    if (right > left + PO_MOST_LEVEL_STEP && !split[k])
      marked = split[k] = true;
  }
  return marked;
}

bool po_leaves_split(po_leaves *leaves, const bool *split) {
  bool all[PO_MOST_LEAVES];
  memcpy(all, split, leaves->count * sizeof *all);
  while (mark_neighbours(leaves, all))
    ;
  po_leaves result = {.count = 0};
  for (size_t k = 0; k < leaves->count; ++k) {
    const po_leaf leaf = leaves->leaf[k];
    if (result.count + 2 > PO_MOST_LEAVES || (all[k] && leaf.level >= PO_DEEPEST_LEVEL))
      return false;
    if (all[k]) {
      result.leaf[result.count++] = (po_leaf){leaf.level + 1, 2 * leaf.index};
      result.leaf[result.count++] = (po_leaf){leaf.level + 1, 2 * leaf.index + 1};
    } else {
      result.leaf[result.count++] = leaf;
    }
  }
  *leaves = result;
  return true;
}

bool po_leaves_equal(const po_leaves *a, const po_leaves *b) {
  if (a->count != b->count)
    return false;
  for (size_t k = 0; k < a->count; ++k)
    if (!po_leaf_equal(a->leaf[k], b->leaf[k]))
      return false;
  return true;
}

bool po_leaves_build(po_leaves *leaves, bool (*too_large)(void *data, po_leaf leaf), void *data) {
  po_leaves_uniform(leaves, 1);
  for (;;) {
    bool split[PO_MOST_LEAVES], any = false;
    for (size_t k = 0; k < leaves->count; ++k) {
      split[k] = too_large(data, leaves->leaf[k]);
      any = any || split[k];
    }
    if (!any)
      return true;
    if (!po_leaves_split(leaves, split))
      return false;
  }
}

/* Whether leaves k and k + 1 are siblings whose parent would not be too coarse for its neighbours.
 */
static bool can_join(const po_leaves *leaves, size_t k) {
  const po_leaf a = leaves->leaf[k], b = leaves->leaf[k + 1];
  if (a.level == 0 || a.level != b.level || a.index % 2 != 0 || b.index != a.index + 1)
    return false;
  const uint32_t finest = a.level - 1 + PO_MOST_LEVEL_STEP;
  const bool left = k == 0 || leaves->leaf[k - 1].level <= finest;
  const bool right = k + 2 >= leaves->count || leaves->leaf[k + 2].level <= finest;
  return left && right;
}

size_t po_leaves_join(po_leaves *leaves, const bool *join) {
  size_t joined = 0, to = 0;
  po_leaves result = *leaves;
  for (size_t k = 0; k < leaves->count; ++k) {
    /* the neighbour to the left may itself just have been joined: it is then coarser, which is fine
     */
    if (k + 1 < leaves->count && join[k] && join[k + 1] && can_join(leaves, k)) {
      const po_leaf a = leaves->leaf[k];
      result.leaf[to++] = (po_leaf){a.level - 1, a.index / 2};
      ++joined;
      ++k;
    } else {
      result.leaf[to++] = leaves->leaf[k];
    }
  }
  result.count = to;
  *leaves = result;
  return joined;
}
