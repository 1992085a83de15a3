/* A graded mesh of panels: the leaves of a binary tree over [0, root], neighbours differing by at
 * most two levels, so that the near interactions of panels come in a handful of shapes. */
#ifndef PO_LEAVES_H
#define PO_LEAVES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { PO_MOST_LEAVES = 512, PO_DEEPEST_LEVEL = 24, PO_MOST_LEVEL_STEP = 2 };

/* The interval (index, index + 1) * root / 2^level. */
typedef struct {
  uint32_t level, index;
} po_leaf;

typedef struct {
  size_t count;
  po_leaf leaf[PO_MOST_LEAVES]; /* ascending */
} po_leaves;

/* 2^level equal leaves. */
void po_leaves_uniform(po_leaves *leaves, uint32_t level);

/* Splits the leaves marked, and others where neighbours would differ by more levels than they may.
 * Given: split, one flag a leaf. Returned: false when there is no room or a leaf is at the deepest
 * level; leaves is then as it was. */
bool po_leaves_split(po_leaves *leaves, const bool *split);

/* Joins pairs of sibling leaves both marked, unless that would make neighbours differ by more
 * levels than they may. Given: join, one flag a leaf. Returned: how many pairs were joined. */
size_t po_leaves_join(po_leaves *leaves, const bool *join);

/* Ends of a leaf in parts of the root: [begin, end). */
static inline double po_leaf_size(po_leaf leaf) {
  return 1.0 / (double)((uint64_t)1 << leaf.level);
}
static inline double po_leaf_begin(po_leaf leaf) {
  return (double)leaf.index * po_leaf_size(leaf);
}
static inline double po_leaf_end(po_leaf leaf) {
  return ((double)leaf.index + 1.0) * po_leaf_size(leaf);
}

/* The leaf that contains x (in parts of the root, 0 <= x < 1). */
size_t po_leaves_find(const po_leaves *leaves, double x);

bool po_leaf_equal(po_leaf a, po_leaf b);
bool po_leaves_equal(const po_leaves *a, const po_leaves *b);

/* The coarsest leaves of which none is too large. Returned: false when there is no room. */
bool po_leaves_build(po_leaves *leaves, bool (*too_large)(void *data, po_leaf leaf), void *data);

#endif
