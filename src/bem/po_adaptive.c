#include "po_adaptive.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_memory.h"

struct po_adaptive {
  const po_panel_table *table;
  double domain, decay; /* decay: of the traction beyond */
  bool unbounded, wavy;
  po_panels panels, before;
  po_surface surface;
  double *spare;           /* memory for the influence matrix of the next mesh */
  bool spare_is_before;    /* `spare` still holds the matrix of the mesh `before` */
  size_t room, spare_room; /* allocated sizes of the two matrices, in elements */
};

static size_t nodes_of(const po_adaptive *a, const po_panels *panels) {
  return (panels->count + (a->unbounded ? 1 : 0)) * PO_TABLE_ORDER;
}

size_t po_adaptive_capacity(const po_adaptive *a) {
  (void)a;
  return (PO_MOST_PANELS + 1) * PO_TABLE_ORDER;
}

const po_surface *po_adaptive_surface(const po_adaptive *a) {
  return &a->surface;
}
const po_panels *po_adaptive_panels(const po_adaptive *a) {
  return &a->panels;
}
double po_adaptive_domain(const po_adaptive *a) {
  return a->domain;
}

po_status po_adaptive_create(const po_scene *scene, double domain, uint32_t level,
                             po_adaptive **adaptive) {
  po_adaptive *a = po_allocate(1, sizeof *a);
  *adaptive = a;
  if (!a)
    return PO_NO_MEMORY;
  a->table = po_panel_table_get();
  a->domain = domain;
  a->unbounded = isinf(scene->outer_radius);
  a->wavy = po_scene_is_wavy(scene);
  a->decay = po_panel_decay(scene);
  const size_t most = po_adaptive_capacity(a);
  po_surface *s = &a->surface;
  s->core_radius = domain;
  s->node = po_allocate(most, sizeof *s->node);
  s->weight = po_allocate(most, sizeof *s->weight);
  s->length = po_allocate(most, sizeof *s->length);
  s->reach = po_allocate(most, sizeof *s->reach);
  po_panels panels;
  po_panels_uniform(&panels, level);
  po_status status = PO_NO_MEMORY;
  if (a->table && s->node && s->weight && s->length && s->reach)
    status = po_adaptive_mesh(a, &panels);
  if (status) {
    po_adaptive_destroy(a);
    *adaptive = NULL;
  }
  return status;
}

void po_adaptive_destroy(po_adaptive *a) {
  if (!a)
    return;
  free(a->surface.node);
  free(a->surface.weight);
  free(a->surface.length);
  free(a->surface.influence);
  free(a->surface.reach);
  free(a->spare);
  free(a);
}

/* Returned: whether `node` are the nodes of a panel to rounding. */
static bool has_nodes(const po_adaptive *a, po_panel panel, const double *node) {
  const double begin = a->domain * po_panel_begin(panel), size = a->domain * po_panel_size(panel);
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j)
    if (!(fabs(begin + size * a->table->rule.node[j] - node[j]) < 1e-9 * size))
      return false;
  return true;
}

po_status po_adaptive_panels_of(const po_adaptive *a, size_t n, const double *node,
                                po_panels *panels) {
  const double *x = a->table->rule.node;
  panels->count = 0;
  for (size_t j = 0; j + PO_TABLE_ORDER <= n && panels->count < PO_MOST_PANELS;
       j += PO_TABLE_ORDER) {
    const double size = (node[j + PO_TABLE_ORDER - 1] - node[j]) / (x[PO_TABLE_ORDER - 1] - x[0]);
    const double begin = (node[j] - x[0] * size) / size;
    const po_panel panel = {(uint32_t)lround(log2(a->domain / size)), (uint32_t)lround(begin)};
    if (!has_nodes(a, panel, node + j))
      break;
    panels->panel[panels->count++] = panel;
  }
  return panels->count * PO_TABLE_ORDER == n
             ? PO_OK
             : po_fail(PO_BAD_INPUT, "the radii are not the nodes of panels");
}

static po_panel_span panel_of(const po_adaptive *a, const po_panels *panels, size_t k) {
  if (k == panels->count)
    return (po_panel_span){a->domain, INFINITY, a->decay};
  return (po_panel_span){.begin = a->domain * po_panel_begin(panels->panel[k]),
                         .end = a->domain * po_panel_end(panels->panel[k])};
}

static void place_nodes(po_adaptive *a) {
  po_surface *s = &a->surface;
  s->n = nodes_of(a, &a->panels);
  s->resolved = a->unbounded && a->wavy ? s->n - PO_TABLE_ORDER : s->n;
  for (size_t k = 0; k < s->n / PO_TABLE_ORDER; ++k)
    po_panel_nodes(&a->table->rule, panel_of(a, &a->panels, k), s->node + k * PO_TABLE_ORDER,
                   s->weight + k * PO_TABLE_ORDER, s->length + k * PO_TABLE_ORDER);
}

/* Finds for each panel its index in the mesh before, or SIZE_MAX if it is new. */
static void match_panels(const po_adaptive *a, size_t *old_index) {
  size_t old = 0;
  for (size_t k = 0; k < a->panels.count; ++k) {
    const po_panel panel = a->panels.panel[k];
    while (old < a->before.count && po_panel_end(a->before.panel[old]) <= po_panel_begin(panel))
      ++old;
    old_index[k] =
        old < a->before.count && po_panel_equal(a->before.panel[old], panel) ? old : SIZE_MAX;
  }
  /* the panel to infinity is in every mesh; before the first mesh there is none */
  old_index[a->panels.count] = a->before.count;
  if (a->before.count == 0)
    old_index[a->panels.count] = SIZE_MAX;
}

static void copy_blocks(const double *from, size_t from_stride, double *to, size_t to_stride,
                        size_t count) {
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j)
    memcpy(to + j * to_stride, from + j * from_stride, count * PO_TABLE_ORDER * sizeof *to);
}

/* Returned: the number of panels from `first` on, up to `end`, that were neighbours in the same
 * order in the mesh before; 0 if `first` is new. */
static size_t kept_together(const size_t *old_index, size_t first, size_t end) {
  if (old_index[first] == SIZE_MAX)
    return 0;
  size_t count = 1;
  while (first + count < end && old_index[first + count] == old_index[first] + count)
    ++count;
  return count;
}

static void compute_block(po_adaptive *a, size_t target, size_t source, double *to, size_t stride) {
  const po_panels *panels = &a->panels;
  if (target < panels->count && source < panels->count) {
    po_panel_block block;
    po_panel_table_block(a->table, panels->panel[target], panels->panel[source], block);
    for (size_t j = 0; j < PO_TABLE_ORDER; ++j)
      for (size_t i = 0; i < PO_TABLE_ORDER; ++i)
        to[i + j * stride] = a->domain * block[i][j];
    a->surface.kernel_evaluations += PO_TABLE_ORDER * PO_TABLE_ORDER;
    return;
  }
  const po_panel_span panel = panel_of(a, panels, source);
  for (size_t i = 0; i < PO_TABLE_ORDER; ++i)
    a->surface.kernel_evaluations += po_panel_influence(
        &a->table->rule, panel, a->surface.node[target * PO_TABLE_ORDER + i], to + i, stride);
}

/* The kernel decreases with the distance, so the largest coefficient of a column is in the panel of
 * its node or in a neighbour. */
static void find_reach(po_surface *s) {
  for (size_t j = 0; j < s->n; ++j) {
    const size_t panel = j / PO_TABLE_ORDER * PO_TABLE_ORDER;
    const size_t end = panel + 2 * PO_TABLE_ORDER;
    s->reach[j] =
        po_surface_largest(s, j, panel > 0 ? panel - PO_TABLE_ORDER : 0, end < s->n ? end : s->n);
  }
}

static void exchange_matrices(po_adaptive *a) {
  double *const matrix = a->surface.influence;
  const size_t room = a->room;
  a->surface.influence = a->spare;
  a->room = a->spare_room;
  a->spare = matrix;
  a->spare_room = room;
}

/* Returns to the mesh before, whose matrix is still there. */
static void go_back(po_adaptive *a) {
  const po_panels panels = a->panels;
  a->panels = a->before;
  a->before = panels;
  place_nodes(a);
  exchange_matrices(a);
  find_reach(&a->surface);
}

po_status po_adaptive_mesh(po_adaptive *a, const po_panels *panels) {
  if (a->spare_is_before && po_panels_equal(panels, &a->before)) {
    go_back(a);
    return PO_OK;
  }
  a->spare_is_before = false;
  a->spare = po_reserve_matrix(a->spare, &a->spare_room, nodes_of(a, panels), sizeof *a->spare);
  if (!a->spare)
    return PO_NO_MEMORY;
  const size_t old_n = a->surface.n;
  size_t old_index[PO_MOST_PANELS + 1];
  a->before = a->panels;
  a->panels = *panels;
  place_nodes(a);
  match_panels(a, old_index);
  const size_t n = a->surface.n, panel_count = n / PO_TABLE_ORDER;
  for (size_t source = 0; source < panel_count; ++source)
    for (size_t target = 0, count; target < panel_count; target += count) {
      double *to = a->spare + target * PO_TABLE_ORDER + n * source * PO_TABLE_ORDER;
      count = old_index[source] == SIZE_MAX ? 0 : kept_together(old_index, target, panel_count);
      if (count > 0) {
        copy_blocks(a->surface.influence + old_index[target] * PO_TABLE_ORDER +
                        old_n * old_index[source] * PO_TABLE_ORDER,
                    old_n, to, n, count);
      } else {
        compute_block(a, target, source, to, n);
        count = 1;
      }
    }
  exchange_matrices(a);
  a->spare_is_before = a->before.count > 0;
  find_reach(&a->surface);
  return PO_OK;
}

/* Nodes and influence coefficients scale with the domain, weights with its square. */
void po_adaptive_resize(po_adaptive *a, double domain) {
  const double factor = domain / a->domain;
  if (factor == 1.0)
    return;
  po_surface *s = &a->surface;
  a->domain = s->core_radius = domain;
  a->spare_is_before = false;
  place_nodes(a);
  for (size_t j = 0; j < s->n * s->n; ++j)
    s->influence[j] *= factor;
  find_reach(s);
}
