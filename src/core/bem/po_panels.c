#include "po_panels.h"

#include <string.h>

bool po_panel_equal(po_panel a, po_panel b) {
  return a.level == b.level && a.index == b.index;
}

void po_panels_copy(const po_panels *from, po_panels *to) {
  to->count = from->count;
  memmove(to->panel, from->panel, from->count * sizeof *to->panel);
}

void po_panels_uniform(po_panels *panels, uint32_t level) {
  panels->count = (size_t)1 << level;
  for (uint32_t i = 0; i < panels->count; ++i)
    panels->panel[i] = (po_panel){level, i};
}

/* In units of the smallest panel all panels begin at integers. */
static uint64_t whole_begin(po_panel panel) {
  return panel.index << (PO_DEEPEST_LEVEL - panel.level);
}

/* The place of x in units of the shortest panels. */
static uint64_t whole_place(double x) {
  const double unit = (double)((uint64_t)1 << PO_DEEPEST_LEVEL);
  return x > 0.0 ? (uint64_t)(x < 1.0 ? x * unit : unit - 1.0) : 0;
}

static size_t find(const po_panels *panels, uint64_t at) {
  size_t low = 0, high = panels->count;
  while (high - low > 1) {
    const size_t middle = (low + high) / 2;
    if (whole_begin(panels->panel[middle]) <= at)
      low = middle;
    else
      high = middle;
  }
  return low;
}

size_t po_panels_find(const po_panels *panels, double x, size_t near) {
  const uint64_t at = whole_place(x);
  for (size_t k = near; k + 1 < panels->count && k < near + 2; ++k)
    if (whole_begin(panels->panel[k]) <= at && at < whole_begin(panels->panel[k + 1]))
      return k;
  return find(panels, at);
}

/* Marks the panels that would be too coarse beside a neighbour that is to be split. Returned:
 * whether a panel was marked. */
static bool mark_neighbours(po_panels *panels) {
  bool *const split = panels->marked, marked = false;
  for (size_t k = 0; k + 1 < panels->count; ++k) {
    const uint32_t left = panels->panel[k].level + split[k];
    const uint32_t right = panels->panel[k + 1].level + split[k + 1];
    if (left > right + PO_MOST_LEVEL_STEP && !split[k + 1])
      marked = split[k + 1] = true;
    if (right > left + PO_MOST_LEVEL_STEP && !split[k])
      marked = split[k] = true;
  }
  return marked;
}

bool po_panels_split(po_panels *panels) {
  while (mark_neighbours(panels))
    ;
  size_t to = panels->count;
  for (size_t k = 0; k < panels->count; ++k) {
    to += panels->marked[k];
    if (panels->marked[k] && panels->panel[k].level >= PO_DEEPEST_LEVEL)
      return false;
  }
  if (to > PO_MOST_PANELS)
    return false;
  const size_t count = to;
  for (size_t k = panels->count; k-- > 0;) { /* from the last on: no panel moves inwards */
    const po_panel panel = panels->panel[k];
    const bool halved = panels->marked[k];
    panels->panel[--to] = panel;
    panels->is_new[to] = halved;
    if (!halved)
      continue;
    panels->panel[to] = (po_panel){panel.level + 1, 2 * panel.index + 1};
    panels->panel[--to] = (po_panel){panel.level + 1, 2 * panel.index};
    panels->is_new[to] = true;
  }
  panels->count = count;
  return true;
}

bool po_panels_refine(po_panels *panels, int most, bool (*too_large)(void *data, po_panel panel),
                      void *data) {
  for (int pass = 0; pass < most; ++pass) {
    bool any = false;
    for (size_t k = 0; k < panels->count; ++k) {
      panels->marked[k] = (pass == 0 || panels->is_new[k]) && too_large(data, panels->panel[k]);
      any = any || panels->marked[k];
    }
    if (!any)
      return true;
    if (!po_panels_split(panels))
      return false;
  }
  return true;
}

bool po_panels_equal(const po_panels *a, const po_panels *b) {
  if (a->count != b->count)
    return false;
  for (size_t k = 0; k < a->count; ++k)
    if (!po_panel_equal(a->panel[k], b->panel[k]))
      return false;
  return true;
}

/* Returned: whether panels k and k + 1 are siblings whose parent would not be too coarse for its
 * neighbours. */
static bool can_join(const po_panels *panels, size_t k) {
  const po_panel a = panels->panel[k], b = panels->panel[k + 1];
  if (a.level == 0 || a.level != b.level || a.index % 2 != 0 || b.index != a.index + 1)
    return false;
  const uint32_t finest = a.level - 1 + PO_MOST_LEVEL_STEP;
  const bool left = k == 0 || panels->panel[k - 1].level <= finest;
  const bool right = k + 2 >= panels->count || panels->panel[k + 2].level <= finest;
  return left && right;
}

size_t po_panels_join(po_panels *panels) {
  const bool *const join = panels->marked;
  size_t to = 0;
  const size_t count = panels->count;
  for (size_t k = 0; k < count; ++k) {
    /* The left neighbour may have been joined in this loop: it is then coarser, which is allowed.
     * Its own place is not written before it is read. */
    po_panel panel = panels->panel[k];
    if (k + 1 < count && join[k] && join[k + 1] && can_join(panels, k)) {
      panel = (po_panel){panel.level - 1, panel.index / 2};
      ++k;
    }
    panels->panel[to++] = panel;
  }
  panels->count = to;
  return count - to;
}
