#include "po_track_point.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_law.h"
#include "po_memory.h"
#include "po_profile.h"

enum { ORDER = PO_TABLE_ORDER, BISECTIONS = 60 };

po_status po_track_point_allocate(po_track_point *p, size_t capacity) {
  double **const arrays[] = {&p->state, &p->tangent, &p->deflection, &p->slope, &p->node};
  bool had = true;
  for (int k = 0; k < 5; ++k)
    had = (*arrays[k] = po_allocate(capacity + 1, sizeof(double))) && had;
  return had ? PO_OK : PO_NO_MEMORY;
}

void po_track_point_free(po_track_point *p) {
  free(p->state);
  free(p->tangent);
  free(p->deflection);
  free(p->slope);
  free(p->node);
}

void po_track_point_copy(const po_track_point *from, po_track_point *to) {
  po_track_point copy = *from;
  copy.state = memcpy(to->state, from->state, (from->n + 1) * sizeof *to->state);
  copy.tangent = memcpy(to->tangent, from->tangent, (from->n + 1) * sizeof *to->tangent);
  copy.deflection = memcpy(to->deflection, from->deflection, from->n * sizeof *to->deflection);
  copy.slope = memcpy(to->slope, from->slope, from->n * sizeof *to->slope);
  copy.node = memcpy(to->node, from->node, from->n * sizeof *to->node);
  *to = copy;
}

void po_track_point_turn(po_track_point *p) {
  for (size_t j = 0; j <= p->n; ++j)
    p->tangent[j] = -p->tangent[j];
  for (int i = 0; i < PO_ARCLENGTH_SIZE; ++i)
    p->rate[i] = -p->rate[i];
  for (size_t k = 0; k < p->edges.count; ++k)
    p->edges.rate[k] = -p->edges.rate[k];
  p->load_rate = -p->load_rate;
}

double po_track_progress(const po_track_point *from, const po_track_point *to) {
  double change[PO_ARCLENGTH_SIZE];
  for (int i = 0; i < PO_ARCLENGTH_SIZE; ++i)
    change[i] = to->functional[i] - from->functional[i];
  return po_arclength_along(from->rate, change);
}

/* d/dx of the polynomial through nodal values, at the nodes. */
static void differentiate(const po_panel_rule *rule, const double *value, double *derivative) {
  for (size_t i = 0; i < ORDER; ++i) {
    double sum = 0.0;
    for (size_t j = 0; j < ORDER; ++j)
      if (j != i)
        sum += rule->barycentric[j] / rule->barycentric[i] * (value[j] - value[i]) /
               (rule->node[i] - rule->node[j]);
    derivative[i] = sum;
  }
}

po_track_value po_track_value_at(const po_track_point *p, const po_scene *scene, double domain,
                                 double r) {
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  const double x = r / domain;
  const size_t k = po_panels_find(&p->panels, x);
  const double begin = po_panel_begin(p->panels.panel[k]), size = po_panel_size(p->panels.panel[k]);
  double weight[ORDER];
  po_lagrange(ORDER, rule->node, rule->barycentric, (x - begin) / size, weight);
  po_track_value v = {po_profile(scene, r), po_profile_slope(scene, r), 0.0};
  for (size_t j = 0; j < ORDER; ++j) {
    v.gap += weight[j] * p->deflection[k * ORDER + j];
    v.slope += weight[j] * p->slope[k * ORDER + j];
    v.tangent += weight[j] * p->tangent[k * ORDER + j];
  }
  return v;
}

/* The contact edge between two radii, by bisection on the panels' polynomials. */
static void add_edge(po_track_point *p, const po_scene *scene, double domain, double low,
                     double high) {
  const double side = po_track_value_at(p, scene, domain, low).gap - PO_LAW_PEAK_GAP;
  for (int k = 0; k < BISECTIONS && high - low > 1e-14 * high; ++k) {
    const double middle = 0.5 * (low + high);
    const double here = po_track_value_at(p, scene, domain, middle).gap - PO_LAW_PEAK_GAP;
    if ((here < 0.0) == (side < 0.0))
      low = middle;
    else
      high = middle;
  }
  const po_track_value v = po_track_value_at(p, scene, domain, low);
  p->edges.at[p->edges.count] = low;
  p->edges.rate[p->edges.count] = -v.tangent / v.slope;
  ++p->edges.count;
}

/* From the outside inwards: the outermost edges are those that move. */
static void find_edges(po_track_point *p, const po_scene *scene, const po_surface *s) {
  po_moving_edges *edges = &p->edges;
  edges->count = edges->all = 0;
  for (size_t j = p->panels.count * ORDER; --j > 0;) {
    const double left = p->state[j - 1] - PO_LAW_PEAK_GAP, right = p->state[j] - PO_LAW_PEAK_GAP;
    if ((left < 0.0) == (right < 0.0))
      continue;
    if (edges->count < PO_MOST_MOVING_EDGES)
      add_edge(p, scene, s->core_radius, s->node[j - 1], s->node[j]);
    ++edges->all;
  }
  for (size_t k = 0; 2 * k + 1 < edges->count; ++k) { /* ascending */
    const size_t other = edges->count - 1 - k;
    const double at = edges->at[k], rate = edges->rate[k];
    edges->at[k] = edges->at[other];
    edges->rate[k] = edges->rate[other];
    edges->at[other] = at;
    edges->rate[other] = rate;
  }
}

void po_track_point_finish(po_track_point *p, const po_equilibrium *e,
                           const po_adaptive *adaptive) {
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  p->panels = *po_adaptive_panels(adaptive);
  p->n = e->n;
  po_arclength_values(e, p->state, p->functional);
  po_arclength_rates(e, p->state, p->tangent, p->rate);
  const double length = sqrt(po_arclength_along(p->rate, p->rate));
  for (int i = 0; i < PO_ARCLENGTH_SIZE; ++i)
    p->rate[i] /= length;
  for (size_t j = 0; j <= p->n; ++j)
    p->tangent[j] /= length;
  p->load = po_equilibrium_load(e);
  p->load_rate = po_equilibrium_load_rate(e, p->tangent);
  p->energy = po_equilibrium_energy(e, p->state);
  memcpy(p->node, e->surface->node, p->n * sizeof *p->node);
  for (size_t j = 0; j < p->n; ++j)
    p->deflection[j] = p->state[j] - e->shape[j];
  const double domain = e->surface->core_radius;
  for (size_t k = 0; k < p->panels.count; ++k) {
    const double size = domain * po_panel_size(p->panels.panel[k]);
    differentiate(rule, p->deflection + k * ORDER, p->slope + k * ORDER);
    for (size_t i = 0; i < ORDER; ++i)
      p->slope[k * ORDER + i] /= size;
  }
  find_edges(p, e->scene, e->surface);
}

double po_track_gap(void *data, double r) {
  const po_track_field *f = data;
  return po_track_value_at(f->p, f->scene, f->domain, r).gap;
}

double po_track_way(const po_track_point *from, const po_track_point *to) {
  const double progress = po_track_progress(from, to);
  const double cosine = fmax(0.0, po_arclength_along(from->rate, to->rate));
  const double turn = cosine < 1.0 ? acos(cosine) : 0.0;
  return turn > 0.0 ? progress * turn / sin(turn) : progress;
}

po_sample po_track_sample(const po_track_point *from, const po_track_point *p) {
  const double per_distance = 1.0 / po_arclength_along(from->rate, p->rate);
  return (po_sample){.at = po_track_progress(from, p),
                     .edges = p->edges.all,
                     .value = {p->state[p->n], p->load},
                     .rate = {p->tangent[p->n] * per_distance, p->load_rate * per_distance}};
}
