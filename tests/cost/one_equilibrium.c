#include "one_equilibrium.h"

#include <stdlib.h>
#include <string.h>

#include "machine.h"
#include "po_memory.h"
#include "po_surface.h"

/* eps: that of a trace between two points */
static const double STEP = 1e-3;

typedef struct {
  po_equilibrium *e;
  const double *solution;     /* n + 1 */
  double *state, *border, *x; /* n + 1: work; the border is that of a given approach */
  size_t iterations;
  po_status status;
} measured;

/* One equilibrium at another approach. */
static void solve(void *data) {
  measured *m = data;
  po_equilibrium *e = m->e;
  const size_t before = e->work.newton_iterations;
  memcpy(m->state, m->solution, (e->n + 1) * sizeof *m->state);
  po_status status = po_equilibrium_factorize(e, m->state, m->border);
  if (!status)
    status = po_equilibrium_correct(e, m->state, m->solution, STEP);
  if (!status)
    status = po_equilibrium_tangent(e, 1e-6, m->x);
  m->iterations = e->work.newton_iterations - before;
  if (status)
    m->status = status;
}

static void multiply(void *data) {
  measured *m = data;
  po_surface_apply(m->e->surface, m->solution, m->x);
}
static void factorize(void *data) {
  measured *m = data;
  if (po_equilibrium_factorize(m->e, m->solution, m->border))
    m->status = PO_SINGULAR;
}
static void precondition(void *data) {
  measured *m = data;
  po_equilibrium_precondition(m->e, m->solution, m->x);
}

static po_status measure(measured *m, way_cost *cost) {
  cost->seconds = median_time(solve, m);
  cost->iterations = m->iterations;
  cost->active = m->e->active;
  cost->product = (timed){operations_of_product(m->e), median_time(multiply, m)};
  cost->factors = (timed){operations_of_factors(m->e), median_time(factorize, m)};
  cost->solve = (timed){operations_of_solve(m->e), median_time(precondition, m)};
  return m->status;
}

/* Both ways, for a state on a surface. */
static po_status measure_both(const po_scene *scene, po_surface *surface, size_t most_dense,
                              measured *m, equilibrium_cost *cost) {
  const size_t n = cost->nodes = surface->n;
  po_status status = po_equilibrium_create(scene, surface, &m->e);
  if (!status)
    status = measure(m, &cost->hierarchical);
  po_equilibrium_destroy(m->e);
  m->e = NULL;
  cost->has_dense = !status && n <= most_dense;
  if (!cost->has_dense)
    return status;
  po_surface dense = *surface;
  dense.hierarchy = NULL;
  dense.influence = po_reserve(n * n, sizeof *dense.influence);
  if (!dense.influence)
    return PO_NO_MEMORY;
  po_surface_fill_matrix(surface, dense.influence);
  status = po_equilibrium_create(scene, &dense, &m->e);
  if (!status)
    status = measure(m, &cost->dense);
  po_equilibrium_destroy(m->e);
  free(dense.influence);
  return status;
}

po_status equilibrium_measure(const po_scene *scene, const po_result *solved, size_t most_dense,
                              equilibrium_cost *cost) {
  const size_t n = solved->profile_count;
  po_surface *surface = NULL;
  double *node = po_allocate(n, sizeof *node), *solution = po_allocate(n + 1, sizeof *solution);
  measured m = {.solution = solution,
                .state = po_allocate(n + 1, sizeof *m.state),
                .border = po_allocate(n + 1, sizeof *m.border),
                .x = po_allocate(n + 1, sizeof *m.x)};
  po_status status = PO_NO_MEMORY;
  if (node && solution && m.state && m.border && m.x)
    status = po_surface_create_panels(scene, scene->outer_radius, 1, &surface);
  if (!status) {
    for (size_t j = 0; j < n; ++j) {
      node[j] = solved->profile[j].radius;
      solution[j] = solved->profile[j].gap;
    }
    solution[n] = solved->profile_approach;
    m.border[n] = 1.0;
    status = po_surface_panels_of(surface, n, node, surface->draft);
  }
  if (!status)
    status = po_surface_mesh(surface, surface->draft);
  if (!status)
    status = measure_both(scene, surface, most_dense, &m, cost);
  po_surface_destroy(surface);
  free(node);
  free(solution);
  free(m.state);
  free(m.border);
  free(m.x);
  return status;
}
