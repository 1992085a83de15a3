/* The tangent at nodes that scale with the contact, beside the tangent at fixed nodes. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_continuation.h"
#include "po_memory.h"
#include "po_scaled_tangent.h"
#include "po_trace.h"
#include "run.h"

static const double TOLERANCE = 1e-8;

typedef struct {
  po_equilibrium *e;
  po_solution fixed, scaled;
  double *border;
  size_t compared;
  double error; /* allowed, of a rate of order one */
} comparison;

static void is_close(double a, double b, double error) {
  ck_assert_double_lt(fabs(a - b), error);
}

/* Radii of the contact, eps, that are compared: all radii would change fast with a smaller one; a
 * greater one is near the end of the cut surface. */
static const double SMALL = 5.0, LARGE = 30.0;
/* Allowed difference of dH/ds: that of the derivative of the gap at the end of the cut surface. */
static const double AT_NODES = 1e-3;

/* Compares both tangents at a step of the trace with one contact edge. */
static bool compare(const po_branch_point *point, void *data) {
  comparison *c = data;
  const po_solution *p = point->solution;
  po_solution *fixed = &c->fixed, *scaled = &c->scaled;
  if (point->kind != PO_POINT_STEP || p->edges.count != 1 || !(p->edges.at[0] > SMALL))
    return false;
  if (p->n != c->e->n || memcmp(p->node, c->e->surface->node, p->n * sizeof *p->node) != 0)
    return false;
  po_solution_copy(p, fixed);
  po_solution_copy(p, scaled);
  po_equilibrium_evaluate(c->e, scaled->state);
  po_arclength_border(PO_ARCLENGTH_GLOBAL, c->e, scaled->state, p->rate, c->border);
  ck_assert_int_eq(po_equilibrium_factorize(c->e, scaled->state, c->border), PO_OK);
  ck_assert_int_eq(po_equilibrium_tangent(c->e, 1e-12, fixed->tangent), PO_OK);
  po_solution_take_tangent(fixed, c->e);
  ck_assert_int_eq(po_scaled_tangent(c->e, p->rate, 1e-12, scaled), PO_OK);
  const size_t n = fixed->n;
  is_close(scaled->tangent[n], fixed->tangent[n], 10.0 * c->error);
  is_close(scaled->load_rate, fixed->load_rate, c->error);
  is_close(scaled->edges.rate[0], fixed->edges.rate[0], 100.0 * c->error);
  double steepest = 1.0;
  for (size_t j = 0; j < fixed->core; ++j)
    steepest = fmax(steepest, fabs(fixed->tangent[j]));
  for (size_t j = 0; j < fixed->core; ++j)
    is_close(scaled->tangent[j], fixed->tangent[j], AT_NODES * steepest);
  c->e->factorized = false;
  ++c->compared;
  return p->edges.at[0] > LARGE;
}

static void compare_along(const po_scene *scene, double error) {
  po_surface *panels = NULL;
  po_equilibrium *e = NULL;
  po_continuation *continuation = NULL;
  const double domain = po_trace_domain(scene, po_surface_core(scene, NAN));
  ck_assert_int_eq(po_surface_create_panels(scene, domain, 4, &panels), PO_OK);
  const size_t capacity = panels->capacity;
  ck_assert_int_eq(po_equilibrium_create(scene, panels, &e), PO_OK);
  e->precision = po_trace_precision(TOLERANCE);
  comparison c = {.e = e, .error = error, .border = po_reserve(capacity + 1, sizeof(double))};
  ck_assert_ptr_nonnull(c.border);
  po_arena arrays = {0};
  ck_assert_int_eq(po_solution_allocate(&c.fixed, capacity, &arrays), PO_OK);
  ck_assert_int_eq(po_solution_allocate(&c.scaled, capacity, &arrays), PO_OK);
  po_continuation_options options = po_continuation_options_default();
  options.visit = compare;
  options.data = &c;
  ck_assert_int_eq(
      po_continuation_create(e, po_trace_allowance(TOLERANCE), &options, &continuation), PO_OK);
  ck_assert_int_eq(po_continuation_run(continuation), PO_OK);
  ck_assert_uint_gt(c.compared, 5);
  po_continuation_destroy(continuation);
  po_arena_free(&arrays);
  free(c.border);
  po_equilibrium_destroy(e);
  po_surface_destroy(panels);
}

/* At mu = 7 both are accurate. */
TEST(it_is_the_tangent_at_fixed_nodes) {
  const po_scene scene = {
      .tabor = 7.0, .wavelength = 20.0, .radius = 100.0, .outer_radius = INFINITY};
  compare_along(&scene, 1e-6);
}

/* The same on a cut surface. The ring that is added at its end changes the load by 0.03 in the unit
 * of the scale; the gap has an infinite slope there, so that its rate is less accurate. */
TEST(it_is_the_tangent_on_a_cut_surface) {
  const po_scene scene = {.tabor = 7.0, .wavelength = 20.0, .radius = 100.0, .outer_radius = 60.0};
  compare_along(&scene, 1e-4);
}
