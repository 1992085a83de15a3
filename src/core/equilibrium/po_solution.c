#include "po_solution.h"

#include <math.h>
#include <string.h>

#include "po_barycentric.h"
#include "po_elementary.h"
#include "po_initial_gap.h"
#include "po_law.h"
#include "po_root.h"

po_status po_solution_allocate(po_solution *p, size_t capacity, po_arena *arrays) {
  double **const own[] = {&p->state, &p->tangent,    &p->deflection, &p->slope,
                          &p->node,  &p->coordinate, &p->rate};
  for (size_t k = 0; k < sizeof own / sizeof *own; ++k)
    *own[k] = po_arena_reserve(arrays, capacity + 1, sizeof **own[k]);
  p->panels = po_arena_reserve(arrays, 1, sizeof *p->panels);
  p->wanted = po_arena_reserve(arrays, 1, sizeof *p->wanted);
  if (arrays->ran_out)
    return PO_NO_MEMORY;
  p->panels->count = p->wanted->count = 0;
  return PO_OK;
}

void po_solution_copy(const po_solution *from, po_solution *to) {
  double *const own[] = {to->state, to->tangent,    to->deflection, to->slope,
                         to->node,  to->coordinate, to->rate};
  po_panels *const panels = to->panels, *const wanted = to->wanted;
  *to = *from;
  const size_t n = from->n, coordinates = from->coordinates;
  to->state = memcpy(own[0], from->state, (n + 1) * sizeof *to->state);
  to->tangent = memcpy(own[1], from->tangent, (n + 1) * sizeof *to->tangent);
  to->deflection = memcpy(own[2], from->deflection, n * sizeof *to->deflection);
  to->slope = memcpy(own[3], from->slope, n * sizeof *to->slope);
  to->node = memcpy(own[4], from->node, n * sizeof *to->node);
  to->coordinate = memcpy(own[5], from->coordinate, coordinates * sizeof *to->coordinate);
  to->rate = memcpy(own[6], from->rate, coordinates * sizeof *to->rate);
  to->panels = panels;
  to->wanted = wanted;
  po_panels_copy(from->panels, panels);
  po_panels_copy(from->wanted, wanted);
}

void po_solution_exchange(po_solution *a, po_solution *b) {
  const po_solution first = *a;
  *a = *b;
  *b = first;
}

/* Changes the length of the tangent by a factor. */
static void scale_tangent(po_solution *p, double factor) {
  for (size_t j = 0; j <= p->n; ++j)
    p->tangent[j] *= factor;
  for (size_t i = 0; i < p->coordinates; ++i)
    p->rate[i] *= factor;
  for (size_t k = 0; k < p->edges.count; ++k)
    p->edges.rate[k] *= factor;
  p->load_rate *= factor;
}

void po_solution_turn(po_solution *p) {
  scale_tangent(p, -1.0);
}

void po_solution_reweigh(po_solution *p, double factor) {
  p->share *= factor;
  for (size_t i = 0; i < 2; ++i) {
    p->coordinate[i] *= factor;
    p->rate[i] *= factor;
  }
  scale_tangent(p, 1.0 / sqrt(po_solution_cosine(p, p)));
}

double po_solution_approach(const po_solution *p) {
  return p->state[p->n];
}

double po_solution_progress(const po_solution *from, const po_solution *to) {
  double sum = 0.0;
  for (size_t i = 0; i < from->coordinates; ++i)
    sum += from->rate[i] * (to->coordinate[i] - from->coordinate[i]);
  return sum;
}

double po_solution_cosine(const po_solution *a, const po_solution *b) {
  return po_arclength_along(a->coordinates, a->rate, b->rate);
}

/* The derivative of the polynomial through nodal values, at the nodes of the unit interval. */
static void differentiate(const double *value, double *derivative) {
  const po_panel_table *table = po_panel_table_get();
  for (size_t i = 0; i < PO_TABLE_ORDER; ++i) {
    double sum = 0.0;
    for (size_t j = 0; j < PO_TABLE_ORDER; ++j)
      sum += table->derivative[i][j] * (value[j] - value[i]);
    derivative[i] = sum;
  }
}

/* Finds the panel of a radius. Returned: *first, the first node of the panel. */
static po_barycentric find_place(po_solution_field *f, double r, size_t *first) {
  const double x = r / f->p->domain;
  f->panel = po_panels_find(f->p->panels, x, f->panel);
  *first = f->panel * PO_TABLE_ORDER;
  return po_barycentric_at(po_panel_place(f->p->panels->panel[f->panel], x));
}

static void initial_gap_and_slope(const po_scene *scene, double r, double *gap, double *slope) {
  *gap = po_profile_gap(&scene->profile, scene->radius, r);
  *slope = po_profile_slope(&scene->profile, scene->radius, r);
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    const po_wave wave = po_scene_wave(scene, k);
    const double x = r / wave.length, s = po_sinpi(x), c = po_cospi(x); /* sin 2x = 2 s c */
    *gap += 2.0 * wave.amplitude * s * s;
    *slope += 4.0 * M_PI * wave.amplitude / wave.length * s * c;
  }
}

po_solution_value po_solution_value_at(po_solution_field *f, double r) {
  size_t first;
  const po_barycentric at = find_place(f, r, &first);
  po_solution_value v = {0.0, 0.0, po_barycentric_value(&at, f->p->tangent + first)};
  initial_gap_and_slope(f->scene, r, &v.gap, &v.slope);
  v.gap += po_barycentric_value(&at, f->p->deflection + first);
  v.slope += po_barycentric_value(&at, f->p->slope + first);
  return v;
}

double po_solution_gap(void *data, double r) {
  po_solution_field *f = data;
  size_t first;
  const po_barycentric at = find_place(f, r, &first);
  return po_initial_gap(f->scene, r) + po_barycentric_value(&at, f->p->deflection + first);
}

/* The gap less that of the greatest tension, at a radius on the panel. */
static double beyond_peak(double r, const void *data) {
  po_solution_field field = *(const po_solution_field *)data;
  return po_solution_gap(&field, r) - po_law_numbers_of(&field.scene->law)->peak_gap;
}

/* Finds the contact edge between two nodes on the polynomials of the panels. */
static void add_edge(po_solution *p, const po_scene *scene, size_t node) {
  const po_solution_field s = {p, scene, node / PO_TABLE_ORDER};
  const double low = p->node[node - 1], high = p->node[node];
  double at = po_root(beyond_peak, &s, low, high);
  if (isnan(at)) /* one of the nodes is at the edge, but for rounding */
    at = fabs(beyond_peak(low, &s)) < fabs(beyond_peak(high, &s)) ? low : high;
  p->edges.at[p->edges.count] = at;
  p->edges.rate[p->edges.count++] = 0.0;
}

/* Finds the contact edges, beginning with the outermost, since the outermost are kept. */
static void find_edges(po_solution *p, const po_scene *scene) {
  po_moving_edges *edges = &p->edges;
  const double peak = po_law_numbers_of(&scene->law)->peak_gap;
  edges->count = edges->all = 0;
  for (size_t j = p->panels->count * PO_TABLE_ORDER; j-- > 1;) {
    const double left = p->state[j - 1] - peak, right = p->state[j] - peak;
    if ((left < 0.0) == (right < 0.0))
      continue;
    if (edges->count < PO_MOST_MOVING_EDGES)
      add_edge(p, scene, j);
    ++edges->all;
  }
  for (size_t k = 0; 2 * k + 1 < edges->count; ++k) { /* to ascending order */
    const size_t other = edges->count - 1 - k;
    const double at = edges->at[k];
    edges->at[k] = edges->at[other];
    edges->at[other] = at;
  }
}

static void fill_slope(po_solution *p) {
  for (size_t k = 0; k < p->panels->count; ++k) {
    const double size = p->domain * po_panel_size(p->panels->panel[k]);
    differentiate(p->deflection + k * PO_TABLE_ORDER, p->slope + k * PO_TABLE_ORDER);
    for (size_t i = 0; i < PO_TABLE_ORDER; ++i)
      p->slope[k * PO_TABLE_ORDER + i] /= size;
  }
  const size_t tail = p->panels->count * PO_TABLE_ORDER;
  if (tail == 0 || p->n == tail) /* a fixed mesh, or a cut surface */
    return;
  differentiate(p->deflection + tail, p->slope + tail);
  for (size_t j = tail; j < p->n; ++j) { /* by x = domain/r */
    const double x = p->domain / p->node[j];
    p->slope[j] *= -x * x / p->domain;
  }
}

void po_solution_take_state(po_solution *p, const po_equilibrium *e) {
  const po_panels *panels = po_surface_panels(e->surface);
  p->panels->count = 0;
  if (panels)
    po_panels_copy(panels, p->panels);
  p->n = e->n;
  p->core = po_equilibrium_core(e);
  p->domain = e->surface->core_radius;
  p->arclength = panels ? PO_ARCLENGTH_GLOBAL : PO_ARCLENGTH_NODAL;
  p->coordinates = po_arclength_size(p->arclength, p->n);
  p->share = e->share;
  po_arclength_coordinates(p->arclength, e, p->state, p->coordinate);
  p->load = po_equilibrium_load(e);
  p->energy = po_equilibrium_energy(e, p->state);
  memcpy(p->node, e->surface->node, p->n * sizeof *p->node);
  for (size_t j = 0; j < p->n; ++j)
    p->deflection[j] = p->state[j] - e->initial_gap[j];
  fill_slope(p);
  find_edges(p, e->scene);
}

void po_solution_scale_tangent(po_solution *p) {
  scale_tangent(p, 1.0 / sqrt(po_solution_cosine(p, p)));
}

void po_solution_take_tangent(po_solution *p, const po_equilibrium *e) {
  po_arclength_rates(p->arclength, e, p->state, p->tangent, p->rate);
  p->load_rate = 0.0; /* follows from the scaled tangent */
  po_solution_scale_tangent(p);
  p->load_rate = po_equilibrium_load_rate(e, p->tangent);
  po_solution_field field = {p, e->scene, 0};
  for (size_t k = 0; k < p->edges.count; ++k) {
    const po_solution_value v = po_solution_value_at(&field, p->edges.at[k]);
    p->edges.rate[k] = -v.tangent / v.slope;
  }
}

void po_solution_finish(po_solution *p, const po_equilibrium *e) {
  po_solution_take_state(p, e);
  po_solution_take_tangent(p, e);
}

/* The component of a vector of coordinates where approach and load have their whole weight. */
static double unshared(const po_solution *p, size_t i, double component) {
  return i < 2 && p->arclength == PO_ARCLENGTH_GLOBAL ? component / p->share : component;
}

double po_solution_length(const po_solution *p) {
  double square = 0.0;
  for (size_t i = 0; i < p->coordinates; ++i) {
    const double rate = unshared(p, i, p->rate[i]);
    square += rate * rate;
  }
  return sqrt(square);
}

double po_solution_way(const po_solution *from, const po_solution *to) {
  double progress = 0.0, product = 0.0;
  for (size_t i = 0; i < from->coordinates; ++i) {
    const double rate = unshared(from, i, from->rate[i]);
    progress += rate * unshared(from, i, to->coordinate[i] - from->coordinate[i]);
    product += rate * unshared(to, i, to->rate[i]);
  }
  const double length = po_solution_length(from);
  progress /= length;
  const double cosine = fmax(0.0, product / (length * po_solution_length(to)));
  const double sine = cosine < 1.0 ? sqrt((1.0 - cosine) * (1.0 + cosine)) : 0.0;
  return sine > 0.0 ? progress * po_atan2(sine, cosine) / sine : progress;
}
