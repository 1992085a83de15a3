/* Traces on which the factors of panels are too inaccurate in some directions, and have to be
 * corrected (po_corrector.c), or replaced by GMRES (po_krylov.h). */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_continuation.h"
#include "po_initial_gap.h"
#include "po_input.h"
#include "po_krylov.h"
#include "po_linear.h"
#include "po_load_unit.h"
#include "po_memory.h"
#include "po_scales.h"
#include "po_solve.h"
#include "po_trace.h"
#include "run.h"

static const double TOLERANCE = 1e-6;

/* Arclength at which the trace ends. Without the correction it stays at 2.0067, where the
 * determinant of the factors changes its sign and that of the Jacobian does not. */
static const double END = 2.5;

static bool is_beyond(const po_branch_point *p, void *data) {
  *(double *)data = p->position;
  return p->position > END;
}

/* Two narrow rings of tension on a truncated sphere move nearly freely. */
TEST(a_ring_of_tension_that_moves_freely_is_followed) {
  po_request request = po_request_default();
  ck_assert(po_key_set(&request, PO_KEY_LAW, "morse:4.35609"));
  ck_assert(po_key_set(&request, PO_KEY_PROFILE, "truncated:39.439,37.8845"));
  ck_assert(po_key_set(&request, PO_KEY_COUPLING, "1.20057"));
  ck_assert(
      po_key_set(&request, PO_KEY_WAVES, "0.805184@33.7833;0.193323@5.85164;0.0503183@14.8622"));
  request = po_load_unit_request(&request);
  /* po_trace_domain moves the end of the domain a little, to have the kink of the profile at the
   * end of a panel, and the factors serve */
  const double core = po_surface_core(&request.scene, NAN);
  const double domain =
      po_averaging_radius(&request.scene, po_averaging_phase(&request.scene, core));
  po_surface *panels = NULL;
  po_equilibrium *e = NULL;
  po_continuation *continuation = NULL;
  ck_assert_int_eq(po_surface_create_panels(&request.scene, domain, 4, &panels), PO_OK);
  ck_assert_int_eq(po_equilibrium_create(&request.scene, panels, &e), PO_OK);
  e->precision = po_trace_precision(TOLERANCE);
  double position = 0.0;
  po_continuation_options options = po_continuation_options_default();
  options.visit = is_beyond;
  options.data = &position;
  options.most_points = 1000;
  ck_assert_int_eq(
      po_continuation_create(e, po_trace_allowance(TOLERANCE), &options, &continuation), PO_OK);
  ck_assert_int_eq(po_continuation_run(continuation), PO_OK);
  ck_assert_double_gt(position, END);
  po_continuation_destroy(continuation);
  po_equilibrium_destroy(e);
  po_surface_destroy(panels);
}

/* Approaches at which the trace has contact on the second crest, and at which it ends. */
static const double BEFORE = 180.0, PAST = 170.0;

typedef struct {
  po_equilibrium *e;
  bool has_annulus; /* there was contact on the second crest at `BEFORE` */
  bool compared;
} annulus;

/* The solution of the bordered Jacobian, as a dense matrix, for the border as the last row; and the
 * sign of its determinant. */
static int solve_dense(po_equilibrium *e, double *x) {
  const size_t size = e->n + 1;
  double *matrix = po_reserve(size * size, sizeof *matrix), *unit = po_allocate(size, sizeof *unit);
  int *pivots = po_allocate(size, sizeof *pivots);
  ck_assert(matrix && unit && pivots);
  for (size_t j = 0; j < size; ++j) {
    unit[j] = 1.0;
    po_equilibrium_multiply(e, unit, matrix + size * j);
    unit[j] = 0.0;
  }
  ck_assert_int_eq(po_linear_factorize(size, matrix, size, pivots), PO_OK);
  int sign = 1;
  for (size_t j = 0; j < size; ++j)
    if ((pivots[j] != (int)j + 1) != (matrix[j + size * j] < 0.0))
      sign = -sign;
  unit[e->n] = 1.0;
  po_linear_solve(size, matrix, size, pivots, unit);
  for (size_t j = 0; j < size; ++j)
    x[j] = unit[j];
  free(matrix);
  free(unit);
  free(pivots);
  return sign;
}

/* Compares GMRES with the dense matrix at a state of the branch, with new factors. */
static void compare(po_equilibrium *e, const po_solution *p) {
  const size_t n = e->n;
  double *border = po_allocate(n + 1, sizeof *border), *dense = po_allocate(n + 1, sizeof *dense);
  double *x = po_allocate(n + 1, sizeof *x), *right = po_allocate(n + 1, sizeof *right);
  ck_assert(border && dense && x && right);
  po_equilibrium_evaluate(e, p->state);
  po_arclength_border(p->arclength, e, p->state, p->rate, border);
  ck_assert_int_eq(po_equilibrium_factorize(e, p->state, border), PO_OK);
  right[n] = 1.0;
  ck_assert_int_eq(po_krylov_solve(e, right, 1e-12, x), PO_OK);
  ck_assert_int_eq(e->orientation * e->secant.sign, solve_dense(e, dense));
  double worst = 0.0, largest = 0.0;
  for (size_t j = 0; j <= n; ++j) {
    worst = fmax(worst, fabs(x[j] - dense[j]));
    largest = fmax(largest, fabs(dense[j]));
  }
  ck_assert_double_lt(worst, 1e-7 * largest);
  free(border);
  free(dense);
  free(x);
  free(right);
}

static bool is_past_annulus(const po_branch_point *p, void *data) {
  annulus *a = data;
  const bool step = p->kind == PO_POINT_STEP && p->solution;
  a->has_annulus =
      a->has_annulus || (step && p->approach < BEFORE && p->solution->edges.count == 3);
  if (step && a->has_annulus && !a->compared && p->solution->n == a->e->n &&
      memcmp(p->node, a->e->surface->node, p->n * sizeof *p->node) == 0) {
    compare(a->e, p->solution);
    a->compared = true;
    a->e->factorized = false;
  }
  return step && a->has_annulus && p->approach < PAST;
}

/* Traces a sphere with one wave, as a solve with a tolerance of 1e-4 does, until the visitor ends
 * the trace. Given: tabor, amplitude, wavelength, radius; data of the visitor, which begins with
 * the equilibrium. Returned: the Newton iterations. */
static uint64_t trace_sphere(const double number[4], po_branch_visit visit, void *data) {
  const po_scene scene = {.tabor = number[0],
                          .amplitude = number[1],
                          .wavelength = number[2],
                          .radius = number[3],
                          .outer_radius = INFINITY};
  const double tolerance = 1e-4;
  po_surface *panels = NULL;
  po_equilibrium *e = NULL;
  po_continuation *continuation = NULL;
  const double domain = po_trace_domain(&scene, po_surface_core(&scene, NAN));
  ck_assert_int_eq(po_surface_create_panels(&scene, domain, 4, &panels), PO_OK);
  ck_assert_int_eq(po_equilibrium_create(&scene, panels, &e), PO_OK);
  e->precision = po_trace_precision(tolerance);
  *(po_equilibrium **)data = e;
  po_continuation_options options = po_continuation_options_default();
  options.visit = visit;
  options.data = data;
  options.most_points = 1000;
  ck_assert_int_eq(
      po_continuation_create(e, po_trace_allowance(tolerance), &options, &continuation), PO_OK);
  ck_assert_int_eq(po_continuation_run(continuation), PO_OK);
  const uint64_t iterations = e->work.newton_iterations;
  po_continuation_destroy(continuation);
  po_equilibrium_destroy(e);
  po_surface_destroy(panels);
  return iterations;
}

/* A wavy sphere of R/eps = 4e5 opens the groove between the contact on the axis and that on the
 * second crest, which is an annulus of radius 14,650 and width 150 eps then, and 200 times as wide
 * as its edges. It moves nearly freely: the Jacobian has a singular value of 8e-4, the factors of
 * 8e-3. Newton's method contracted by 1.5 % an iteration, and the trace ended at approach 173.8. */
TEST(a_narrow_annulus_of_contact_is_followed) {
  annulus seen = {0};
  trace_sphere((double[]){94.74, 146.66666666666669, 16666.666666666668, 416666.666666667},
               is_past_annulus, &seen);
  ck_assert(seen.compared);
}

/* Whether the trace is past approach -120 in contact. `data` is unused. */
static bool is_past_neck(const po_branch_point *p, void *data) {
  (void)data;
  return p->kind == PO_POINT_STEP && p->solution && p->solution->edges.count > 0 &&
         p->approach < -120.0;
}

/* Near a maximum of the load, the deepening neck changes the load by less per step than the error
 * of a solution. Each step was halved down to 2^-14 of its length in search of extrema: 38,753
 * Newton iterations to approach -109; some 2,000 without. */
TEST(extrema_below_the_error_of_solutions_are_not_sought) {
  po_equilibrium *e = NULL;
  ck_assert_uint_lt(
      trace_sphere((double[]){3800.48993, 2977.62351, 106540.669, 9497957.82}, is_past_neck, &e),
      6000);
}

/* An annulus that has just formed moves freely where the edges are not yet narrow: steps had become
 * as short as 1e-9 at approach -34.8341, and the solve failed. */
TEST(a_new_annulus_between_wider_edges_is_followed) {
  po_request request = po_request_default();
  request.scene.tabor = 24.6766;
  request.scene.radius = 1191.95;
  request.scene.amplitude = 33.9104;
  request.scene.wavelength = 281.645;
  request.preload.load = 0.89;
  request.mesh.tolerance = 1e-4;
  request.range = PO_RANGE_EXACT;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_double_eq_tol(o.pull_off.force, 5.2293557, 1e-7 + o.pull_off.force_error);
  po_result_clear(&o);
}
