/* The mesh of a march: it resolves the traction, as that of a trace, and the history, which keeps
 * features that the contact edge has left. */
#include <math.h>
#include <string.h>

#include "po_barycentric.h"
#include "po_corrector.h"
#include "po_initial_gap.h"
#include "po_law.h"
#include "po_march_internal.h"
#include "po_root.h"

/* Allowed last Legendre coefficients of the history on a panel, relative to the allowed error of
 * the gap. */
static const double OF_HISTORY = 0.03;

void po_march_interpolate(const po_panels *from, size_t from_n, const double *field, size_t count,
                          const po_surface *surface, double *to) {
  const size_t n = surface->n, core = surface->hierarchy->panels.count * PO_TABLE_ORDER;
  const size_t tail = from->count * PO_TABLE_ORDER;
  size_t panel = 0;
  for (size_t j = 0; j < core; ++j) {
    const double x = surface->node[j] / surface->core_radius;
    panel = po_panels_find(from, x, panel);
    const po_barycentric at = po_barycentric_at(po_panel_place(from->panel[panel], x));
    const double *value = field + panel * PO_TABLE_ORDER;
    for (size_t k = 0; k < count; ++k)
      to[k * n + j] = po_barycentric_value(&at, value + k * from_n);
  }
  for (size_t k = 0; k < count; ++k) /* the panel to infinity stays where it is */
    memcpy(to + k * n + core, field + k * from_n + tail, (n - core) * sizeof *to);
}

void po_march_bring(po_march *m) {
  const po_march_state *from = &m->held;
  po_march_state *to = &m->here;
  to->n = m->e->n;
  to->point = from->point;
  to->length = from->length;
  memcpy(to->square, from->square, sizeof to->square);
  const po_panels *panels = po_surface_panels(m->e->surface);
  if (po_panels_equal(panels, from->panels))
    memcpy(to->field, from->field, m->fields * to->n * sizeof *to->field);
  else
    po_march_interpolate(from->panels, from->n, from->field, m->fields, m->e->surface, to->field);
  m->is_here = true;
}

typedef struct {
  const po_march *m;
  size_t panel, held; /* of the last radius, in m->shape_panels and in m->held */
} shape_field;

static double shape_gap(void *data, double r) {
  shape_field *f = data;
  const po_march *m = f->m;
  const double x = r / m->e->surface->core_radius;
  f->panel = po_panels_find(m->shape_panels, x, f->panel);
  const po_barycentric at = po_barycentric_at(po_panel_place(m->shape_panels->panel[f->panel], x));
  return po_initial_gap(m->e->scene, r) +
         po_barycentric_value(&at, m->shape + f->panel * PO_TABLE_ORDER);
}

static double last_coefficients(const double *value) {
  const po_legendre *legendre = &po_panel_table_get()->legendre;
  double last = 0.0;
  for (int k = PO_TABLE_ORDER - PO_LAST_COEFFICIENTS; k < PO_TABLE_ORDER; ++k) {
    double sum = 0.0;
    for (int j = 0; j < PO_TABLE_ORDER; ++j)
      sum += legendre->coefficient[k][j] * value[j];
    last = fmax(last, fabs(sum));
  }
  return last;
}

/* Whether a panel is too long for the history of `held`: the deflections by the traction now, and
 * by its past. */
static bool history_is_coarse(void *data, po_panel panel) {
  shape_field *f = data;
  const po_march *m = f->m;
  const po_march_state *s = &m->held;
  const double *node = po_panel_table_get()->rule.node;
  const double begin = po_panel_begin(panel), size = po_panel_size(panel);
  double instant[PO_TABLE_ORDER], past[PO_TABLE_ORDER];
  for (size_t i = 0; i < PO_TABLE_ORDER; ++i) {
    const double x = begin + size * node[i];
    f->held = po_panels_find(s->panels, x, f->held);
    const po_barycentric at = po_barycentric_at(po_panel_place(s->panels->panel[f->held], x));
    const size_t first = f->held * PO_TABLE_ORDER;
    instant[i] = po_barycentric_value(&at, po_march_field(s, PO_OF_INSTANT) + first);
    past[i] = 0.0;
    for (size_t k = PO_OF_CREEP; k < m->fields; ++k)
      past[i] += po_barycentric_value(&at, po_march_field(s, k) + first);
  }
  return fmax(last_coefficients(past), last_coefficients(instant)) >
         OF_HISTORY * m->resolution.allowed.gap;
}

po_status po_march_remesh(po_march *m) {
  po_equilibrium *e = m->e;
  po_panels *const draft = e->surface->draft;
  po_resolution margin = m->resolution;
  margin.allowed.gap *= PO_MESH_MARGIN;
  margin.allowed.load *= PO_MESH_MARGIN;
  shape_field data = {m, 0, 0};
  po_panels_copy(po_surface_panels(e->surface), draft);
  po_status status = po_resolution_panels(&margin, &(po_gap_field){shape_gap, &data}, draft);
  if (status)
    return status;
  if (!po_panels_refine(draft, PO_MOST_HALVINGS, history_is_coarse, &data))
    return po_resolution_fail(e->scene, draft);
  if (po_panels_equal(draft, po_surface_panels(e->surface)))
    return PO_OK;
  status = po_surface_mesh(e->surface, draft);
  if (status)
    return status;
  const double coupling = e->coupling;
  po_equilibrium_remesh(e);
  e->coupling = coupling;
  ++e->work.meshes;
  memcpy(m->bare, e->initial_gap, e->n * sizeof *m->bare);
  m->is_here = false;
  return PO_OK;
}

typedef struct {
  const po_scene *scene;
  const double *deflection; /* of a panel */
  double begin, size, peak;
} edge_gap;

static double beyond_peak(double r, const void *data) {
  const edge_gap *g = data;
  const po_barycentric at = po_barycentric_at((r - g->begin) / g->size);
  return po_initial_gap(g->scene, r) + po_barycentric_value(&at, g->deflection) - g->peak;
}

double po_march_contact_radius(const po_march *m, const double *gap, const double *deflection) {
  const po_surface *s = m->e->surface;
  const po_panels *panels = po_surface_panels(s);
  const double peak = po_law_numbers_of(&m->e->scene->law)->peak_gap;
  size_t j = panels->count * PO_TABLE_ORDER;
  while (j > 0 && gap[j - 1] >= peak)
    --j;
  if (j == 0 || j == panels->count * PO_TABLE_ORDER)
    return j == 0 ? 0.0 : s->core_radius;
  const size_t k = j / PO_TABLE_ORDER; /* the edge is between the nodes j - 1 and j */
  const po_panel panel = panels->panel[k];
  const edge_gap g = {m->e->scene, deflection + k * PO_TABLE_ORDER,
                      s->core_radius * po_panel_begin(panel), s->core_radius * po_panel_size(panel),
                      peak};
  const double at = po_root(beyond_peak, &g, s->node[j - 1], s->node[j]);
  return isnan(at) ? s->node[j - 1] : at;
}
