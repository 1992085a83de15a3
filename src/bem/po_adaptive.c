#include "po_adaptive.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_elementary.h"

/* Panels for which a surface has room: of any scene, and more for each wave on the domain. The
 * finest meshes of (3, 1, 20) take four a wave. */
static const double ROOM = 4096.0, ROOM_A_WAVE = 8.0;

static size_t room_of(const po_scene *scene, double domain) {
  double room = ROOM;
  for (size_t k = 0; k < po_scene_waves(scene); ++k)
    room += ROOM_A_WAVE * domain / po_scene_wave(scene, k).length;
  return (size_t)fmin(room, PO_MOST_PANELS);
}

po_status po_adaptive_create(const po_scene *scene, double domain, uint32_t level,
                             po_adaptive **adaptive) {
  po_adaptive *a = po_allocate(1, sizeof *a);
  *adaptive = a;
  if (!a)
    return PO_NO_MEMORY;
  const po_panel_table *table = po_panel_table_get();
  a->wavy = po_scene_is_wavy(scene);
  a->most = room_of(scene, domain);
  a->capacity = (a->most + 1) * PO_TABLE_ORDER;
  po_surface *s = &a->surface;
  s->core_radius = domain;
  s->node = po_arrays_reserve(&s->arrays, a->capacity, sizeof *s->node);
  s->weight = po_arrays_reserve(&s->arrays, a->capacity, sizeof *s->weight);
  s->length = po_arrays_reserve(&s->arrays, a->capacity, sizeof *s->length);
  s->reach = po_arrays_reserve(&s->arrays, a->capacity, sizeof *s->reach);
  po_panels_uniform(&a->draft, level);
  po_status status = PO_NO_MEMORY;
  if (table && !s->arrays.ran_out)
    status = po_hierarchy_create(table, isinf(scene->outer_radius), po_panel_decay(scene),
                                 &s->hierarchy);
  if (!status)
    status = po_adaptive_mesh(a, &a->draft);
  if (status) {
    po_adaptive_destroy(a);
    *adaptive = NULL;
  }
  return status;
}

void po_adaptive_destroy(po_adaptive *a) {
  if (!a)
    return;
  po_arrays_free(&a->surface.arrays);
  po_hierarchy_destroy(a->surface.hierarchy);
  free(a);
}

/* Returned: whether `node` are the nodes of a panel to rounding. */
static bool has_nodes(const po_adaptive *a, po_panel panel, const double *node) {
  const double domain = a->surface.core_radius;
  const double begin = domain * po_panel_begin(panel), size = domain * po_panel_size(panel);
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j)
    if (!(fabs(begin + size * po_panel_table_get()->rule.node[j] - node[j]) <
          1e-9 * size + 4.0 * DBL_EPSILON * domain))
      return false;
  return true;
}

po_status po_adaptive_panels_of(const po_adaptive *a, size_t n, const double *node,
                                po_panels *panels) {
  const double *x = po_panel_table_get()->rule.node, domain = a->surface.core_radius;
  panels->count = 0;
  for (size_t j = 0; j + PO_TABLE_ORDER <= n && panels->count < a->most; j += PO_TABLE_ORDER) {
    const double size = (node[j + PO_TABLE_ORDER - 1] - node[j]) / (x[PO_TABLE_ORDER - 1] - x[0]);
    const uint32_t level = (uint32_t)lround(po_log(domain / size) / M_LN2);
    const double begin = ldexp(node[j] / domain, (int)level) - x[0];
    const po_panel panel = {level, (uint64_t)llround(begin)};
    if (!has_nodes(a, panel, node + j))
      break;
    panels->panel[panels->count++] = panel;
  }
  return panels->count * PO_TABLE_ORDER == n
             ? PO_OK
             : po_fail(PO_BAD_INPUT, "the radii are not the nodes of panels");
}

static po_panel_span span_of(const po_surface *s, size_t k) {
  const po_hierarchy *h = s->hierarchy;
  const double domain = s->core_radius;
  if (k == h->panels.count)
    return (po_panel_span){domain, INFINITY, h->decay};
  return (po_panel_span){.begin = domain * po_panel_begin(h->panels.panel[k]),
                         .end = domain * po_panel_end(h->panels.panel[k])};
}

static void place_nodes(po_adaptive *a) {
  po_surface *s = &a->surface;
  s->n = po_hierarchy_nodes(s->hierarchy);
  s->resolved = s->hierarchy->unbounded && a->wavy ? s->n - PO_TABLE_ORDER : s->n;
  for (size_t j = 0; j < s->n; j += PO_TABLE_ORDER)
    po_panel_nodes(&s->hierarchy->table->rule, span_of(s, j / PO_TABLE_ORDER), s->node + j,
                   s->weight + j, s->length + j);
}

/* The largest coefficients, in eps. */
static void fill_reach(po_surface *s) {
  po_hierarchy_reach(s->hierarchy, s->reach);
  for (size_t j = 0; j < s->n; ++j)
    s->reach[j] *= s->core_radius;
}

po_status po_adaptive_mesh(po_adaptive *a, const po_panels *panels) {
  if (panels->count > a->most)
    return po_fail(PO_OUT_OF_NODES, "the traction needs %zu panels, more than %zu", panels->count,
                   a->most);
  const po_status status = po_hierarchy_mesh(a->surface.hierarchy, panels);
  if (status)
    return status;
  place_nodes(a);
  fill_reach(&a->surface);
  a->surface.kernel_evaluations = a->surface.hierarchy->evaluations;
  return PO_OK;
}

/* Nodes and influence coefficients scale with the domain, weights with its square. */
void po_adaptive_resize(po_adaptive *a, double domain) {
  if (domain == a->surface.core_radius)
    return;
  a->surface.core_radius = domain;
  place_nodes(a);
  fill_reach(&a->surface);
}
