#include "po_surface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_element.h"
#include "po_elementary.h"
#include "po_initial_gap.h"
#include "po_kernel.h"
#include "po_linear.h"
#include "po_panel.h"
#include "po_scales.h"

/* Nodes of a panel on one wavelength, and of the panel that reaches to infinity. */
enum { WAVE_ORDER = PO_TABLE_ORDER, TAIL_ORDER = PO_TABLE_ORDER };

/* Limits of the number of nodes: the largest core and 64 wavelengths give an influence matrix of 90
 * MB; without a matrix the limit corresponds to about 10 MB. */
static const double MOST_NODES = 3300, MOST_RIGID_NODES = 3e5;

/* The longest element, relative to the wavelength: with fewer than two elements in a wavelength the
 * mesh represents a different waviness (aliasing). */
static const double LONGEST_ELEMENT = 0.5;

/* The nodes of a graded mesh are at r_max sinh(GRADING x)/sinh(GRADING) with x equally spaced: the
 * elements at the axis are 0.3 times, those at the edge three times as long as uniform ones. */
static const double GRADING = 3.0;

/* Beyond the core the bodies must be well apart (an initial gap of at least the reach of the law)
 * up to the deepest approach. Pull-off happens at contact radii below the JKR contact radius at
 * zero load. */
double po_surface_core(const po_scene *scene, double deepest) {
  if (isfinite(scene->outer_radius))
    return scene->outer_radius;
  const double gap = po_scene_reach(scene) + 2.0 * po_scene_scales(scene).contact_gap +
                     fmax(isnan(deepest) ? 0.0 : deepest, 0.0);
  return po_initial_gap_radius(scene, gap);
}

/* Counts the wavelengths beyond the core that must be resolved because averaging is not yet
 * accurate, each by a panel of the length returned. Status: PO_OUT_OF_NODES if there are too many,
 * or if the mesh of the core does not resolve the waviness. */
static po_status count_waves(const po_scene *scene, const po_mesh *mesh, double core_radius,
                             bool elastic, size_t *waves, double *length) {
  *waves = 0;
  *length = scene->wavelength;
  if (!po_scene_is_wavy(scene))
    return PO_OK;
  const double element = core_radius / (double)mesh->nodes;
  const double shortest = po_initial_gap_detail(scene);
  if (elastic && element > LONGEST_ELEMENT * shortest)
    return po_fail(PO_OUT_OF_NODES,
                   "elements of length %g cannot represent waves of length %g; expected at least "
                   "%.0f nodes, a longer wavelength or scheme panel",
                   element, shortest, ceil(core_radius / shortest / LONGEST_ELEMENT));
  if (isfinite(scene->outer_radius))
    return PO_OK;
  const double end = po_averaging_radius(scene, core_radius);
  const double count = po_scene_waves(scene) > 1 ? ceil((end - core_radius) / shortest)
                                                 : round((end - core_radius) / shortest);
  const double nodes = (double)mesh->nodes + WAVE_ORDER * count + TAIL_ORDER;
  const double most = elastic ? MOST_NODES : MOST_RIGID_NODES;
  if (!(nodes <= most))
    return po_fail(PO_OUT_OF_NODES,
                   "%.0f waves beyond radius %g must be resolved, with %d nodes each: %.0f nodes, "
                   "more than %.0f; expected an outer radius, fewer nodes, a longer wavelength or "
                   "scheme panel",
                   count, core_radius, WAVE_ORDER, nodes, most);
  *waves = (size_t)count;
  if (po_scene_waves(scene) > 1 && count > 0.0)
    *length = (end - core_radius) / count;
  return PO_OK;
}

/* The plan of a surface: `core` nodes of the scheme, then `waves` panels of one wavelength, then a
 * panel to infinity. */
typedef struct {
  po_mesh mesh;
  double core_radius, wavelength, decay;
  size_t core, waves;
  bool bounded;
  double *edge; /* core + 1 ring edges, or core triangle nodes */
} surface_plan;

static po_status make_plan(const po_scene *scene, const po_mesh *mesh, double core_radius,
                           bool elastic, surface_plan *p) {
  p->mesh = *mesh;
  p->bounded = isfinite(scene->outer_radius);
  p->core_radius = p->bounded ? scene->outer_radius : po_averaging_phase(scene, core_radius);
  p->decay = po_panel_decay(scene);
  p->core = mesh->nodes;
  const po_status status =
      count_waves(scene, mesh, p->core_radius, elastic, &p->waves, &p->wavelength);
  if (status)
    return status;
  p->edge = po_allocate(mesh->nodes + 1, sizeof *p->edge);
  if (!p->edge)
    return PO_NO_MEMORY;
  const size_t elements = mesh->scheme == PO_RING ? mesh->nodes : mesh->nodes - 1;
  for (size_t j = 0; j <= elements; ++j) {
    const double x = (double)j / (double)elements;
    p->edge[j] =
        p->core_radius * (mesh->grading == PO_GRADED ? po_sinh(GRADING * x) / po_sinh(GRADING) : x);
  }
  return PO_OK;
}

static po_panel_span wave_panel(const surface_plan *p, size_t wave) {
  const double begin = p->core_radius + (double)wave * p->wavelength;
  return (po_panel_span){.begin = begin, .end = begin + p->wavelength};
}

static po_panel_span tail_panel(const surface_plan *p) {
  return (po_panel_span){p->core_radius + (double)p->waves * p->wavelength, INFINITY, p->decay};
}

/* The load weight of each ring, the integral of r dr: (c2^2 - c1^2)/2. */
static void ring_weights(size_t n, const double *edge, double *weight) {
  for (size_t j = 0; j < n; ++j)
    weight[j] = 0.5 * (edge[j + 1] - edge[j]) * (edge[j + 1] + edge[j]);
}

/* The load weight of each triangle: the integral of its traction, p_j = 1, times r dr. */
static void triangle_weights(size_t n, const double *node, double *weight) {
  for (size_t j = 0; j < n; ++j)
    weight[j] = 0.0;
  for (size_t e = 0; e + 1 < n; ++e) {
    const double a = node[e], length = node[e + 1] - a;
    weight[e] += length * (a / 2.0 + length / 6.0);
    weight[e + 1] += length * (a / 2.0 + length / 3.0);
  }
}

static void place_core(const surface_plan *p, po_surface *s) {
  if (p->mesh.scheme == PO_RING) {
    ring_weights(p->core, p->edge, s->weight);
    for (size_t j = 0; j < p->core; ++j) {
      s->node[j] = 0.5 * (p->edge[j] + p->edge[j + 1]);
      s->length[j] = p->edge[j + 1] - p->edge[j];
    }
    return;
  }
  triangle_weights(p->core, p->edge, s->weight);
  for (size_t j = 0; j < p->core; ++j) {
    const double left = j ? p->edge[j - 1] : p->edge[j];
    const double right = j + 1 < p->core ? p->edge[j + 1] : p->edge[j];
    s->node[j] = p->edge[j];
    s->length[j] = 0.5 * (right - left);
  }
}

static po_surface *allocate_surface(size_t n, bool elastic) {
  po_surface *s = po_allocate(1, sizeof *s);
  if (!s)
    return NULL;
  s->n = s->capacity = n;
  s->node = po_arena_allocate(&s->arrays, n, sizeof *s->node);
  s->weight = po_arena_allocate(&s->arrays, n, sizeof *s->weight);
  s->length = po_arena_allocate(&s->arrays, n, sizeof *s->length);
  s->influence = elastic ? po_arena_allocate(&s->arrays, n * n, sizeof *s->influence) : NULL;
  s->reach = elastic ? po_arena_allocate(&s->arrays, n, sizeof *s->reach) : NULL;
  if (!s->arrays.ran_out)
    return s;
  po_surface_destroy(s);
  return NULL;
}

/* Sets the largest modulus of each column. */
static void find_reach(po_surface *s) {
  for (size_t j = 0; j < s->n; ++j) {
    double largest = 0.0;
    for (size_t i = 0; i < s->n; ++i) {
      const double size = fabs(s->influence[i + s->n * j]);
      largest = size > largest ? size : largest; /* a call of fmax costs ten times as much */
    }
    s->reach[j] = largest;
  }
}

void po_surface_apply(const po_surface *s, const double *x, double *y) {
  if (!s->hierarchy) {
    po_linear_apply(s->n, s->n, s->influence, s->n, x, y);
    return;
  }
  po_hierarchy_apply(s->hierarchy, x, y);
  for (size_t i = 0; i < s->n; ++i)
    y[i] *= s->core_radius;
}

void po_surface_apply_transposed(const po_surface *s, const double *x, double *y) {
  if (!s->hierarchy) {
    po_linear_apply_transposed(s->n, s->n, s->influence, s->n, x, y);
    return;
  }
  po_hierarchy_apply_transposed(s->hierarchy, x, y);
  for (size_t i = 0; i < s->n; ++i)
    y[i] *= s->core_radius;
}

void po_surface_fill_matrix(const po_surface *s, double *matrix) {
  if (s->hierarchy)
    po_hierarchy_fill_matrix(s->hierarchy, s->core_radius, matrix);
  else
    memcpy(matrix, s->influence, s->n * s->n * sizeof *matrix);
}

uint64_t po_ring_influence(size_t n, const double *edge, double r, double *row, size_t stride) {
  double inner = po_disc_deflection(edge[0], r);
  for (size_t j = 0; j < n; ++j) {
    const double outer = po_disc_deflection(edge[j + 1], r);
    row[j * stride] = 4.0 / M_PI * (outer - inner); /* Eq A4 */
    inner = outer;
  }
  return n + 1;
}

static po_status fill_influence(const surface_plan *p, const po_panel_rule *wave,
                                const po_panel_rule *tail, po_surface *s) {
  po_triangle *triangle = NULL;
  if (p->mesh.scheme == PO_TRIANGLE) {
    const po_status status = po_triangle_create(p->core, p->edge, &triangle);
    if (status)
      return status;
  }
  for (size_t i = 0; i < s->n; ++i) {
    const double r = s->node[i];
    double *row = s->influence + i;
    s->kernel_evaluations += triangle ? po_triangle_influence(triangle, r, row, s->n)
                                      : po_ring_influence(p->core, p->edge, r, row, s->n);
    size_t j = p->core;
    for (size_t w = 0; w < p->waves; ++w, j += WAVE_ORDER)
      s->kernel_evaluations += po_panel_influence(wave, wave_panel(p, w), r, row + j * s->n, s->n);
    if (!p->bounded)
      s->kernel_evaluations += po_panel_influence(tail, tail_panel(p), r, row + j * s->n, s->n);
  }
  po_triangle_destroy(triangle);
  find_reach(s);
  return PO_OK;
}

po_status po_surface_create(const po_scene *scene, const po_mesh *mesh, double core_radius,
                            bool elastic, po_surface **surface) {
  po_panel_rule wave, tail;
  surface_plan p = {.edge = NULL};
  po_surface *s = NULL;
  po_status status = po_scene_check(scene);
  if (!status)
    status = po_mesh_check(mesh);
  if (!status)
    status = make_plan(scene, mesh, core_radius, elastic, &p);
  if (!status)
    status = po_panel_rule_fill(WAVE_ORDER, &wave);
  if (!status)
    status = po_panel_rule_fill(TAIL_ORDER, &tail);
  if (!status && !po_panel_table_get()) /* which energies of the far field need */
    status = PO_NO_MEMORY;
  if (status)
    goto done;
  s = allocate_surface(p.core + p.waves * WAVE_ORDER + (p.bounded ? 0 : TAIL_ORDER), elastic);
  if (!s) {
    status = PO_NO_MEMORY;
    goto done;
  }
  s->core_radius = p.core_radius;
  place_core(&p, s);
  size_t j = p.core;
  for (size_t w = 0; w < p.waves; ++w, j += WAVE_ORDER)
    po_panel_nodes(&wave, wave_panel(&p, w), s->node + j, s->weight + j, s->length + j);
  s->resolved = p.bounded || !po_scene_is_wavy(scene) ? s->n : j;
  if (!p.bounded)
    po_panel_nodes(&tail, tail_panel(&p), s->node + j, s->weight + j, s->length + j);
  s->tail = s->n - j;
  s->tail_begin = tail_panel(&p).begin;
  status = elastic ? fill_influence(&p, &wave, &tail, s) : PO_OK;
done:
  free(p.edge);
  if (status) {
    po_surface_destroy(s);
    s = NULL;
  }
  *surface = s;
  return status;
}

void po_surface_destroy(po_surface *surface) {
  if (!surface)
    return;
  po_hierarchy_destroy(surface->hierarchy);
  po_arena_free(&surface->arrays);
  free(surface);
}
