/* Surfaces of panels. */
#include <float.h>
#include <math.h>

#include "po_elementary.h"
#include "po_panel.h"
#include "po_surface.h"

/* Panels for which a surface has room: of any scene, and more for each wave on the domain. */
static const double ROOM = 4096.0, ROOM_A_WAVE = 8.0;

static size_t room_of(const po_scene *scene, double domain) {
  double room = ROOM;
  for (size_t k = 0; k < po_scene_waves(scene); ++k)
    room += ROOM_A_WAVE * domain / po_scene_wave(scene, k).length;
  return (size_t)fmin(room, PO_MOST_PANELS);
}

po_status po_surface_create_panels(const po_scene *scene, double domain, uint32_t level,
                                   po_surface **surface) {
  po_surface *s = *surface = po_allocate(1, sizeof *s);
  if (!s)
    return PO_NO_MEMORY;
  const po_panel_table *table = po_panel_table_get();
  s->wavy = po_scene_is_wavy(scene);
  s->capacity = (room_of(scene, domain) + 1) * PO_TABLE_ORDER;
  s->core_radius = domain;
  s->node = po_arena_reserve(&s->arrays, s->capacity, sizeof *s->node);
  s->weight = po_arena_reserve(&s->arrays, s->capacity, sizeof *s->weight);
  s->length = po_arena_reserve(&s->arrays, s->capacity, sizeof *s->length);
  s->reach = po_arena_reserve(&s->arrays, s->capacity, sizeof *s->reach);
  s->draft = po_arena_reserve(&s->arrays, 1, sizeof *s->draft);
  po_status status = PO_NO_MEMORY;
  if (table && !s->arrays.ran_out)
    status = po_hierarchy_create(table, isinf(scene->outer_radius), po_panel_decay(scene),
                                 &s->hierarchy);
  if (!status) {
    po_panels_uniform(s->draft, level);
    status = po_surface_mesh(s, s->draft);
  }
  if (status) {
    po_surface_destroy(s);
    *surface = NULL;
  }
  return status;
}

static size_t most_panels(const po_surface *s) {
  return s->capacity / PO_TABLE_ORDER - 1;
}

/* Returned: whether `node` are the nodes of a panel to rounding. */
static bool has_nodes(const po_surface *s, po_panel panel, const double *node) {
  const double domain = s->core_radius;
  const double begin = domain * po_panel_begin(panel), size = domain * po_panel_size(panel);
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j)
    if (!(fabs(begin + size * po_panel_table_get()->rule.node[j] - node[j]) <
          1e-9 * size + 4.0 * DBL_EPSILON * domain))
      return false;
  return true;
}

po_status po_surface_panels_of(const po_surface *s, size_t n, const double *node,
                               po_panels *panels) {
  const double *x = po_panel_table_get()->rule.node, domain = s->core_radius;
  const size_t most = most_panels(s);
  panels->count = 0;
  for (size_t j = 0; j + PO_TABLE_ORDER <= n && panels->count < most; j += PO_TABLE_ORDER) {
    const double size = (node[j + PO_TABLE_ORDER - 1] - node[j]) / (x[PO_TABLE_ORDER - 1] - x[0]);
    const uint32_t level = (uint32_t)lround(po_log(domain / size) / M_LN2);
    const double begin = ldexp(node[j] / domain, (int)level) - x[0];
    const po_panel panel = {level, (uint64_t)llround(begin)};
    if (!has_nodes(s, panel, node + j))
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

static void place_nodes(po_surface *s) {
  s->n = po_hierarchy_nodes(s->hierarchy);
  s->tail = s->hierarchy->unbounded ? PO_TABLE_ORDER : 0;
  s->tail_begin = s->core_radius;
  s->resolved = s->wavy ? s->n - s->tail : s->n;
  for (size_t j = 0; j < s->n; j += PO_TABLE_ORDER)
    po_panel_nodes(&s->hierarchy->table->rule, span_of(s, j / PO_TABLE_ORDER), s->node + j,
                   s->weight + j, s->length + j);
  po_hierarchy_reach(s->hierarchy, s->reach);
  for (size_t j = 0; j < s->n; ++j) /* in eps */
    s->reach[j] *= s->core_radius;
}

po_status po_surface_mesh(po_surface *s, const po_panels *panels) {
  if (panels->count > most_panels(s))
    return po_fail(PO_OUT_OF_NODES, "the traction needs %zu panels, more than %zu", panels->count,
                   most_panels(s));
  const po_status status = po_hierarchy_mesh(s->hierarchy, panels);
  if (status)
    return status;
  place_nodes(s);
  s->kernel_evaluations = s->hierarchy->evaluations;
  return PO_OK;
}

/* Nodes and influence coefficients scale with the domain, weights with its square. */
void po_surface_resize(po_surface *s, double domain) {
  if (domain == s->core_radius)
    return;
  s->core_radius = domain;
  place_nodes(s);
}
