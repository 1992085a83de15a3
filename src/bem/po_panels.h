/* A graded mesh of panels: the leaves of a binary tree over [0, domain], neighbours differing by at
 * most two levels, so that the near interactions of panels come in a handful of shapes. */
#ifndef PO_PANELS_H
#define PO_PANELS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The most panels of a mesh: with 12 nodes a panel the matrix of influences then takes 180 MB. The
 * scenes of the cases need 51 at most. */
enum { PO_MOST_PANELS = 400 };

enum { PO_DEEPEST_LEVEL = 24, PO_MOST_LEVEL_STEP = 2 };

/* The interval (index, index + 1) * domain / 2^level. */
typedef struct {
  uint32_t level, index;
} po_panel;

typedef struct {
  size_t count;
  po_panel panel[PO_MOST_PANELS]; /* ascending */
} po_panels;

/* 2^level equal panels. */
void po_panels_uniform(po_panels *panels, uint32_t level);

/* Splits the panels marked, and others where neighbours would differ by more levels than they may.
 * Given: split, one flag a panel. Returned: false when there is no room or a panel is at the
 * deepest level; panels is then as it was. */
bool po_panels_split(po_panels *panels, const bool *split);

/* Joins pairs of sibling panels both marked, unless that would make neighbours differ by more
 * levels than they may. Given: join, one flag a panel. Returned: how many pairs were joined. */
size_t po_panels_join(po_panels *panels, const bool *join);

/* Ends of a panel relative to the domain: [begin, end). */
static inline double po_panel_size(po_panel panel) {
  return 1.0 / (double)((uint64_t)1 << panel.level);
}
static inline double po_panel_begin(po_panel panel) {
  return (double)panel.index * po_panel_size(panel);
}
static inline double po_panel_end(po_panel panel) {
  return ((double)panel.index + 1.0) * po_panel_size(panel);
}

/* The panel that contains x (relative to the domain, 0 <= x < 1). */
size_t po_panels_find(const po_panels *panels, double x);

bool po_panel_equal(po_panel a, po_panel b);
bool po_panels_equal(const po_panels *a, const po_panels *b);

/* The coarsest panels of which none is too large. Returned: false when there is no room. */
bool po_panels_build(po_panels *panels, bool (*too_large)(void *data, po_panel panel), void *data);

#endif
