/* A graded mesh of panels: the leaves of a binary tree over [0, domain]. Neighbours differ by at
 * most two levels, so that the near interactions of panels have few relative positions. */
#ifndef PO_PANELS_H
#define PO_PANELS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The largest number of panels of a mesh: matrix and factors then take 1.6 GB, and an equilibrium
 * about a second. A surface has room for fewer if its scene has few waves (po_surface_panels.c). */
enum { PO_MOST_PANELS = 16384 };

/* At the deepest level the nodes of a panel at the end of the domain are still some ten roundings
 * of the radius apart. */
enum { PO_DEEPEST_LEVEL = 40, PO_MOST_LEVEL_STEP = 2 };

/* The interval (index, index + 1) * domain/2^level. */
typedef struct {
  uint32_t level;
  uint64_t index;
} po_panel;

/* A mesh: too large for a stack. Only the places of panels that are there are ever written, so that
 * the others take no memory. */
typedef struct {
  size_t count;
  po_panel panel[PO_MOST_PANELS]; /* ascending */
  bool marked[PO_MOST_PANELS];    /* to be split or joined: written before each call that does so */
  bool is_new[PO_MOST_PANELS];    /* made by the last split */
} po_panels;

/* Copies the panels of a mesh. */
void po_panels_copy(const po_panels *from, po_panels *to);

/* Fills the mesh with 2^level equal panels. */
void po_panels_uniform(po_panels *panels, uint32_t level);

/* Splits the marked panels, and further panels so that neighbours differ by at most
 * PO_MOST_LEVEL_STEP levels. Returned: false if there are too many panels or one is at the deepest
 * level; then the panels are unchanged. */
bool po_panels_split(po_panels *panels);

/* Splits panels until `too_large` is false for every panel, in at most `most` passes over the new
 * panels. Given: data, passed to too_large. Returned: false if there are too many panels; those
 * before the last pass stay. */
bool po_panels_refine(po_panels *panels, int most, bool (*too_large)(void *data, po_panel panel),
                      void *data);

/* Joins pairs of marked sibling panels, except where neighbours would then differ by more than
 * PO_MOST_LEVEL_STEP levels. Returned: the number of pairs joined. */
size_t po_panels_join(po_panels *panels);

/* The length and the ends of a panel relative to the domain: [begin, end). */
static inline double po_panel_size(po_panel panel) {
  return 1.0 / (double)((uint64_t)1 << panel.level);
}
static inline double po_panel_begin(po_panel panel) {
  return (double)panel.index * po_panel_size(panel);
}
static inline double po_panel_end(po_panel panel) {
  return ((double)panel.index + 1.0) * po_panel_size(panel);
}

/* The place of x (relative to the domain) on a panel: 0 at its begin, 1 at its end. */
static inline double po_panel_place(po_panel panel, double x) {
  return x * (double)((uint64_t)1 << panel.level) - (double)panel.index;
}

/* Returned: the index of the panel that contains x (relative to the domain, 0 <= x < 1). It is
 * found faster if it is the panel `near` or the one after it. */
size_t po_panels_find(const po_panels *panels, double x, size_t near);

bool po_panel_equal(po_panel a, po_panel b);
bool po_panels_equal(const po_panels *a, const po_panels *b);

#endif
