#include "po_panels.h"

#include <math.h>
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

size_t po_panels_find(const po_panels *panels, double x) {
  return find(panels, whole_place(x));
}

size_t po_panels_find_near(const po_panels *panels, double x, size_t near) {
  const uint64_t at = whole_place(x);
  for (size_t k = near; k + 1 < panels->count && k < near + 2; ++k)
    if (whole_begin(panels->panel[k]) <= at && at < whole_begin(panels->panel[k + 1]))
      return k;
  return find(panels, at);
}

/* Marks the panels that would be too coarse beside a neighbour that is to be split. Returned:
 * whether a panel was marked. */
static bool mark_neighbours(const po_panels *panels, bool *split) {
  bool marked = false;
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

bool po_panels_split(po_panels *panels, const bool *split) {
  bool all[PO_MOST_PANELS];
  memcpy(all, split, panels->count * sizeof *all);
  while (mark_neighbours(panels, all))
    ;
  po_panels result;
  result.count = 0;
  for (size_t k = 0; k < panels->count; ++k) {
    const po_panel panel = panels->panel[k];
    if (result.count + (all[k] ? 2 : 1) > PO_MOST_PANELS ||
        (all[k] && panel.level >= PO_DEEPEST_LEVEL))
      return false;
    if (all[k]) {
      result.panel[result.count++] = (po_panel){panel.level + 1, 2 * panel.index};
      result.panel[result.count++] = (po_panel){panel.level + 1, 2 * panel.index + 1};
    } else {
      result.panel[result.count++] = panel;
    }
  }
  po_panels_copy(&result, panels);
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

bool po_panels_build(po_panels *panels, bool (*too_large)(void *data, po_panel panel), void *data) {
  po_panels_uniform(panels, 1);
  for (;;) {
    bool split[PO_MOST_PANELS], any = false;
    for (size_t k = 0; k < panels->count; ++k) {
      split[k] = too_large(data, panels->panel[k]);
      any = any || split[k];
    }
    if (!any)
      return true;
    if (!po_panels_split(panels, split))
      return false;
  }
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

size_t po_panels_join(po_panels *panels, const bool *join) {
  size_t joined = 0, to = 0;
  po_panels result;
  for (size_t k = 0; k < panels->count; ++k) {
    /* the left neighbour may have been joined in this loop: it is then coarser, which is allowed */
    if (k + 1 < panels->count && join[k] && join[k + 1] && can_join(panels, k)) {
      const po_panel a = panels->panel[k];
      result.panel[to++] = (po_panel){a.level - 1, a.index / 2};
      ++joined;
      ++k;
    } else {
      result.panel[to++] = panels->panel[k];
    }
  }
  result.count = to;
  po_panels_copy(&result, panels);
  return joined;
}
